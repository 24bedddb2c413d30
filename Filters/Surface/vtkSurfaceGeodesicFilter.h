// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceGeodesicFilter
 * @brief Base of the filters on a surface: it reads the surface, its cost and its barriers.
 *
 * Input port SURFACE_PORT takes the surface: the triangles, polygons and strips of a vtkPolyData,
 * the outer surface of any other vtkDataSet, or a vtkDataObjectTree of such blocks (multiblock,
 * partitioned data sets and collections of them), which together are one surface. Port
 * BARRIER_SOURCE_PORT, which is optional, takes lines that no path crosses.
 *
 * The front treats points with equal global ids (the attribute GlobalIds of the point data, or an
 * array GlobalPointIds) as one point, if all blocks have such ids. Otherwise it treats points with
 * equal coordinates as one point, if MergeCoincidentPoints is on. ConnectBlocks tells whether this
 * holds for points of different blocks. Point ids in properties are those of the data set, also for
 * a grid; if several blocks have faces, they are global ids.
 *
 * A request that can't be served gives one error and an empty output, but RequestData() still
 * returns 1: after a failed request ParaView would no longer update the view. Composite inputs
 * whose blocks overlap (AMR) can't be served. On several ranks (those of the global controller) an
 * error on one rank is an error on all, with the same message.
 */
#ifndef vtkSurfaceGeodesicFilter_h
#define vtkSurfaceGeodesicFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro

#include <cstddef> // For std::size_t
#include <memory>  // For members
#include <string>  // For members
#include <vector>  // For members

class vtkAlgorithmOutput;

namespace geodesic
{
struct SolverTraits;
class ThreadTeam;
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

  /** Numbers of solvers, as the table of solvers in Core has them. */
  enum Methods
  {
    FAST_MARCHING = 0,
    DIJKSTRA = 1,
    EXACT = 2,
    VIRTUAL_SOURCES = 3,
    BOUNDED = 4
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
   * A data set with lines that no path crosses. They are projected to the surface and joined over
   * it; no path enters points of the surface that are on them. Optional.
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
   * FAST_MARCHING measures across the faces. DIJKSTRA measures along the edges only, so its
   * distances are never too short. EXACT gives the shortest distance over the triangles, right to
   * rounding; BOUNDED is never smaller than that, and larger by Tolerance at most, and much faster;
   * VIRTUAL_SOURCES has smaller errors than FAST_MARCHING, above all on thin triangles, but
   * promises none. These three need points as seeds, no costs, and one rank. Default:
   * FAST_MARCHING. A number that no solver has is an error when the filter runs, which names those
   * there are; see geodesic::solverTable().
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * How much larger than the exact one a distance of BOUNDED may be, in parts of that distance.
   * Other methods have no use for it. Above 0, else the run ends with an error. Default: 1e-3.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The most memory that EXACT and BOUNDED may take beside the surface, in gigabytes (1e9 bytes); a
   * run that needs more ends with an error that says how far it came. 0: three quarters of the
   * machine's. Other methods don't look at it. At least 0, else the run ends with an error.
   * Default: 0.
   */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * On: the front treats points of equal coordinates as one point, so that it crosses the seams of
   * STL files, CAD models and pieces. Each point keeps its own tuple. Off: a slit stays a slit. If
   * there are global ids, they decide instead. Default: on.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * On: blocks that share points are one surface; it is an error if neither global ids nor
   * MergeCoincidentPoints tell which points they share. Off: each block is a surface of its own.
   * Default: on.
   */
  vtkSetMacro(ConnectBlocks, bool);
  vtkGetMacro(ConnectBlocks, bool);
  vtkBooleanMacro(ConnectBlocks, bool);
  ///@}

  ///@{
  /**
   * How many threads a run may use on each rank. -1: as many as VTK uses (see vtkSMPTools), one
   * with its backend Sequential, and no more than 0 gives. 0: all processors; ranks on one machine
   * share them. A number from 1 to 1024: so many. Threads share searches that do not depend on each
   * other: the segments and starts of paths, the landmarks of a matrix, samples far apart.
   * Distances by FastMarching on a whole surface are computed on one thread for each 65,536 points
   * at most; with -1 also on no more than there are idle processors, and on one where they go over
   * many thin triangles. What they find does not depend on their number (distances to 1e-9).
   * The structure of a new surface is built by all processors unless this is 1 or more. Other
   * numbers are an error when the filter runs. Default: -1.
   */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /**
   * What was wrong with the last run, in full sentences; empty if nothing was.
   */
  const char* GetErrorText();
  /**
   * How long the last run took, in seconds; 0 before the first.
   */
  vtkGetMacro(RunTime, double);

protected:
  vtkSurfaceGeodesicFilter();
  ~vtkSurfaceGeodesicFilter() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /** Fills the output, or throws. An aborted run leaves the output unchanged. */
  virtual void Compute(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks, vtkInformationVector** inputVector,
    vtkDataObject* output) = 0;
  /** Appends the settings, which must be the same on all ranks, as numbers. */
  virtual void DescribeRequest(std::vector<double>& numbers);
  /** Drops the state that is kept from run to run. Called after an error. */
  virtual void Forget() = 0;

  /** Reports an error of this run. */
  void Report(const std::string& message);

  /** Makes the output of a port an object of the given class, unless it is one already. */
  static void SetOutputClass(
    vtkInformationVector* outputVector, const char* className, int port = 0);
  /** Returns the array chosen by SetInputArrayToProcess(). Throws if it does not exist. */
  geodesic::bridge::ChosenArray GetChosenArray(
    int number, const geodesic::bridge::InputBlocks& blocks);
  /**
   * Reads BARRIER_ARRAY and the cost of each vertex (empty if it is 1 everywhere). Both are the
   * same on all ranks that share a vertex. Collective.
   */
  void GatherCostAndBarriers(geodesic::distributed::RankGroup& ranks,
    const geodesic::bridge::InputBlocks& blocks,
    const geodesic::distributed::DistributedSurface& surface, geodesic::bridge::Barriers& barriers,
    std::vector<double>& cost);
  /** Returns the surface of which the input is this rank's piece. Collective. */
  std::shared_ptr<const geodesic::distributed::DistributedSurface> FindSurface(
    geodesic::distributed::RankGroup& ranks, const geodesic::bridge::InputBlocks& blocks) const;
  /** What the solver that Method chooses can do, and how it is made. */
  const geodesic::SolverTraits& GetSolver() const;
  /** Whether the method that Method chooses can't work on these ranks together. */
  bool NeedsOneOf(const geodesic::distributed::RankGroup& ranks) const;
  /** Tolerance. Throws if it is none. */
  double GetCheckedTolerance() const;
  /** MemoryLimit in bytes. Throws if it is no limit. */
  std::size_t GetMemoryLimitInBytes() const;
  /** The number of threads of this rank that a run uses. Collective. */
  std::size_t GetThreadsOfRun(geodesic::distributed::RankGroup& ranks) const;
  /** These threads, for loops. Collective. */
  geodesic::ThreadTeam GetTeamOfRun(geodesic::distributed::RankGroup& ranks) const;
  /** The number of threads of this rank that share one field. Collective. @param areManyThin
   * whether many triangles are thin */
  std::size_t GetThreadsOfField(geodesic::distributed::RankGroup& ranks, bool areManyThin) const;

  int CostMode = COST;
  int Method = FAST_MARCHING;
  double Tolerance = 1e-3;
  double MemoryLimit = 0.0;
  int NumberOfThreads = -1;
  bool MergeCoincidentPoints = true;
  bool ConnectBlocks = true;

  double RunTime = 0.0;
  std::string ErrorText;

private:
  /** What the ranks do together. Throws the same error on all. */
  void RunOnAll(geodesic::distributed::RankGroup& ranks, vtkInformationVector** inputVector,
    vtkDataObject* output);
  /** Throws if NumberOfThreads is none. */
  void CheckNumberOfThreads() const;
  void GatherBarriers(const geodesic::bridge::InputBlocks& blocks,
    const geodesic::bridge::InputSurface& surface, geodesic::bridge::Barriers& barriers);
  std::vector<double> GatherCost(
    const geodesic::bridge::InputBlocks& blocks, const geodesic::bridge::InputSurface& surface);

  vtkSurfaceGeodesicFilter(const vtkSurfaceGeodesicFilter&) = delete;
  void operator=(const vtkSurfaceGeodesicFilter&) = delete;
};

#endif
