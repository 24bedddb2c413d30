#include "PathFinder.h"

#include "DistanceSolver.h"
#include "EdgePathSearch.h"
#include "PathStraightener.h"

#include <algorithm>
#include <stdexcept>

namespace geodesic
{

std::vector<Triangle> targetsRound(const Terrain& terrain, const PathPoint& point)
{
  std::vector<Triangle> targets;
  const auto add = [&](Index vertex)
  {
    if (!terrain.isExcluded(vertex))
    {
      targets.push_back({ vertex, vertex, vertex });
    }
  };
  const Carriers carriers = point.carriers();
  std::for_each(carriers.begin(), carriers.end(), add);
  visitFaces(
    terrain, point, [&](const Triangle& face) { std::for_each(face.begin(), face.end(), add); });
  return targets;
}

std::optional<SurfacePath> tracedPath(const Terrain& terrain, const DistanceField& field,
  std::span<const PathPoint> seeds, const PathPoint& point, const PathStyle& style)
{
  if (style.straighten && (style.order == PathOrder::Vertices || terrain.hasCosts()))
  {
    throw std::invalid_argument(std::string("A path ") +
      (terrain.hasCosts() ? "through varying cost" : "along edges") +
      " is not straight; ask for it without straightening.");
  }
  auto path = PathTracer(terrain, field, seeds).trace(point, style.order);
  if (path && style.straighten)
  {
    const PathStraightener straightener(terrain);
    path = straightener.straightened(*path);
    const double length = lengthOf(terrain.mesh(), *path);
    if (auto other = shorterEdgePath(terrain, field, path->back(), point, length))
    {
      std::reverse(other->begin(), other->end());
      path = straightener.straightened(*other);
    }
  }
  return path;
}

std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, SolveOptions options, const PathStyle& style)
{
  const TriangleMesh& mesh = solver.mesh();
  const PathPoint start = PathPoint::at(mesh, from);
  const PathPoint end = PathPoint::at(mesh, to);
  const Terrain terrain(mesh, options);
  const std::vector<Triangle> targets = targetsRound(terrain, end);
  options.targets = targets;
  options.targetMode = TargetMode::All;
  const Seed seed = Seed::atPoint(from);
  const DistanceField& field = solver.solve({ &seed, 1 }, options);
  if (field.stopReason() == StopReason::Cancelled)
  {
    return std::nullopt;
  }
  auto path = tracedPath(terrain, field, { &start, 1 }, end, style);
  if (path)
  {
    std::reverse(path->begin(), path->end());
  }
  return path;
}

}
