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
 * The shortest way from one point to another: a march from the first that stops at the second, and
 * a trace back.
 * @param options cost, barriers, maximum distance, progress; its targets are set here
 * @return none where there is no way, or the march was cancelled
 * @throws as DistanceSolver::solve; std::invalid_argument where a path of varying cost, or one of
 * PathOrder::Vertices, is to be straightened
 */
std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, SolveOptions options, const PathStyle& style);

}

#endif
