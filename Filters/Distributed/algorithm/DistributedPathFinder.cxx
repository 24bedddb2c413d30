// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/DistributedPathFinder.h"

#include "algorithm/PiecewisePaths.h"
#include "algorithm/WholeSurface.h"
#include "global/GlobalSeeds.h"
#include "pieces/DistributedSurface.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** So many paths are sought together at first, or as many as there are ends: the corridor has those
 * as well. */
constexpr std::size_t FirstTogether = 64;
constexpr std::size_t MostTogetherAtFirst = 1024;

std::vector<SurfacePoint> localPoints(std::span<const GlobalPoint> points)
{
  std::vector<SurfacePoint> local;
  for (const GlobalPoint& point : points)
  {
    local.push_back(point.local.front());
  }
  return local;
}

}

DistributedPathFinder::DistributedPathFinder(
  const PathRequest& request, std::vector<GlobalPoint> ends)
  : Request(request)
  , Ends(std::move(ends))
  , Partition(request.ranks, request.mesh)
  , Together(std::clamp(this->Ends.size(), FirstTogether, MostTogetherAtFirst))
{
  if (request.ranks.size() == 1)
  {
    this->Whole.emplace(request.solver, localPoints(this->Ends), request.options, request.style);
    return;
  }
  this->OfInput.emplace(request.ranks, request.surface, request.input);
  if (request.whole)
  {
    if (const auto& corridor = request.whole->corridor())
    {
      SolveOptions options = corridor->options();
      options.onProgress = request.options.onProgress;
      options.memoryLimit = request.options.memoryLimit;
      options.tolerance = request.options.tolerance;
      this->OnWhole.emplace(
        request.whole->solver(), corridor->pointsOf(this->Ends), options, request.style);
      this->LargestCorridor = corridor->mesh().numberOfPoints();
    }
    return;
  }
  this->HasCost = request.ranks.isAny(!request.options.cost.empty());
  if (request.style.order == PathOrder::Vertices && !this->HasCost && request.solver.crossesFaces())
  {
    this->EdgeSolver = std::make_unique<DijkstraSolver>(request.mesh.sharedMesh());
  }
  this->Cutter.emplace(request.mesh, request.options);
}

bool DistributedPathFinder::march(std::span<const GlobalPoint> starts)
{
  if (this->Whole)
  {
    return this->Whole->march(localPoints(starts));
  }
  if (this->EdgeSolver && this->Ends.size() == 1)
  {
    // The field along edges is enough.
    return true;
  }
  return this->askFirst([&] { return this->leadMarch(starts); }).front().end == 0;
}

std::optional<TracedPath> DistributedPathFinder::pathFrom(const GlobalPoint& start)
{
  if (!this->Whole)
  {
    return std::move(this->pathsFrom({ &start, 1 }).front());
  }
  auto path = this->Whole->pathFrom(start.local.front());
  if (!path)
  {
    return std::nullopt;
  }
  TracedPath traced;
  traced.end = this->Whole->seedAtEnd(*path);
  traced.cost = this->Whole->cost();
  traced.isProvenShortest = this->Whole->isProvenShortest();
  traced.path = std::move(*path);
  return traced;
}

std::vector<std::optional<TracedPath>> DistributedPathFinder::pathsFrom(
  std::span<const GlobalPoint> starts)
{
  std::vector<std::optional<TracedPath>> paths;
  if (this->Whole)
  {
    for (const GlobalPoint& start : starts)
    {
      paths.push_back(this->pathFrom(start));
    }
    return paths;
  }
  if (this->EdgeSolver)
  {
    return this->pathsAlongEdgesFrom(starts);
  }
  std::vector<TracedPath> traced(starts.size());
  const Answers answers = this->askFirst([&] { return this->leadPaths(starts, traced); });
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    traced[i].end = answers[i].end;
    traced[i].isProvenShortest = answers[i].isProvenShortest != 0;
    paths.push_back(traced[i].end == NoIndex ? std::nullopt : std::optional(std::move(traced[i])));
  }
  return paths;
}

std::vector<std::optional<TracedPath>> DistributedPathFinder::pathsAlongEdgesFrom(
  std::span<const GlobalPoint> starts)
{
  std::map<Index, std::vector<std::size_t>> startsByEnd;
  const Answers answers = this->Ends.size() == 1
    ? Answers(starts.size(), { 0 })
    : this->askFirst([&] { return this->leadToNearest(starts); });
  std::vector<std::optional<TracedPath>> paths(starts.size());
  std::vector<bool> areKnown(starts.size(), false);
  if (this->mayGoPiecewise(starts.size()))
  {
    this->findPiecewise(starts, answers, paths, areKnown);
  }
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    if (!areKnown[i])
    {
      startsByEnd[answers[i].end].push_back(i);
    }
  }
  startsByEnd.erase(NoIndex);
  for (const auto& [end, numbers] : startsByEnd)
  {
    std::vector<GlobalPoint> startsOfEnd;
    std::transform(numbers.begin(), numbers.end(), std::back_inserter(startsOfEnd),
      [&](std::size_t i) { return starts[i]; });
    const PathRequest& own = this->Request;
    const PathRequest request{ own.ranks, own.surface, own.gathered, own.split, own.mesh,
      *this->EdgeSolver, own.options, own.style, own.input, nullptr };
    DistributedPathFinder finder(request, { this->Ends[end] });
    if (finder.march(startsOfEnd))
    {
      auto found = finder.pathsFrom(startsOfEnd);
      for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        if (found[i])
        {
          found[i]->end = end;
          paths[numbers[i]] = std::move(found[i]);
        }
      }
    }
    this->LargestCorridor = std::max(this->LargestCorridor, finder.LargestCorridor);
  }
  return paths;
}

bool DistributedPathFinder::mayGoPiecewise(std::size_t starts) const
{
  // A field for each end takes some 0.1 s. A search for each start goes over some of the vertices
  // that are nearest to its end, at 0.1 us each.
  constexpr double verticesOfField = 1e6;
  const auto& [ranks, surface, gathered, split, mesh, solver, options, style, input, whole] =
    this->Request;
  const double ends = static_cast<double>(this->Ends.size());
  const double vertices = static_cast<double>(surface.mostPointsOnARank()) * ranks.size();
  return !gathered && ends * ends * verticesOfField > static_cast<double>(starts) * vertices;
}

void DistributedPathFinder::findPiecewise(std::span<const GlobalPoint> starts,
  const Answers& answers, std::span<std::optional<TracedPath>> paths, std::vector<bool>& areKnown)
{
  std::vector<PointPair> pairs;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    if (answers[i].end != NoIndex)
    {
      pairs.push_back({ this->Ends[answers[i].end], starts[i] });
      numbers.push_back(i);
    }
  }
  PathRequest own = this->Request;
  own.options.onProgress = [&](std::size_t steps)
  { return !this->Request.options.onProgress || this->Request.options.onProgress(steps); };
  PiecewisePaths search(own, false);
  std::vector<FoundPath> found = search.find(pairs);
  for (FoundPath& one : found)
  {
    std::reverse(one.path.begin(), one.path.end());
  }
  std::vector<std::optional<TracedPath>> onInput = search.onInput(found);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    areKnown[numbers[i]] = found[i].isKnown;
    if (onInput[i])
    {
      onInput[i]->end = answers[numbers[i]].end;
      paths[numbers[i]] = std::move(onInput[i]);
    }
  }
  this->LargestCorridor = std::max(this->LargestCorridor, search.largestCorridor());
}

DistributedPathFinder::Answers DistributedPathFinder::askFirst(
  const std::function<Answers()>& action)
{
  if (this->Request.ranks.rank() > 0)
  {
    return this->followOrders();
  }
  // If this fails, the other ranks, which wait for orders, throw as well; see Agreement.
  Answers answers = action();
  this->sendOrder(Order::Done, bytesOf<Answer>(answers));
  return answers;
}

DistributedPathFinder::Answers DistributedPathFinder::followOrders()
{
  while (true)
  {
    const RankGroup::Message order = this->Request.ranks.fromFirst({});
    const RankGroup::Message content(order.begin() + 1, order.end());
    if (static_cast<Order>(order.front()) == Order::Done)
    {
      return valuesIn<Answer>(content);
    }
    this->carryOut(static_cast<Order>(order.front()), content);
  }
}

void DistributedPathFinder::carryOut(Order order, const RankGroup::Message& content)
{
  if (order == Order::Solve)
  {
    this->solve(valuesIn<GlobalVertex>(content));
  }
  else if (order == Order::Cut)
  {
    this->cutOnAll(valuesIn<Ball>(content));
  }
  else
  {
    this->OfInput->cutOnAll(valuesIn<GlobalVertex>(content));
  }
}

void DistributedPathFinder::sendOrder(Order order, const RankGroup::Message& content)
{
  RankGroup::Message message{ static_cast<char>(order) };
  message.insert(message.end(), content.begin(), content.end());
  this->Request.ranks.fromFirst(message);
}

std::vector<SurfacePatch> DistributedPathFinder::cutOnAll(std::span<const Ball> balls)
{
  return patchesOfAll(this->Request.ranks, [&] { return this->Cutter->cut(balls, this->Field); });
}

void DistributedPathFinder::solve(std::span<const GlobalVertex> targets)
{
  std::vector<Triangle> local;
  for (const GlobalVertex& target : targets)
  {
    const Index vertex = this->Request.mesh.shared().find(target);
    local.push_back({ vertex, vertex, vertex });
  }
  SolveOptions options = this->Request.options;
  options.partition = &this->Partition;
  options.targets = local;
  options.targetMode = TargetMode::All;
  this->Field = &this->Request.solver.solve(seedsAt(this->Ends), options);
}

}
