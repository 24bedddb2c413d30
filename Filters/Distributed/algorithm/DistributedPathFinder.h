// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DistributedPathFinder_h
#define geodesic_distributed_DistributedPathFinder_h

#include "algorithm/DistributedSolver.h"
#include "algorithm/PathScout.h"
#include "gather/Corridor.h"
#include "gather/CorridorMesh.h"
#include "gather/InputCutter.h"
#include "gather/PatchCutter.h"
#include "global/GlobalPoints.h"
#include "path/PathFinder.h"
#include "ranks/RankGroup.h"
#include "solve/DijkstraSolver.h"
#include "solve/DistanceSolver.h"

#include <cstddef>
#include <cstdint>
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
class WholeSurface;

/** The surface and the options of a search for paths. Each rank gives those of its piece. */
struct PathRequest
{
  RankGroup& ranks;
  const DistributedSurface& surface;
  /**
   * The surface with moved triangles, if there are several ranks and lines, and the first rank's
   * split mesh; otherwise null.
   */
  const GatheredSurface* gathered;
  const SplitMesh* split;
  /** The mesh that is solved on, if there are several ranks. */
  const DividedMesh& mesh;
  /** The local solver. On several ranks it must be a solver of the mesh above. */
  DistanceSolver& solver;
  /** Cost, barriers, progress. */
  SolveOptions options;
  PathStyle style;
  /** This rank's piece with the attributes of the input. */
  const bridge::PathAttributes& input;
  /** If there are several ranks and the method needs the surface in one piece; otherwise null. */
  const WholeSurface* whole = nullptr;
};

/** A path to one of the end points. */
struct TracedPath
{
  /**
   * The path on the solver's mesh or, if there is one, on the corridor. Empty on all ranks but the
   * first.
   */
  SurfacePath path;
  /** On the first of several ranks, the surface along the path; otherwise null. */
  std::shared_ptr<const CorridorMesh> corridor;
  /** The number of the end point. */
  Index end = NoIndex;
  /** The path's cost, its length if there are no costs; 0 on all ranks but the first. */
  double cost = 0.0;
  /** Whether no other path is shorter; see PathFinder::isProvenShortest(). */
  bool isProvenShortest = false;
};

/**
 * Finds shortest paths to the nearest of several end points, on a surface whose pieces are on any
 * number of ranks. PathFinder does the same on one rank.
 *
 * All ranks solve the field together. The first rank then finds the path, by a PathFinder on a
 * corridor of the surface, to which all ranks send their triangles in balls along the path (see
 * PathScout). If the PathFinder needs triangles that the corridor does not have (see
 * IncompleteRing), they send those in balls there, and the search begins again. The other ranks
 * follow the first rank's orders until it is done. So the first rank holds its piece and O(length
 * of the path) triangles, however the surface was cut into pieces; of several paths at once at most
 * as many points as a piece has, beside those round the starts and ends.
 *
 * Methods that need the surface in one piece work on a WholeSurface instead of a corridor, on the
 * first rank alone.
 *
 * A shortest path along edges can lie far from where a field that crosses faces is least, and a
 * corridor with all places where it may lie would be as wide as long. So its field is solved along
 * edges by all ranks.
 *
 * All calls are collective; all ranks must pass the same points.
 */
class DistributedPathFinder
{
public:
  /**
   * @param ends the points where paths may end, at least one. These points, and all points passed
   *             later, must refer to the solver's mesh (see restate())
   */
  DistributedPathFinder(const PathRequest& request, std::vector<GlobalPoint> ends);

  /** See PathFinder::march(). */
  bool march(std::span<const GlobalPoint> starts);
  /** See PathFinder::pathFrom(). Returns none as well if the search was cancelled. */
  std::optional<TracedPath> pathFrom(const GlobalPoint& start);
  /** The same from several starts. On several ranks this takes far less than one after the other,
   * most of all if they are near each other. */
  std::vector<std::optional<TracedPath>> pathsFrom(std::span<const GlobalPoint> starts);

  /** See PathFinder::nearestSeed(). @pre there is one rank */
  Index nearestEndOnOneRank(const GlobalPoint& start) const
  {
    return this->Whole->nearestSeed(start.local.front());
  }
  /** The field that the last march made. @pre there is one rank */
  const DistanceField& fieldOfOneRank() const { return this->Whole->field(); }
  /** The number of points of the largest corridor so far; 0 on all ranks but the first. */
  std::size_t largestCorridor() const { return this->LargestCorridor; }

private:
  class CorridorSolver;
  /** What the first rank tells the others of a search. */
  struct Answer
  {
    /** The number of the end; NoIndex if there is none. Of a march, 0 if it was not cancelled. */
    Index end = NoIndex;
    std::uint32_t isProvenShortest = 0;
  };
  using Answers = std::vector<Answer>;
  using CorridorPointer = std::shared_ptr<const CorridorMesh>;
  /**
   * What the first rank does with a path finder on the corridor.
   * @return the vertices without which it could not do all; then it is called again
   */
  using Attempt = std::function<std::vector<PatchVertex>(PathFinder&, const CorridorPointer&)>;

  enum class Order : char
  {
    /** March to vertices. The content is a list of GlobalVertex; an empty one means everywhere. */
    Solve,
    /** Send the triangles in balls. The content is a list of Ball. */
    Cut,
    /** Send the input's triangles at vertices. The content is a list of GlobalVertex. */
    CutInput,
    /** Stop. The content is the answer. */
    Done
  };

  /** Runs an action on the first rank, whose orders the others follow. Returns its answers. */
  Answers askFirst(const std::function<Answers()>& action);
  Answers followOrders();
  /**
   * Carries out one order of the first rank.
   * @pre the order is Solve, Cut or CutInput
   */
  void carryOut(Order order, const RankGroup::Message& content);
  void sendOrder(Order order, const RankGroup::Message& content);

  /** Returns paths along edges to the nearest ends, which the field tells if there are several. */
  std::vector<std::optional<TracedPath>> pathsAlongEdgesFrom(std::span<const GlobalPoint> starts);
  /** Whether a search for each start, see PiecewisePaths, takes less than a field for each end. */
  bool mayGoPiecewise(std::size_t starts) const;
  /** Finds paths along edges whose ends are known, as far as that is possible piece by piece. */
  void findPiecewise(std::span<const GlobalPoint> starts, const Answers& answers,
    std::span<std::optional<TracedPath>> paths, std::vector<bool>& areKnown);

  // On the first rank.
  Answers leadMarch(std::span<const GlobalPoint> starts);
  Answers leadToNearest(std::span<const GlobalPoint> starts);
  Answers leadPaths(std::span<const GlobalPoint> starts, std::span<TracedPath> traced);
  /** Finds as many of the first of these paths as fit into a corridor. @return their answers */
  Answers leadSomePaths(std::span<const GlobalPoint> starts, std::span<TracedPath> traced);
  /** Finds those of the paths for which the corridor is large enough. @param isPending  whether a
   * path is still to be found */
  std::vector<PatchVertex> tracePaths(std::span<const GlobalPoint> starts, PathFinder& finder,
    const CorridorPointer& corridor, std::vector<bool>& isPending, Answers& answers,
    std::span<TracedPath> traced);
  /** Calls @p attempt until it lacks nothing. Between the calls the corridor grows. */
  void onCorridor(const Attempt& attempt);
  /** Takes the corridor at the end points alone where it has grown too large for other paths. */
  void shrinkCorridor();
  /** The number of points that a corridor of several paths may have. */
  std::size_t mostPointsOfCorridor() const;
  PathScout scout();

  /** Has all ranks cut the triangles in some balls. */
  std::vector<SurfacePatch> orderCut(std::span<const Ball> balls);
  /** Adds all triangles in some balls to the corridor. */
  void extend(std::span<const Ball> balls);
  std::vector<SurfacePatch> cutOnAll(std::span<const Ball> balls);
  /** Converts paths on a corridor to such on the input's surface. */
  void takeToInput(std::span<TracedPath*> paths, const CorridorMesh& corridor);
  /**
   * Makes the field reach vertices, or all vertices if there are no targets.
   * @return whether the field was solved again for that
   */
  bool reach(const std::vector<GlobalVertex>& targets);
  void solve(std::span<const GlobalVertex> targets);

  PathRequest Request;
  std::vector<GlobalPoint> Ends;
  /** The path finder on the whole surface, if there is only one rank. */
  std::optional<PathFinder> Whole;
  /** The path finder on the request's whole surface, on the first rank. */
  std::optional<PathFinder> OnWhole;
  /** For paths along edges where request.solver crosses faces; otherwise null. */
  std::unique_ptr<DijkstraSolver> EdgeSolver;
  DistributedSolver Partition;
  std::optional<PatchCutter> Cutter;
  std::optional<InputCutter> OfInput;
  bool HasCost = false;
  /** The vertices that the field reaches, or is known to be unable to reach. */
  std::set<GlobalVertex> Reached;
  const DistanceField* Field = nullptr;
  /** On the first rank: the triangles at the end points, and along the paths found last. */
  std::optional<Corridor> Along;
  /** The number of its points at the end points alone. */
  std::size_t PointsAtEnds = 0;
  /** How many paths are likely to fit into it. */
  std::size_t Together;
  std::size_t LargestCorridor = 0;
};

}

#endif
