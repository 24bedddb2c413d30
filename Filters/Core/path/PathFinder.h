// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathFinder_h
#define geodesic_PathFinder_h

#include "path/PathTracer.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class DistanceSolver;

/** How a path is made from a field of distances. */
struct PathStyle
{
  PathOrder order = PathOrder::Edges;
  /** Makes the path locally shortest (see PathStraightener); needs constant cost. */
  bool straighten = true;

  friend constexpr bool operator==(const PathStyle&, const PathStyle&) = default;
};

/**
 * Finds shortest paths to the nearest of some seeds: one march that stops where the paths' other
 * ends are reached, and a trace back from each.
 */
class PathFinder
{
public:
  /**
   * @param solver  its field is overwritten; both must live as long as this
   * @param seeds   where paths end
   * @param options cost, barriers, maximum distance, progress; targets are set here
   * @throws std::invalid_argument where paths of varying cost, or of PathOrder::Vertices, are to be
   * straightened
   */
  PathFinder(DistanceSolver& solver, std::span<const SurfacePoint> seeds,
    const SolveOptions& options, const PathStyle& style);

  /**
   * Marches as far as paths from these points need.
   * @return false when cancelled
   * @throws as FrontSolver::solve
   */
  bool march(std::span<const SurfacePoint> points);

  /** The field that the last march made. */
  const DistanceField& field() const { return *this->Field; }

  /**
   * @param point one of those given to march()
   * @return the path from there to a seed, both among its points (one point where it is a vertex
   * and a seed); none where there is no way. No way along edges to that seed is shorter, where the
   * path is straightened, or goes along edges without costs itself.
   * @throws std::invalid_argument for a point at an excluded vertex
   */
  std::optional<SurfacePath> pathFrom(const SurfacePoint& point);

private:
  /** Of the paths to the seeds that may be the nearest. */
  std::optional<SurfacePath> shortestOf(const PathPoint& start) const;
  bool solve(std::span<const Triangle> targets);
  /** Makes a traced path what the style says, and no longer than one along edges. */
  void shorten(SurfacePath& path, const PathPoint& start) const;
  /** The shortest of the straightened ways, of which a traced one is the first to be tried. */
  SurfacePath straightestOf(const SurfacePath& traced, const PathPoint& start) const;
  /**
   * Where fronts meet within a face, its inside does not know which came from where; the corners
   * do.
   * @return those of the start's that are nearer to the seed than by a way beside the path. Where
   * another front is first at the start, it was first at one of them: the points that are nearer to
   * one of two sources than to the other are half of a plane.
   */
  Carriers cornersOffThePath(const SurfacePath& path, const PathPoint& start) const;
  void addTargetsRound(const PathPoint& point);
  /**
   * Adds the corners of all faces that a traced path touches: short of them the trace had no choice
   * but to go round.
   * @return whether there are any that the march has not reached
   */
  bool addTargetsAlong(const SurfacePath& path);

  DistanceSolver& Solver;
  SolveOptions Options;
  WeightedMesh Surface;
  PathStyle Style;
  std::vector<Seed> Seeds;
  std::vector<PathPoint> Ends;
  std::vector<Triangle> Targets;
  const DistanceField* Field = nullptr;
};

/**
 * The shortest way from one point to another.
 * @return none where there is no way, or the march was cancelled
 * @throws as PathFinder
 */
std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, const SolveOptions& options, const PathStyle& style);

}

#endif
