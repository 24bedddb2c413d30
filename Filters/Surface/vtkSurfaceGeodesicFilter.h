// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicFilter
 * @brief What the filters on a surface have in common: the surface, its cost and its barriers.
 *
 * Input port SURFACE_PORT takes the surface (triangles, polygons and strips of a vtkPolyData), port
 * BARRIER_SOURCE_PORT, optional, lines that no way crosses.
 *
 * A request that can't be served ends in one error and an empty output, and yet succeeds: after a
 * request that failed ParaView no longer updates the view, and what it shows is stale. Composite
 * inputs are such requests.
 */
#ifndef vtkSurfaceGeodesicFilter_h
#define vtkSurfaceGeodesicFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro

#include <memory> // For members
#include <vector> // For members

class vtkAlgorithmOutput;
class vtkDataArray;
class vtkPointSet;
class vtkPolyData;

namespace geodesic
{
class DistanceSolver;
class TriangleMesh;
namespace bridge
{
class InputSurface;
struct Barriers;
}
namespace distributed
{
class DistributedSurface;
class RankGroup;
}
}

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfaceGeodesicFilter : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceGeodesicFilter, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    FAST_MARCHING,
    DIJKSTRA
  };

  enum CostModes
  {
    COST,
    SPEED
  };

  /** Numbers of the arrays for SetInputArrayToProcess; SEED_ARRAY is used for distances only. */
  enum Arrays
  {
    SEED_ARRAY,
    COST_ARRAY,
    BARRIER_ARRAY
  };

  /** Input ports that all filters have. */
  enum Ports
  {
    SURFACE_PORT = 0,
    BARRIER_SOURCE_PORT = 2
  };

  ///@{
  /**
   * A data set whose lines, projected to the surface and joined over it, no way crosses. Points of
   * the surface on them are not entered. Optional.
   */
  void SetBarrierSourceConnection(vtkAlgorithmOutput* source);
  ///@}

  ///@{
  /**
   * What COST_ARRAY holds: the cost of a unit of length, or the speed, whose inverse is the cost.
   * Default: COST.
   */
  vtkSetClampMacro(CostMode, int, COST, SPEED);
  vtkGetMacro(CostMode, int);
  ///@}

  ///@{
  /**
   * FAST_MARCHING: across the faces. DIJKSTRA: along the edges only, so never too short. Default:
   * FAST_MARCHING.
   */
  vtkSetClampMacro(Method, int, FAST_MARCHING, DIJKSTRA);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * On: points of equal coordinates are one point to the front, so that STL files, CAD seams and
   * pieces behave alike; each keeps its tuple. Off: a slit stays a slit. Default: on.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

protected:
  vtkSurfaceGeodesicFilter();
  ~vtkSurfaceGeodesicFilter() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /** Fills the output, or throws; an aborted run leaves it as it is. */
  virtual void Compute(vtkInformationVector** inputVector, vtkPolyData* output) = 0;
  /** Drops what is kept from run to run, after an error. */
  virtual void Forget() = 0;

  vtkPolyData* GetSurface(vtkInformationVector** inputVector);
  /** The data set on an optional port, null where there is none; throws for several blocks. */
  static vtkPointSet* GetOptionalPointSet(vtkInformationVector* inputVector, const char* property);
  /** The array chosen by SetInputArrayToProcess, null for none; throws where there is no such
   * array. */
  vtkDataArray* GetChosenArray(int number, vtkInformationVector** inputVector, bool& isOfCells);
  /** BARRIER_ARRAY and the lines of BarrierSource. */
  void GatherBarriers(vtkInformationVector** inputVector,
    const geodesic::bridge::InputSurface& surface, geodesic::bridge::Barriers& barriers);
  /** The cost of each vertex; empty: 1. */
  std::vector<double> GatherCost(
    vtkInformationVector** inputVector, const geodesic::bridge::InputSurface& surface);
  std::shared_ptr<const geodesic::bridge::InputSurface> FindSurface(vtkPolyData* input);
  /** The surface of which the input is this rank's piece. */
  std::shared_ptr<const geodesic::distributed::DistributedSurface> FindDistributedSurface(
    vtkPolyData* input, geodesic::distributed::RankGroup& ranks);
  std::unique_ptr<geodesic::DistanceSolver> MakeSolver(
    const std::shared_ptr<const geodesic::TriangleMesh>& mesh);

  int CostMode = COST;
  int Method = FAST_MARCHING;
  bool MergeCoincidentPoints = true;

private:
  vtkSurfaceGeodesicFilter(const vtkSurfaceGeodesicFilter&) = delete;
  void operator=(const vtkSurfaceGeodesicFilter&) = delete;
};

#endif
