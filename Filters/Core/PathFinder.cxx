#include "PathFinder.h"

#include "DistanceSolver.h"
#include "EdgePathSearch.h"
#include "PathStraightener.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace geodesic
{

PathFinder::PathFinder(DistanceSolver& solver, std::span<const SurfacePoint> seeds,
  const SolveOptions& options, const PathStyle& style)
  : Solver(solver)
  , Options(options)
  , Surface(solver.mesh(), this->Options)
  , Style(style)
{
  if (style.straighten && (style.order == PathOrder::Vertices || !options.cost.empty()))
  {
    throw std::invalid_argument(std::string("A path ") +
      (options.cost.empty() ? "along edges" : "through varying cost") +
      " is not straight; ask for it without straightening.");
  }
  for (const SurfacePoint& seed : seeds)
  {
    this->Seeds.push_back(Seed::atPoint(seed));
    this->Ends.push_back(PathPoint::at(solver.mesh(), seed));
  }
}

bool PathFinder::march(std::span<const SurfacePoint> points)
{
  std::vector<Triangle> targets;
  for (const SurfacePoint& point : points)
  {
    this->addTargetsRound(PathPoint::at(this->Solver.mesh(), point), targets);
  }
  return this->solve(targets);
}

bool PathFinder::solve(std::span<const Triangle> targets)
{
  this->Options.targets = targets;
  this->Options.targetMode = TargetMode::All;
  this->Field = &this->Solver.solve(this->Seeds, this->Options);
  this->Options.targets = {};
  return this->Field->stopReason() != StopReason::Cancelled;
}

void PathFinder::addTargetsRound(const PathPoint& point, std::vector<Triangle>& targets) const
{
  const auto add = [&](Index vertex)
  {
    if (!this->Surface.isExcluded(vertex))
    {
      targets.push_back({ vertex, vertex, vertex });
    }
  };
  // A straight way from the point crosses the edges of the faces that it lies in.
  const Carriers carriers = point.carriers();
  std::for_each(carriers.begin(), carriers.end(), add);
  visitFaces(this->Surface, point,
    [&](const Triangle& face) { std::for_each(face.begin(), face.end(), add); });
}

std::optional<SurfacePath> PathFinder::pathFrom(const SurfacePoint& point)
{
  const TriangleMesh& mesh = this->Solver.mesh();
  const PathPoint start = PathPoint::at(mesh, point);
  const Carriers carriers = start.carriers();
  if (std::all_of(carriers.begin(), carriers.end(),
        [&](Index vertex) { return this->Surface.isExcluded(vertex); }))
  {
    throw std::invalid_argument("The path begins at excluded point " +
      std::to_string(mesh.pointOfVertex(carriers[0])) + "; move it off the barrier.");
  }
  auto path = this->shortestOf(start);
  if (!path && this->Field->stopReason() == StopReason::Targets)
  {
    // Beside long edges a path can need distances beyond those of its own ends.
    path = this->solve({}) ? this->shortestOf(start) : std::nullopt;
  }
  return path;
}

std::optional<SurfacePath> PathFinder::shortestOf(const PathPoint& start) const
{
  PathTracer tracer(this->Surface, *this->Field, this->Ends);
  std::vector<Index> seeds = tracer.seedsNear(start);
  if (!this->Style.straighten && seeds.size() > 1)
  {
    // As traced, and through varying cost, lengths do not tell which seed is the nearest.
    seeds.resize(1);
  }
  std::optional<SurfacePath> shortest;
  double least = DistanceField::Unreached;
  for (Index seed : seeds)
  {
    auto path = tracer.trace(start, seed, this->Style.order);
    if (path)
    {
      this->shorten(*path, start);
      const double length = lengthOf(this->Surface.mesh(), *path);
      if (length < least)
      {
        least = length;
        shortest = std::move(path);
      }
    }
  }
  return shortest;
}

void PathFinder::shorten(SurfacePath& path, const PathPoint& start) const
{
  const PathStraightener straightener(this->Surface);
  const bool isAlongEdges = this->Style.order == PathOrder::Vertices;
  if (this->Style.straighten)
  {
    path = straightener.straightened(path);
  }
  if (this->Style.straighten || (isAlongEdges && !this->Surface.hasCosts()))
  {
    const double length = lengthOf(this->Surface.mesh(), path);
    if (auto other = shorterEdgePath(this->Surface, *this->Field, path.back(), start, length))
    {
      std::reverse(other->begin(), other->end());
      path = isAlongEdges ? std::move(*other) : straightener.straightened(*other);
    }
  }
  path.erase(std::unique(path.begin(), path.end(), isSameVertex), path.end());
}

std::optional<SurfacePath> shortestPath(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, const SolveOptions& options, const PathStyle& style)
{
  PathFinder finder(solver, { &from, 1 }, options, style);
  if (!finder.march({ &to, 1 }))
  {
    return std::nullopt;
  }
  auto path = finder.pathFrom(to);
  if (path)
  {
    std::reverse(path->begin(), path->end());
  }
  return path;
}

}
