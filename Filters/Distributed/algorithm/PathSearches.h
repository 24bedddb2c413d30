// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_PathSearches_h
#define geodesic_distributed_PathSearches_h

#include "algorithm/DistributedPathFinder.h"
#include "algorithm/PiecewisePaths.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{
class SolverTeam;
}

namespace geodesic::distributed
{

/**
 * Searches for paths that do not depend on each other. On one rank threads share them, each with a
 * solver of its own; on several ranks all ranks make one after the other together. What a search
 * finds does not depend on the number of threads. Progress comes from the calling thread alone.
 */
class PathSearches
{
public:
  /** Whether a search must end. */
  using IsAborted = std::function<bool()>;
  /** Makes the search of a number. It may use what the request refers to, but no other solver. */
  using Search =
    std::function<void(std::size_t number, const PathRequest& request, const IsAborted& isAborted)>;

  /**
   * @param request    its solver is the first of @p solvers; its memory limit counts for all
   *                   threads together. It has progress to report
   * @param isAborted  asked on the calling thread, by all ranks together
   */
  PathSearches(const PathRequest& request, SolverTeam& solvers, IsAborted isAborted);

  const PathRequest& request() const { return this->Request; }

  /**
   * Makes searches number 0 to count - 1, each with marches of its own. Where windows take so much
   * memory that a search fails, it is made again alone.
   * @return for each search whether it was made; all were, unless they were aborted
   */
  std::vector<bool> run(std::size_t count, const Search& search);

  /**
   * Finds a path between two points, in a search of run(). Collective.
   * @param fromBothEnds  whether a path that is not proven to be the shortest is traced from the
   *                      other end as well, in the field of the first one, and the one that
   *                      costs less is kept; see costOf()
   * @return the path from @p from to @p to; none if none joins them
   */
  std::optional<TracedPath> between(
    const PathRequest& request, const GlobalPoint& from, const GlobalPoint& to, bool fromBothEnds);

  /** The outcome of a search. */
  struct Outcome
  {
    /** Whether the search was made, and not aborted. */
    bool isMade = false;
    /** None if there is no path. */
    std::optional<TracedPath> path;
  };

  /** Finds a path between the points of each pair, see between(). On several ranks many short ones
   * take far less than one after the other, see PiecewisePaths. */
  std::vector<Outcome> betweenAll(std::span<const PointPair> pairs, bool fromBothEnds);

  /** Finds paths from starts, each to the nearest of some ends, by one march for all. */
  std::vector<Outcome> fromStarts(
    std::span<const GlobalPoint> starts, const std::vector<GlobalPoint>& ends);

  /** Counts the corridor of a search's finder for mostPointsOnARank(). */
  void count(const DistributedPathFinder& finder);
  /** The largest number of points on any rank in the searches so far. Collective. */
  vtkIdType mostPointsOnARank();

private:
  /** The request with another solver. */
  PathRequest withSolver(DistanceSolver& solver) const;
  std::vector<bool> runTogether(std::size_t count, const Search& search);
  /** On several ranks, finds as many of the paths as parts of the surface are enough for. */
  void findPiecewise(
    std::span<const PointPair> pairs, bool fromBothEnds, std::span<Outcome> outcomes);
  /** The numbers of the starts in the order in which their paths are best found. */
  std::vector<std::size_t> orderOf(std::span<const GlobalPoint> starts);
  /** As fromStarts(), in their order. */
  void findFromStarts(std::span<const GlobalPoint> starts, const std::vector<GlobalPoint>& ends,
    std::vector<Outcome>& found);
  /** On one rank, finds paths along edges for which a field along edges is worth while: those of
   * ends with many starts. @param finder  has marched across faces */
  void findAlongEdges(std::span<const GlobalPoint> starts, const std::vector<GlobalPoint>& ends,
    const DistributedPathFinder& finder, const PathRequest& request, std::vector<Outcome>& found);
  /** Finds paths on threads as far as the finder's field allows; leaves out the others. */
  void shareStarts(std::span<const GlobalPoint> starts, const std::vector<GlobalPoint>& ends,
    const DistanceField& field, std::size_t stepsOfMarch, std::vector<Outcome>& found);

  PathRequest Request;
  SolverTeam& Solvers;
  IsAborted IsAbortedNow;
  std::size_t LargestCorridor = 0;
};

}

#endif
