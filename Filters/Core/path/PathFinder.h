// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathFinder_h
#define geodesic_PathFinder_h

#include "path/PathTracer.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class DistanceSolver;
class PathMeeting;
class PathStraightener;

/** How a path is made from a field of distances. */
struct PathStyle
{
  PathOrder order = PathOrder::Edges;
  /** Makes the path locally shortest (see PathStraightener); needs constant cost. */
  bool straighten = true;

  friend constexpr bool operator==(const PathStyle&, const PathStyle&) = default;
};

/** The numbers of some points in the order in which their vertices lie in memory. Paths from one
 * after the other read much that is in the processor's caches, as neighbours' paths lie side by
 * side. Time O(n log n). */
std::vector<std::size_t> orderInMemory(
  const TriangleMesh& mesh, std::span<const SurfacePoint> points);

/**
 * Finds shortest paths from points to the nearest of some seeds: march() solves the field of the
 * seeds until it reaches the points, and pathFrom() traces a path back from one of them. Many
 * starts are best taken in the order of orderInMemory().
 */
class PathFinder
{
public:
  /**
   * @param solver  its field is overwritten; both must live as long as this
   * @param seeds   points at which paths end
   * @param options cost, barriers, maximum distance and progress, which marches report, and tracing
   *                and straightening every some thousand steps. With targets, whose distances the
   *                caller wants in field(), marches go to all sides; they end by the starts alone
   * @throws std::invalid_argument if @p style straightens paths of varying cost or of
   *         PathOrder::Vertices
   */
  PathFinder(DistanceSolver& solver, std::span<const SurfacePoint> seeds,
    const SolveOptions& options, const PathStyle& style);
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;

  /**
   * Marches as far as paths from these points need.
   * @return false when cancelled
   * @throws as FrontSolver::solve
   */
  bool march(std::span<const SurfacePoint> points);

  /** The field that the last march made. */
  const DistanceField& field() const { return *this->Field; }

  /**
   * The number of the seed that the field says is the nearest, the least of several.
   * @param point one of those given to march()
   * @return NoIndex if no seed is reached, or the search was cancelled
   */
  Index nearestSeed(const SurfacePoint& point) const;

  /** The number of the seed at which a path ends, the least of several at one point. */
  Index seedAtEnd(const SurfacePath& path) const { return this->Ends.find(path.back()); }

  /**
   * @param point one of those given to march()
   * @return the path from the point to a seed, with both among its points (one point if the point
   * is a vertex and a seed); nothing if there is no path or the search was cancelled. If the path
   *         is straightened, or goes along edges without costs, no path along edges to that seed is
   *         shorter.
   * @throws std::invalid_argument for a point at an excluded vertex
   */
  std::optional<SurfacePath> pathFrom(const SurfacePoint& point);

  /** The cost of the last path of pathFrom(), its length if there are no costs; see costOf(). */
  double cost() const { return this->Cost; }

  /** Whether the last path of pathFrom() is proven to be the shortest of all, to 1e-9; of
   * BoundedSolver, to within SolveOptions::tolerance. */
  bool isProvenShortest() const { return this->IsProvenShortest; }

private:
  /** As pathFrom(). @throws SearchCancelled */
  std::optional<SurfacePath> searchFrom(const PathPoint& start);
  /** The same by the path that the solver has found. */
  std::optional<SurfacePath> takeFound(const SurfacePoint& point);
  /** The shortest of the paths to the seeds that may be the nearest; nothing if there is none. */
  std::optional<SurfacePath> shortestOf(const PathPoint& start) const;
  /** Solves the field as far as @p targets, everywhere if there are none. @return false when
   * cancelled */
  bool solve(std::span<const Triangle> targets);
  void solveWithin(double maximumDistance, std::span<const Triangle> targets);
  /** Whether marches leave out what lies elsewhere than towards the only start. A path along edges,
   * and one across faces in a field along edges, can need the field anywhere beside it, and a
   * caller with targets that of these. */
  bool goesTowardsStart() const;
  /** A distance within which the only start mostly lies, where a march gains by that; infinity
   * where it does not. */
  double guessedDistance() const;
  /** Straightens a traced path if the style says so, and replaces it by a path along edges if one
   * is shorter. */
  void shorten(SurfacePath& path, const PathPoint& start) const;
  /** The shortest of several straightened paths: the traced one, those by the corners of
   * cornersOffThePath(), and one along edges. */
  SurfacePath straightestOf(SurfacePath traced, const PathPoint& start) const;
  /** The path from the start by one of these corners, traced from there until it meets a straight
   * one. @return nothing if there is none, or it is that path once it is straight */
  std::optional<SurfacePath> pathByCorner(Index corner, const PathPoint& start,
    const PathMeeting& meeting, PathStraightener& straightener) const;
  /**
   * Finds corners by which a path of another front may be shorter. Where two fronts meet inside a
   * face, the field tells only at the corners which of them came first.
   * @return the carriers of the start whose distance is less than the length of a path from them
   *         beside @p path. If another front is the first at the start, it is the first at one of
   *         these: the points nearer to one of two sources than to the other are half of a plane.
   */
  Carriers cornersOffThePath(const SurfacePath& path, double length, const PathPoint& start) const;
  /** Adds the corners of the faces round a point, and its carriers, to Targets. */
  void addTargetsRound(const PathPoint& point);
  /**
   * Adds the corners of all faces that a traced path touches, as far as the march has not reached
   * them: without values there the trace had to go round these faces.
   * @return whether it added any
   */
  bool addTargetsAlong(const SurfacePath& path);

  DistanceSolver& Solver;
  SolveOptions Options;
  SearchProgress Progress;
  WeightedMesh Surface;
  PathStyle Style;
  std::vector<Seed> Seeds;
  PathEnds Ends;
  std::vector<SurfacePoint> Starts;
  std::vector<Triangle> Targets;
  const DistanceField* Field = nullptr;
  bool IsProvenShortest = false;
  double Cost = 0.0;
};

/**
 * The shortest path from one point to another.
 * @return nothing if there is no path or the march was cancelled
 * @throws as PathFinder
 */
std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, const SolveOptions& options, const PathStyle& style);

}

#endif
