// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicRegion
 * @brief Cuts a surface along lines on it, and tells the regions between them apart.
 *
 * The filter behind ParaView's proxy GeodesicRegion. Port SURFACE_PORT takes the surface, as
 * vtkSurfaceGeodesicFilter does; LINES_PORT, which is optional, the lines: polylines in any
 * position to each other, moved to the surface and joined over it. Two faces are of one region if
 * one gets from one to the other over edges that are on no line. Without lines each component is a
 * region.
 *
 * The output is the surface, in the structure of the input. Faces that a line cuts are triangles
 * whose edges run exactly along the line, and both sides share the points there; a line that ends
 * inside the surface is cut in as well, and separates nothing. All other cells stay as they are.
 * Cell arrays: RegionArrayName, the region's number, -1 for cells that are no faces; and
 * vtkOriginalCellIds. Regions are numbered by area, the largest first, but the one with the first
 * inside position is 0. Point array: vtkOriginalPointIds, -1 at new points. Field arrays:
 * RegionArea and RegionPerimeter, by region; the perimeter is the length of the border with other
 * regions and of the surface's border.
 *
 * New points have interpolated values of arrays of real numbers, and of other arrays those of the
 * nearest corner. See geodesic::bridge::RegionOutput.
 *
 * Lines that separate nothing are a warning that names them. A request that can't be served gives
 * one error and an empty output, but RequestData() returns 1: after a failed request ParaView would
 * no longer update the view.
 *
 * On several ranks each one cuts its piece of the surface. The lines of all ranks count. Numbers,
 * areas and perimeters are those of the whole surface, and the points that the ranks beside a cut
 * both add have the same position, and the same global id if the input has any.
 */
#ifndef vtkSurfaceGeodesicRegion_h
#define vtkSurfaceGeodesicRegion_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro
#include "vtkNew.h"                           // For members

#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class vtkAlgorithmOutput;
class vtkDoubleArray;

namespace geodesic
{
class RegionCut;
namespace bridge
{
class InputBlocks;
}
namespace distributed
{
class RankGroup;
}
}

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicRegion : public vtkDataObjectAlgorithm
{
public:
  static vtkSurfaceGeodesicRegion* New();
  vtkTypeMacro(vtkSurfaceGeodesicRegion, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    SURFACE_PORT,
    LINES_PORT,
    NUMBER_OF_PORTS
  };

  enum Extracts
  {
    EXTRACT_ALL,
    EXTRACT_INSIDE,
    EXTRACT_OUTSIDE
  };

  ///@{
  /**
   * A data set with the lines, for example of vtkSurfaceGeodesicPath. Optional.
   */
  void SetLinesConnection(vtkAlgorithmOutput* lines);
  ///@}

  ///@{
  /**
   * Positions inside, x y z of each in turn, in the input's coordinates: what is inside is the
   * regions that hold the nearest points of the surface. None of these may lie on a line between
   * regions. Default: none.
   */
  void ClearInsidePositions();
  void AddInsideCoordinate(double coordinate);
  ///@}

  ///@{
  /**
   * Which regions the output has: all, those with an inside position, or the others. The last two
   * need an inside position. Default: EXTRACT_ALL.
   */
  vtkSetClampMacro(Extract, int, EXTRACT_ALL, EXTRACT_OUTSIDE);
  vtkGetMacro(Extract, int);
  ///@}

  ///@{
  /**
   * The name of the cell array with the regions' numbers; an input array of that name is replaced.
   * Null or empty: no array is made. Default: GeodesicRegion.
   */
  void SetRegionArrayName(const char* name);
  const char* GetRegionArrayName();
  ///@}

  ///@{
  /**
   * On: points of equal coordinates are one, so that regions go on across seams; global ids decide
   * where there are any. Default: on.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * On: blocks that share points are one surface. Off: each block is one of its own. Default: on.
   */
  vtkSetMacro(ConnectBlocks, bool);
  vtkGetMacro(ConnectBlocks, bool);
  vtkBooleanMacro(ConnectBlocks, bool);
  ///@}

  ///@{
  /**
   * How many regions the last run found, and the area and the perimeter of each, also of those that
   * are not extracted. 0 and empty before the first run and after an error.
   */
  vtkIdType GetNumberOfRegions();
  vtkDoubleArray* GetRegionAreas();
  vtkDoubleArray* GetRegionPerimeters();
  ///@}

  /**
   * What was wrong with the last run, in full sentences, its warning too; empty if nothing was.
   */
  const char* GetErrorText();
  /**
   * How long the last run took, in seconds; 0 before the first.
   */
  vtkGetMacro(RunTime, double);

protected:
  vtkSurfaceGeodesicRegion();
  ~vtkSurfaceGeodesicRegion() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<double> InsideCoordinates;
  int Extract = EXTRACT_ALL;
  std::string RegionArrayName = "GeodesicRegion";
  bool MergeCoincidentPoints = true;
  bool ConnectBlocks = true;
  vtkNew<vtkDoubleArray> RegionAreas;
  vtkNew<vtkDoubleArray> RegionPerimeters;
  std::string ErrorText;
  double RunTime = 0.0;

private:
  struct Internals;

  /** What the ranks do together. Throws the same error on all. */
  void RunOnAll(geodesic::distributed::RankGroup& ranks, vtkInformationVector** inputVector,
    vtkDataObject* output);
  /** Reports the progress. @return false if the run is to stop */
  bool GoesOn(double progress);
  /** Cuts the surface along the lines of a source; there is only one rank. */
  void CutWhole(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks, vtkDataObject* source, vtkDataObject* input,
    vtkDataObject* output);
  /** Cuts this rank's piece along the lines of all ranks' sources. */
  void CutPiece(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks, vtkDataObject* source, vtkDataObject* input,
    vtkDataObject* output);
  /** Numbers the regions by the inside positions, and fills the output. */
  void Write(geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks,
    geodesic::RegionCut& cut, vtkDataObject* input, vtkDataObject* output);
  /** Warns with a message if there is any. */
  void Warn(const std::string& message);

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicRegion(const vtkSurfaceGeodesicRegion&) = delete;
  void operator=(const vtkSurfaceGeodesicRegion&) = delete;
};

#endif
