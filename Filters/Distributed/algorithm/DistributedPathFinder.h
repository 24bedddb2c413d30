// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DistributedPathFinder_h
#define geodesic_distributed_DistributedPathFinder_h

#include "algorithm/DistributedSolver.h"
#include "gather/Corridor.h"
#include "gather/CorridorMesh.h"
#include "gather/PatchCutter.h"
#include "global/GlobalPoints.h"
#include "path/PathFinder.h"
#include "ranks/RankGroup.h"
#include "solve/DistanceSolver.h"

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace geodesic
{
class SplitMesh;
}

namespace geodesic::distributed
{

class GatheredSurface;

/** What paths are sought on, by each rank for its piece. */
struct PathRequest
{
  RankGroup& ranks;
  const DistributedSurface& surface;
  /** What took the surface's place on several ranks, and how the first one split it; else null. */
  const GatheredSurface* gathered;
  const SplitMesh* split;
  /** What is solved on, on several ranks. */
  const DividedMesh& mesh;
  /** On one rank of any mesh, on several of this one. */
  DistanceSolver& solver;
  /** Cost, barriers, progress. */
  SolveOptions options;
  PathStyle style;
  /** The surface's piece, with what the input says of it. */
  const bridge::PathAttributes& input;
};

/** A path to one of the ends. */
struct TracedPath
{
  /** On the solver's mesh, or on the ground; empty on all ranks but the first. */
  SurfacePath path;
  /** Of several ranks, on the first: the surface round the path; else null. */
  std::shared_ptr<const CorridorMesh> corridor;
  /** The number of the end. */
  Index end = NoIndex;
};

/**
 * Finds shortest paths to the nearest of some points on a surface whose pieces are on any number of
 * ranks, as PathFinder does on one.
 *
 * All ranks solve the field together. The first one finds the path, by a PathFinder on a corridor
 * of the surface: where that needs triangles that the corridor does not have (see IncompleteRing),
 * all ranks send those in a ball there, and it begins again. The others do what the first one
 * orders until it is done. So the first rank holds its piece and O(length of the path) triangles,
 * however the surface was cut. All calls are collective, with the same points on all ranks.
 */
class DistributedPathFinder
{
public:
  /**
   * @param ends where paths end, at least one, as restated on the solver's mesh; so are all points
   *             given later
   */
  DistributedPathFinder(const PathRequest& request, std::vector<GlobalPoint> ends);

  /** See PathFinder::march. */
  bool march(std::span<const GlobalPoint> starts);
  /** See PathFinder::pathFrom; also none when cancelled. */
  std::optional<TracedPath> pathFrom(const GlobalPoint& start);

  /** The number of points on the rank that holds most, corridors included. */
  vtkIdType mostPointsOnARank();

private:
  class CorridorSolver;
  /** @return what is told to all ranks */
  using Action = std::function<Index(PathFinder&, const std::shared_ptr<const CorridorMesh>&)>;

  enum class Order : char
  {
    /** To march to vertices, GlobalVertex one after the other; none: everywhere. */
    Solve,
    /** To send what is in balls. */
    Cut,
    /** To send what is round points of the input, GlobalVertex one after the other. */
    CutInput,
    /** No more; and the answer. */
    Done,
    /** To throw this message. */
    Fail
  };

  /** Does something with a path finder on the first rank, on a corridor with some points. */
  Index onCorridor(std::span<const GlobalPoint> points, const Action& action);
  Index lead(std::span<const GlobalPoint> points, const Action& action);
  Index serve();
  /** @pre it is one to solve or to cut */
  void follow(Order order, const RankGroup::Message& content);
  void give(Order order, const RankGroup::Message& content);

  /** Adds all triangles in some balls to a corridor of the first rank. */
  void extend(Corridor& corridor, std::span<const Ball> balls);
  std::vector<SurfacePatch> cutOnAll(std::span<const Ball> balls);
  /** A path of a corridor on the input's surface. */
  void takeToInput(const SurfacePath& path, const CorridorMesh& corridor, TracedPath& traced);
  std::vector<SurfacePatch> cutInputOnAll(std::span<const GlobalVertex> vertices);
  /** Lets the field reach vertices, unless it does; none: all. */
  bool reach(const std::vector<GlobalVertex>& targets);
  void solve(std::span<const GlobalVertex> targets);

  PathRequest Request;
  std::vector<GlobalPoint> Ends;
  /** On one rank. */
  std::optional<PathFinder> Whole;
  DistributedSolver Partition;
  std::optional<PatchCutter> Cutter;
  std::optional<PatchCutter> InputCutter;
  bool HasCost = false;
  /** What the field is known to reach, or to have no way to. */
  std::set<GlobalVertex> Reached;
  const DistanceField* Field = nullptr;
  /** That of the ends alone. */
  std::optional<Corridor> FirstCorridor;
  std::size_t LargestCorridor = 0;
};

}

#endif
