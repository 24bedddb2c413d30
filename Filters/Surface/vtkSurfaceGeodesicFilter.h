// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicFilter
 * @brief What the filters on a surface have in common: the surface, its cost and its barriers.
 *
 * Input port SURFACE_PORT takes the surface: the triangles, polygons and strips of a vtkPolyData,
 * the outer surface of any other vtkDataSet, or a vtkDataObjectTree of such blocks (multiblock,
 * partitioned data sets and collections of them), which together are one surface. Port
 * BARRIER_SOURCE_PORT, optional, takes lines that no way crosses.
 *
 * Points that are one to the front: those of equal global ids (the attribute GlobalIds of the point
 * data, or an array GlobalPointIds) where all blocks have such ids; otherwise those of equal
 * coordinates, with MergeCoincidentPoints. ConnectBlocks tells whether this holds for points of
 * different blocks. Point ids in properties are those of the data set, of a grid too; where
 * several blocks have faces they are global ids.
 *
 * A request that can't be served ends in one error and an empty output, and yet succeeds: after a
 * request that failed ParaView no longer updates the view, and what it shows is stale. Composite
 * inputs whose blocks overlap (AMR) are such requests. On several ranks (those of the global
 * controller) an error on one is one on all, with the same message.
 */
#ifndef vtkSurfaceGeodesicFilter_h
#define vtkSurfaceGeodesicFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro

#include <memory> // For members
#include <vector> // For members

class vtkAlgorithmOutput;

namespace geodesic
{
class DistanceSolver;
class TriangleMesh;
namespace bridge
{
class InputBlocks;
class InputSurface;
struct Barriers;
struct ChosenArray;
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
   * pieces behave alike; each keeps its tuple. Off: a slit stays a slit. Where there are global
   * ids, those decide. Default: on.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * On: blocks that share points are one surface; it is an error where neither global ids nor
   * MergeCoincidentPoints tell which points they share. Off: each block is apart. Default: on.
   */
  vtkSetMacro(ConnectBlocks, bool);
  vtkGetMacro(ConnectBlocks, bool);
  vtkBooleanMacro(ConnectBlocks, bool);
  ///@}

protected:
  vtkSurfaceGeodesicFilter();
  ~vtkSurfaceGeodesicFilter() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /** Fills the output, or throws; an aborted run leaves it as it is. */
  virtual void Compute(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** inputVector,
    vtkDataObject* output) = 0;
  /** Appends what is set, which must be the same on all ranks, as numbers. */
  virtual void DescribeRequest(std::vector<double>& numbers);
  /** Drops what is kept from run to run, after an error. */
  virtual void Forget() = 0;

  /** Makes the output an object of a class, unless it is one. */
  static void SetOutputClass(vtkInformationVector* outputVector, const char* className);
  /** The array chosen by SetInputArrayToProcess; throws where there is no such array. */
  geodesic::bridge::ChosenArray GetChosenArray(
    int number, const geodesic::bridge::InputBlocks& blocks);
  /**
   * BARRIER_ARRAY and the cost of each vertex (empty: 1), the same on all ranks where they share
   * vertices. Collective.
   */
  void GatherCostAndBarriers(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks,
    const geodesic::distributed::DistributedSurface& surface, geodesic::bridge::Barriers& barriers,
    std::vector<double>& cost);
  /** The surface of which the input is this rank's piece. */
  std::shared_ptr<const geodesic::distributed::DistributedSurface> FindSurface(
    geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks) const;
  std::unique_ptr<geodesic::DistanceSolver> MakeSolver(
    const std::shared_ptr<const geodesic::TriangleMesh>& mesh);

  int CostMode = COST;
  int Method = FAST_MARCHING;
  bool MergeCoincidentPoints = true;
  bool ConnectBlocks = true;

private:
  void GatherBarriers(const geodesic::bridge::InputBlocks& blocks,
    const geodesic::bridge::InputSurface& surface, geodesic::bridge::Barriers& barriers);
  std::vector<double> GatherCost(
    const geodesic::bridge::InputBlocks& blocks, const geodesic::bridge::InputSurface& surface);

  vtkSurfaceGeodesicFilter(const vtkSurfaceGeodesicFilter&) = delete;
  void operator=(const vtkSurfaceGeodesicFilter&) = delete;
};

#endif
