// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/DistributedPathFinder.h"

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
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    startsByEnd[answers[i].end].push_back(i);
  }
  startsByEnd.erase(NoIndex);
  std::vector<std::optional<TracedPath>> paths(starts.size());
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
