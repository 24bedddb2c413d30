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

std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, SolveOptions options, const PathStyle& style)
{
  if (style.straighten && (style.order == PathOrder::Vertices || !options.cost.empty()))
  {
    throw std::invalid_argument(std::string("A path ") +
      (options.cost.empty() ? "along edges" : "through varying cost") +
      " is not straight; ask for it without straightening.");
  }
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
  auto path = PathTracer(terrain, field, { &start, 1 }).trace(end, style.order);
  if (path)
  {
    std::reverse(path->begin(), path->end());
    if (style.straighten)
    {
      const PathStraightener straightener(terrain);
      path = straightener.straightened(*path);
      if (const auto other = shorterEdgePath(terrain, field, start, end, lengthOf(mesh, *path)))
      {
        path = straightener.straightened(*other);
      }
    }
  }
  return path;
}

}
