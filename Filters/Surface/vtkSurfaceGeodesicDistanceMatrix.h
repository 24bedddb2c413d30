// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicDistanceMatrix
 * @brief Lengths of the shortest paths over a surface between all pairs of landmarks.
 *
 * The filter behind ParaView's proxy GeodesicDistanceMatrix. Each landmark is projected to the
 * nearest point of the surface, on a face, an edge or a vertex.
 *
 * The output is a vtkTable with a row for each landmark. The column From has the landmark's number
 * from 0; the columns "To 0", "To 1" and so on have the lengths of the paths to each landmark, or
 * to each of a second set if there is one. Lengths are those of locally shortest paths; with the
 * method EXACT they are the shortest of all, with DIJKSTRA they are those of paths along edges. The
 * table of one set is symmetric, with 0 on the diagonal. A length is NaN where no path leads, for
 * example to another part of the surface. On several ranks, the first one has the table, and the
 * others have an empty one.
 *
 * Each landmark but the last marches once, as far as its paths need (with two sets: each of the
 * smaller one). Requests that can't be served empty the output: no landmark, positions and source
 * both set, a landmark on a barrier, a cost array, a table above MemoryLimit, and what
 * vtkSurfaceGeodesicFilter names.
 */
#ifndef vtkSurfaceGeodesicDistanceMatrix_h
#define vtkSurfaceGeodesicDistanceMatrix_h

#include "vtkSurfaceGeodesicFilter.h"

#include <memory> // For members
#include <vector> // For members

class vtkTable;

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicDistanceMatrix
  : public vtkSurfaceGeodesicFilter
{
public:
  static vtkSurfaceGeodesicDistanceMatrix* New();
  vtkTypeMacro(vtkSurfaceGeodesicDistanceMatrix, vtkSurfaceGeodesicFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Additional input ports, all optional. */
  enum LandmarkPorts
  {
    LANDMARK_SOURCE_PORT = 1,
    SECOND_LANDMARK_SOURCE_PORT = 3,
    NUMBER_OF_PORTS
  };

  ///@{
  /**
   * The landmarks, x y z of each in turn, in the input's coordinates. Default: none.
   */
  void ClearLandmarkPositions();
  void AddLandmarkCoordinate(double coordinate);
  ///@}

  ///@{
  /**
   * The landmarks to which paths lead, if they are others than those above; else paths lead among
   * those. Default: none.
   */
  void ClearSecondLandmarkPositions();
  void AddSecondLandmarkCoordinate(double coordinate);
  ///@}

  ///@{
  /**
   * Data sets whose points are the landmarks of a set, in their order. Each replaces the positions;
   * setting both is an error. Optional.
   */
  void SetLandmarkSourceConnection(vtkAlgorithmOutput* source);
  void SetSecondLandmarkSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  /**
   * How many pairs of landmarks no path joins in the last run.
   */
  vtkGetMacro(NumberOfUnjoinedPairs, vtkIdType);

protected:
  vtkSurfaceGeodesicDistanceMatrix();
  ~vtkSurfaceGeodesicDistanceMatrix() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Compute(geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks,
    vtkInformationVector** inputVector, vtkDataObject* output) override;
  void DescribeRequest(std::vector<double>& numbers) override;
  void Forget() override;

  std::vector<double> LandmarkCoordinates;
  std::vector<double> SecondLandmarkCoordinates;
  vtkIdType NumberOfUnjoinedPairs = 0;

private:
  struct Internals;
  struct Landmarks;

  /** Reads the landmarks, as points of the input's mesh. Collective. */
  Landmarks GatherLandmarks(
    geodesic::distributed::RankGroup& ranks, vtkInformationVector** inputVector) const;
  /** Throws if there is nothing to do, or too much. */
  void CheckLandmarks(const Landmarks& landmarks) const;
  /** Makes the points refer to the mesh that is solved on. Collective. */
  void Open(geodesic::distributed::RankGroup& ranks, Landmarks& landmarks) const;
  void WriteTable(const std::vector<double>& lengths, std::size_t numberOfColumns, vtkTable* table);

  std::unique_ptr<Internals> Internal;

  vtkSurfaceGeodesicDistanceMatrix(const vtkSurfaceGeodesicDistanceMatrix&) = delete;
  void operator=(const vtkSurfaceGeodesicDistanceMatrix&) = delete;
};

#endif
