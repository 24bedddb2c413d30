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
#include "solve/DijkstraSolver.h"
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
 * corridor of the surface. If the PathFinder needs triangles that the corridor does not have (see
 * IncompleteRing), all ranks send their triangles in a ball there, and the search begins again. The
 * other ranks follow the first rank's orders until it is done. So the first rank holds its piece
 * and O(length of the path) triangles, however the surface was cut into pieces.
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

  /** The field that the last march made. @pre there is one rank */
  const DistanceField& fieldOfOneRank() const { return this->Whole->field(); }
  /** The number of points of the largest corridor so far; 0 on all ranks but the first. */
  std::size_t largestCorridor() const { return this->LargestCorridor; }

private:
  class CorridorSolver;
  /**
   * What the first rank does with a path finder on a corridor.
   * @return the answer for all ranks
   */
  using Action = std::function<Index(PathFinder&, const std::shared_ptr<const CorridorMesh>&)>;

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

  /**
   * Runs an action on the first rank, with a path finder on a corridor that has the points, and
   * returns the action's answer on all ranks.
   */
  Index onCorridor(std::span<const GlobalPoint> points, const Action& action);
  Index lead(std::span<const GlobalPoint> points, const Action& action);
  Index followOrders();
  /**
   * Carries out one order of the first rank.
   * @pre the order is Solve, Cut or CutInput
   */
  void carryOut(Order order, const RankGroup::Message& content);
  void sendOrder(Order order, const RankGroup::Message& content);

  /** Returns the path along edges to the nearest end, which the field tells if there are several.
   */
  std::optional<TracedPath> pathAlongEdgesFrom(const GlobalPoint& start);

  /** Adds all triangles in some balls to a corridor of the first rank. */
  void extend(Corridor& corridor, std::span<const Ball> balls);
  std::vector<SurfacePatch> cutOnAll(std::span<const Ball> balls);
  /** Converts a path on a corridor to one on the input's surface. */
  void takeToInput(const SurfacePath& path, const CorridorMesh& corridor, TracedPath& traced);
  std::vector<SurfacePatch> cutInputOnAll(std::span<const GlobalVertex> vertices);
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
  std::optional<PatchCutter> InputCutter;
  bool HasCost = false;
  /** The vertices that the field reaches, or is known to be unable to reach. */
  std::set<GlobalVertex> Reached;
  const DistanceField* Field = nullptr;
  /** The corridor at the end points alone. */
  std::optional<Corridor> FirstCorridor;
  std::size_t LargestCorridor = 0;
};

}

#endif
