// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicIsolines
 * @brief Curves of constant distance, exact inside of faces.
 *
 * The filter behind ParaView's proxy GeodesicIsolines. The input is a surface with a point array of
 * distances, as vtkSurfaceGeodesicDistance makes it, signed or not. The output has a polyline for
 * each curve, closed ones with their first point again at the end, by increasing distance. Inside
 * of faces they follow the distance from a point or a straight front, whichever fits the values at
 * the corners, and not the linear interpolation; see geodesic::isolines().
 *
 * Cell arrays: the distance, under the input array's name; Length; and EnclosedArea, the area of
 * the connected part of the surface beside the curve that is nearer, on the minus side of a signed
 * distance too. Curves end at the surface's border, where points have no distance, and where three
 * or more faces meet at an edge. Points have no distance if it is NaN or infinite, or -1 in an
 * array without other negative values. The array is input array 0; without a name it is
 * GeodesicDistance, or the active scalars where no block has that.
 *
 * Input array 1 is the point array of the cost that the distances were measured with. Without one,
 * named None or not at all, it is the one that vtkSurfaceGeodesicDistance noted on the array of
 * distances (COST_ARRAY_NAME); where it noted none, the cost is 1.
 *
 * A request that can't be served gives one error and an empty output, but RequestData() returns 1:
 * after a failed request ParaView would no longer update the view. The surface must be on one rank;
 * other ranks may have no part of it.
 */
#ifndef vtkSurfaceGeodesicIsolines_h
#define vtkSurfaceGeodesicIsolines_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro

#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class vtkPolyData;

namespace geodesic
{
namespace bridge
{
class InputBlocks;
class InputSurface;
}
namespace distributed
{
class RankGroup;
}
}

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicIsolines : public vtkDataObjectAlgorithm
{
public:
  static vtkSurfaceGeodesicIsolines* New();
  vtkTypeMacro(vtkSurfaceGeodesicIsolines, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InputArrays
  {
    DISTANCE_ARRAY,
    COST_ARRAY
  };
  enum CostModes
  {
    COST,
    SPEED
  };

  ///@{
  /**
   * Whether input array 1, if it is chosen, holds the cost of a unit of length or its inverse, the
   * speed. Default: COST.
   */
  vtkSetClampMacro(CostMode, int, COST, SPEED);
  vtkGetMacro(CostMode, int);
  ///@}

  /** The most values that NumberOfValues can ask for. */
  static constexpr int MostValues = 1000000;

  ///@{
  /**
   * The distances of the curves. Their order does not matter, and equal ones count once. If there
   * are none, NumberOfValues counts. Default: none.
   */
  void ClearValues();
  void AddValue(double value);
  ///@}

  ///@{
  /**
   * How many distances, if Values is empty: they part the range from 0, or from the least distance
   * of a signed array, to the largest one into equal steps, without the ends. 1 to MostValues.
   * Default: 10.
   */
  vtkSetMacro(NumberOfValues, int);
  vtkGetMacro(NumberOfValues, int);
  ///@}

  ///@{
  /**
   * On: points of equal coordinates are one, so that curves go on across seams; global ids decide
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

  /**
   * What was wrong with the last run, in full sentences; empty if nothing was.
   */
  const char* GetErrorText();

protected:
  vtkSurfaceGeodesicIsolines();
  ~vtkSurfaceGeodesicIsolines() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<double> Values;
  int CostMode = COST;
  int NumberOfValues = 10;
  bool MergeCoincidentPoints = true;
  bool ConnectBlocks = true;
  std::string ErrorText;

private:
  struct Internals;

  /** What the ranks do together. Throws the same error on all. */
  void RunOnAll(geodesic::distributed::RankGroup& ranks, vtkInformationVector** inputVector,
    vtkPolyData* output);
  /** Traces the curves on a surface of which all is on this rank. */
  void Trace(const geodesic::bridge::InputBlocks& blocks, vtkPolyData* output);
  /** The cost at each vertex; empty if it is 1. @param distances the name of their array */
  std::vector<double> CostOf(const geodesic::bridge::InputBlocks& blocks,
    const geodesic::bridge::InputSurface& surface, const std::string& distances);
  /** The levels in increasing order, all different. */
  std::vector<double> LevelsOf(const std::vector<double>& distances, bool isSigned) const;

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicIsolines(const vtkSurfaceGeodesicIsolines&) = delete;
  void operator=(const vtkSurfaceGeodesicIsolines&) = delete;
};

#endif
