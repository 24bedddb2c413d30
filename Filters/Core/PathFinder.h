#ifndef geodesic_PathFinder_h
#define geodesic_PathFinder_h

#include "PathTracer.h"
#include "SolveOptions.h"
#include "SurfacePoint.h"

#include <optional>

namespace geodesic
{

class DistanceSolver;

/** How a path is made from a field of distances. */
struct PathStyle
{
  PathOrder order = PathOrder::Edges;
  /** Makes the path locally shortest (see PathStraightener); needs constant cost. */
  bool straighten = true;
};

/**
 * What a march must reach (see SolveOptions::targets, all of them) before a path can be traced from
 * @p point: the open vertices of the faces that it lies in, for a straight way crosses their edges.
 */
std::vector<Triangle> targetsRound(const Terrain& terrain, const PathPoint& point);

/**
 * The way from a point back to the nearest seed, down a field that a march made.
 * @param terrain as it was for the march
 * @param field   with the targets round the point (see targetsRound)
 * @param seeds   the points it was measured from, in their order
 * @return none where the field does not reach the point
 * @throws std::invalid_argument where a path of varying cost, or one of PathOrder::Vertices, is to
 * be straightened
 */
std::optional<SurfacePath> tracedPath(const Terrain& terrain, const DistanceField& field,
  std::span<const PathPoint> seeds, const PathPoint& point, const PathStyle& style);

/**
 * The shortest way from one point to another: a march from the first that stops at the second, and
 * a trace back.
 * @param options cost, barriers, maximum distance, progress; its targets are set here
 * @return none where there is no way, or the march was cancelled
 * @throws as DistanceSolver::solve and tracedPath
 */
std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, SolveOptions options, const PathStyle& style);

}

#endif
