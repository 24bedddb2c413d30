// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathFinder.h"

#include "path/EdgePathSearch.h"
#include "path/PathMeeting.h"
#include "path/PathStraightener.h"
#include "solve/DistanceSolver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic
{
namespace
{

/** The beginning of a path up to its first vertex: it is straight if its faces are laid flat. */
class FirstLeg
{
public:
  /** @param length of the path, above 0 */
  FirstLeg(const TriangleMesh& mesh, const SurfacePath& path, double length)
  {
    const auto bend = std::find_if(path.begin() + 1, path.end() - 1, isVertex);
    const double leg = bend + 1 == path.end() ? length : lengthOf(mesh, { path.begin(), bend + 1 });
    const Vector3 start = path[0].position(mesh);
    const Vector3 step = path[1].position(mesh) - start;
    this->End = start + (leg / norm(step)) * step;
    this->Rest = length - leg;
  }

  /** The length of a path beside this one, from another point of the face in which this one
   * begins. */
  double lengthFrom(const Vector3& position) const
  {
    return norm(position - this->End) + this->Rest;
  }

private:
  Vector3 End;
  double Rest = 0.0;
};

}

std::vector<std::size_t> orderInMemory(
  const TriangleMesh& mesh, std::span<const SurfacePoint> points)
{
  std::vector<std::pair<Index, std::size_t>> keyed;
  keyed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Triangle& face = mesh.triangle(points[i].triangle);
    keyed.emplace_back(*std::min_element(face.begin(), face.end()), i);
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::size_t> order;
  order.reserve(points.size());
  std::transform(keyed.begin(), keyed.end(), std::back_inserter(order),
    [](const auto& key) { return key.second; });
  return order;
}

PathFinder::PathFinder(DistanceSolver& solver, std::span<const SurfacePoint> seeds,
  const SolveOptions& options, const PathStyle& style)
  : Solver(solver)
  , Options(options)
  , Progress(this->Options)
  , Surface(solver.mesh(), this->Options, this->Progress)
  , Style(style)
  , Ends(solver.mesh(), seeds)
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
  }
}

bool PathFinder::march(std::span<const SurfacePoint> points)
{
  this->Starts.assign(points.begin(), points.end());
  this->Targets.clear();
  try
  {
    for (const SurfacePoint& point : points)
    {
      this->addTargetsRound(PathPoint::at(this->Solver.mesh(), point));
    }
  }
  catch (const SearchCancelled&)
  {
    return false;
  }
  return this->solve(this->Targets);
}

bool PathFinder::addTargetsAlong(const SurfacePath& path)
{
  const std::size_t known = this->Targets.size();
  std::for_each(
    path.begin(), path.end(), [&](const PathPoint& point) { this->addTargetsRound(point); });
  const auto isReached = [&](const Triangle& target) { return this->Field->isReached(target[0]); };
  this->Targets.erase(std::remove_if(this->Targets.begin() + known, this->Targets.end(), isReached),
    this->Targets.end());
  return this->Targets.size() > known;
}

bool PathFinder::solve(std::span<const Triangle> targets)
{
  const double guess = targets.empty() ? DistanceField::Unreached : this->guessedDistance();
  if (guess < this->Options.maximumDistance)
  {
    this->solveWithin(guess, targets);
    const StopReason reason = this->Field->stopReason();
    if (reason == StopReason::Targets || reason == StopReason::Cancelled)
    {
      return reason == StopReason::Targets;
    }
  }
  this->solveWithin(this->Options.maximumDistance, targets);
  return this->Field->stopReason() != StopReason::Cancelled;
}

void PathFinder::solveWithin(double maximumDistance, std::span<const Triangle> targets)
{
  SolveOptions options = this->Options;
  options.maximumDistance = maximumDistance;
  options.targets = targets;
  options.targetMode = TargetMode::All;
  options.onlyTowardsTargets = this->goesTowardsStart();
  if (this->Solver.findsPaths())
  {
    options.pathStarts = this->Starts;
  }
  if (options.onProgress)
  {
    options.onProgress = [this](std::size_t taken) { return this->Progress.report(taken); };
  }
  this->Field = &this->Solver.solve(this->Seeds, options);
  this->Surface.useDetours(this->Solver.detours());
  this->Progress.endMarch();
}

bool PathFinder::goesTowardsStart() const
{
  return this->Starts.size() == 1 && this->Style.order == PathOrder::Edges &&
    this->Solver.crossesFaces() && this->Options.targets.empty();
}

double PathFinder::guessedDistance() const
{
  // Within this detour an ellipse has an eighth of the area of the disc that it lies in.
  constexpr double detour = 1.1;
  if (!this->goesTowardsStart() || !this->Solver.gainsByMaximumDistance())
  {
    return DistanceField::Unreached;
  }
  const TriangleMesh& mesh = this->Solver.mesh();
  const Vector3 start = mesh.positionOf(this->Starts[0]);
  double nearest = DistanceField::Unreached;
  for (const Seed& seed : this->Seeds)
  {
    nearest = std::min(nearest, norm(mesh.positionOf(seed.points[0]) - start));
  }
  const std::span<const double> cost = this->Options.cost;
  const double least = cost.empty() ? 1.0 : *std::min_element(cost.begin(), cost.end());
  // All corners round the start are to be reached as well.
  return least * (detour * nearest + mesh.longestEdgeLength());
}

void PathFinder::addTargetsRound(const PathPoint& point)
{
  const auto add = [&](Index vertex)
  {
    if (!this->Surface.isExcluded(vertex))
    {
      this->Targets.push_back({ vertex, vertex, vertex });
    }
  };
  // A straight path from the point crosses edges of the faces in which the point lies.
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
    throw std::invalid_argument("The path begins at point " +
      std::to_string(mesh.pointOfVertex(carriers[0])) +
      ", which is on a barrier. Move the waypoint off the barrier.");
  }
  this->IsProvenShortest = false;
  try
  {
    const bool isFound = this->Solver.findsPaths() && this->Style.order == PathOrder::Edges;
    auto path = isFound ? this->takeFound(point) : this->searchFrom(start);
    this->Cost = path ? costOf(this->Surface, *path) : 0.0;
    return path;
  }
  catch (const SearchCancelled&)
  {
    return std::nullopt;
  }
}

std::optional<SurfacePath> PathFinder::takeFound(const SurfacePoint& point)
{
  constexpr double rounding = 1e-9;
  const TriangleMesh& mesh = this->Solver.mesh();
  const auto found = this->Solver.pathFrom(point);
  if (!found)
  {
    return std::nullopt;
  }
  const auto isShortest = [&](const SurfacePath& path)
  { return !path.empty() && lengthOf(mesh, path) <= found->length * (1.0 + rounding); };
  SurfacePath path;
  for (const SurfacePoint& along : found->points)
  {
    path.push_back(PathPoint::at(mesh, along));
  }
  if (path.size() > 1)
  {
    if (this->Style.straighten || !isShortest(path))
    {
      path = PathStraightener(this->Surface).straightened(std::move(path));
    }
    path.erase(std::unique(path.begin(), path.end(), isSameVertex), path.end());
  }
  if (!isShortest(path))
  {
    auto traced = this->searchFrom(PathPoint::at(mesh, point));
    const bool isBetter =
      traced && (path.empty() || lengthOf(mesh, *traced) < lengthOf(mesh, path));
    path = isBetter ? std::move(*traced) : std::move(path);
  }
  this->IsProvenShortest = isShortest(path);
  return path.empty() ? std::nullopt : std::optional(std::move(path));
}

Index PathFinder::nearestSeed(const SurfacePoint& point) const
{
  try
  {
    const std::vector<Index> seeds = PathTracer(this->Surface, *this->Field, this->Ends)
                                       .seedsNear(PathPoint::at(this->Solver.mesh(), point));
    return seeds.empty() ? NoIndex : seeds.front();
  }
  catch (const SearchCancelled&)
  {
    return NoIndex;
  }
}

std::optional<SurfacePath> PathFinder::searchFrom(const PathPoint& start)
{
  auto path = this->shortestOf(start);
  if (!path && this->Field->stopReason() == StopReason::Targets)
  {
    // Beside long edges a path can need distances that are larger than those at its ends.
    path = this->solve({}) ? this->shortestOf(start) : std::nullopt;
  }
  const bool staysTraced = this->Style.order == PathOrder::Edges && !this->Style.straighten;
  // A round that reaches nothing more is the last one.
  std::size_t reached = 0;
  while (path && staysTraced && this->Field->stopReason() == StopReason::Targets &&
    this->Field->reached().size() > std::exchange(reached, this->Field->reached().size()) &&
    this->addTargetsAlong(*path))
  {
    path = this->solve(this->Targets) ? this->shortestOf(start) : std::nullopt;
  }
  return path;
}

std::optional<SurfacePath> PathFinder::shortestOf(const PathPoint& start) const
{
  PathTracer tracer(this->Surface, *this->Field, this->Ends);
  std::vector<Index> seeds = tracer.seedsNear(start);
  if (!this->Style.straighten && seeds.size() > 1)
  {
    // Lengths of paths that stay as traced, or run through varying cost, do not tell which seed is
    // the nearest.
    seeds.erase(seeds.begin() + 1, seeds.end());
  }
  std::optional<SurfacePath> shortest;
  double least = DistanceField::Unreached;
  for (Index seed : seeds)
  {
    auto path = tracer.trace(start, seed, this->Style.order);
    if (path)
    {
      this->shorten(*path, start);
      // A length is only to be compared with others.
      const double length = seeds.size() > 1 ? lengthOf(this->Surface.mesh(), *path) : 0.0;
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
  if (this->Style.straighten)
  {
    path = this->straightestOf(std::move(path), start);
    return;
  }
  if (this->Style.order == PathOrder::Vertices && !this->Surface.hasCosts())
  {
    const double length = lengthOf(this->Surface.mesh(), path);
    if (auto other = shorterEdgePath(this->Surface, *this->Field, path.back(), start, length))
    {
      std::reverse(other->begin(), other->end());
      path = std::move(*other);
    }
  }
  path.erase(std::unique(path.begin(), path.end(), isSameVertex), path.end());
}

SurfacePath PathFinder::straightestOf(SurfacePath traced, const PathPoint& start) const
{
  const TriangleMesh& mesh = this->Solver.mesh();
  PathStraightener straightener(this->Surface);
  SurfacePath best = straightener.straightened(std::move(traced));
  double least = lengthOf(mesh, best);
  const auto consider = [&](SurfacePath&& path)
  {
    SurfacePath other = straightener.straightened(std::move(path));
    const double length = lengthOf(mesh, other);
    if (length < least)
    {
      best = std::move(other);
      least = length;
    }
  };
  const Carriers corners = this->cornersOffThePath(best, least, start);
  if (corners.size() > 0)
  {
    const PathMeeting meeting(isSmoothAlong(mesh, best) ? best : SurfacePath{});
    for (const Index corner : corners)
    {
      if (auto other = this->pathByCorner(corner, start, meeting, straightener))
      {
        consider(std::move(*other));
      }
    }
  }
  if (auto other = shorterEdgePath(this->Surface, *this->Field, best.back(), start, least))
  {
    std::reverse(other->begin(), other->end());
    consider(std::move(*other));
  }
  return best;
}

std::optional<SurfacePath> PathFinder::pathByCorner(Index corner, const PathPoint& start,
  const PathMeeting& meeting, PathStraightener& straightener) const
{
  constexpr double rounding = 1e-12;
  const TriangleMesh& mesh = this->Solver.mesh();
  const SurfacePath& known = meeting.path();
  PathTracer::MayEnd mayEnd;
  if (!known.empty())
  {
    mayEnd = [&](const SurfacePath& path) { return meeting.placeOfMeeting(path) > 0; };
  }
  const auto traced = PathTracer(this->Surface, *this->Field, this->Ends)
                        .trace(PathPoint::atVertex(corner), this->Field->nearestSeed(corner),
                          PathOrder::Edges, mayEnd);
  if (!traced)
  {
    return std::nullopt;
  }
  SurfacePath path{ start };
  path.insert(path.end(), traced->begin(), traced->end());
  if (const std::size_t place = meeting.placeOfMeeting(path))
  {
    const auto meetingPoint = known.begin() + static_cast<std::ptrdiff_t>(place);
    path.back() = *meetingPoint;
    path = straightener.straightened(std::move(path));
    const double length = lengthOf(mesh, { known.begin(), meetingPoint + 1 });
    if (std::abs(lengthOf(mesh, path) - length) <= rounding * length)
    {
      return std::nullopt;
    }
    path.insert(path.end(), meetingPoint + 1, known.end());
  }
  return path;
}

Carriers PathFinder::cornersOffThePath(
  const SurfacePath& path, double length, const PathPoint& start) const
{
  constexpr double rounding = 1e-12;
  const TriangleMesh& mesh = this->Solver.mesh();
  Carriers corners;
  if (isVertex(start) || length == 0.0)
  {
    return corners;
  }
  const FirstLeg leg(mesh, path, length);
  for (Index corner : start.carriers())
  {
    if (this->Field->distance(corner) < (1.0 - rounding) * leg.lengthFrom(mesh.position(corner)))
    {
      corners.add(corner);
    }
  }
  return corners;
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
