// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/DistributedPathFinder.h"

#include "algorithm/WholeSurface.h"
#include "gather/GatheredSurface.h"
#include "global/GlobalSeeds.h"
#include "pieces/DistributedSurface.h"
#include "split/BaseMeshPath.h"

#include <algorithm>
#include <map>

namespace geodesic::distributed
{
namespace
{

/**
 * The radius of the ball by which a corridor grows where a path needs more triangles, in longest
 * edges there. It lets the path go on for a while, and brings few triangles that are too far beside
 * the path.
 */
constexpr double ReachInEdges = 8.0;

template <class T>
RankGroup::Message bytesOf(std::span<const T> values)
{
  RankGroup::Message message;
  for (const T& value : values)
  {
    append(message, value);
  }
  return message;
}

/** Returns balls that contain the corners of the triangles with the points. */
std::vector<Ball> ballsRound(std::span<const GlobalPoint> points)
{
  constexpr double rounding = 1e-6;
  std::vector<Ball> balls;
  for (const GlobalPoint& point : points)
  {
    balls.push_back({ point.position, (1.0 + rounding) * point.longestEdge });
  }
  return balls;
}

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

/** A solver on the corridor, which returns the field that all ranks solve together. */
class DistributedPathFinder::CorridorSolver final : public DistanceSolver
{
public:
  CorridorSolver(DistributedPathFinder& finder, Corridor& corridor, CorridorMesh& mesh)
    : Finder(finder)
    , Collected(corridor)
    , Mesh(mesh)
  {
  }

  const TriangleMesh& mesh() const override { return this->Mesh.mesh(); }

  const DistanceField& solve(std::span<const Seed>, const SolveOptions& options) override
  {
    std::vector<GlobalVertex> targets;
    for (const Triangle& target : options.targets)
    {
      targets.push_back(this->Mesh.vertex(target[0]).vertex);
    }
    if (this->Finder.reach(targets))
    {
      const std::vector<Ball> balls(this->Collected.balls().begin(), this->Collected.balls().end());
      this->Finder.sendOrder(Order::Cut, bytesOf<Ball>(balls));
      this->Collected.add(this->Finder.cutOnAll(balls), {});
    }
    return this->Mesh.fieldOf(this->Collected, this->Finder.Field->stopReason());
  }

private:
  DistributedPathFinder& Finder;
  Corridor& Collected;
  CorridorMesh& Mesh;
};

DistributedPathFinder::DistributedPathFinder(
  const PathRequest& request, std::vector<GlobalPoint> ends)
  : Request(request)
  , Ends(std::move(ends))
  , Partition(request.ranks, request.mesh)
{
  if (request.ranks.size() == 1)
  {
    this->Whole.emplace(request.solver, localPoints(this->Ends), request.options, request.style);
    return;
  }
  this->InputCutter.emplace(request.surface.divided(), SolveOptions());
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
  return this->onCorridor(starts,
           [&](PathFinder& finder, const std::shared_ptr<const CorridorMesh>& corridor)
           { return finder.march(corridor->pointsOf(starts)) ? Index{ 1 } : Index{ 0 }; }) == 1;
}

std::optional<TracedPath> DistributedPathFinder::pathFrom(const GlobalPoint& start)
{
  TracedPath traced;
  if (this->Whole)
  {
    auto path = this->Whole->pathFrom(start.local.front());
    if (!path)
    {
      return std::nullopt;
    }
    traced.end = this->Whole->seedAtEnd(*path);
    traced.cost = this->Whole->cost();
    traced.isProvenShortest = this->Whole->isProvenShortest();
    traced.path = std::move(*path);
    return traced;
  }
  if (this->EdgeSolver)
  {
    return this->pathAlongEdgesFrom(start);
  }
  traced.end = this->onCorridor({ &start, 1 },
    [&](PathFinder& finder, const std::shared_ptr<const CorridorMesh>& corridor)
    {
      const SurfacePoint local = corridor->pointsOf({ &start, 1 }).front();
      const bool isMarched = this->OnWhole || finder.march({ &local, 1 });
      auto path = isMarched ? finder.pathFrom(local) : std::nullopt;
      if (!path)
      {
        return NoIndex;
      }
      traced.cost = finder.cost();
      traced.isProvenShortest = finder.isProvenShortest();
      this->takeToInput(*path, *corridor, traced);
      return finder.seedAtEnd(*path);
    });
  traced.isProvenShortest = this->Request.ranks.isAny(traced.isProvenShortest);
  return traced.end == NoIndex ? std::nullopt : std::optional(std::move(traced));
}

std::optional<TracedPath> DistributedPathFinder::pathAlongEdgesFrom(const GlobalPoint& start)
{
  Index end = 0;
  if (this->Ends.size() > 1)
  {
    end = this->onCorridor({ &start, 1 },
      [&](PathFinder& finder, const std::shared_ptr<const CorridorMesh>& corridor)
      {
        const SurfacePoint local = corridor->pointsOf({ &start, 1 }).front();
        return finder.march({ &local, 1 }) ? finder.nearestSeed(local) : NoIndex;
      });
  }
  if (end == NoIndex)
  {
    return std::nullopt;
  }
  const PathRequest& own = this->Request;
  const PathRequest request{ own.ranks, own.surface, own.gathered, own.split, own.mesh,
    *this->EdgeSolver, own.options, own.style, own.input, nullptr };
  DistributedPathFinder finder(request, { this->Ends[end] });
  auto traced = finder.march({ &start, 1 }) ? finder.pathFrom(start) : std::nullopt;
  if (traced)
  {
    traced->end = end;
  }
  this->LargestCorridor = std::max(this->LargestCorridor, finder.LargestCorridor);
  return traced;
}

Index DistributedPathFinder::onCorridor(std::span<const GlobalPoint> points, const Action& action)
{
  if (this->Request.ranks.rank() > 0)
  {
    return this->followOrders();
  }
  // If this fails, the other ranks, which wait for orders, throw as well; see Agreement.
  const Index answer = this->lead(points, action);
  this->sendOrder(Order::Done, bytesOf<Index>({ &answer, 1 }));
  return answer;
}

Index DistributedPathFinder::lead(std::span<const GlobalPoint> points, const Action& action)
{
  if (this->OnWhole)
  {
    return action(*this->OnWhole, this->Request.whole->corridor());
  }
  if (!this->FirstCorridor)
  {
    Corridor first;
    this->extend(first, ballsRound(this->Ends));
    this->FirstCorridor = std::move(first);
  }
  Corridor corridor = *this->FirstCorridor;
  this->extend(corridor, ballsRound(points));
  while (true)
  {
    const auto mesh = std::make_shared<CorridorMesh>(corridor, this->HasCost);
    try
    {
      CorridorSolver source(*this, corridor, *mesh);
      SolveOptions options = mesh->options();
      options.onProgress = this->Request.options.onProgress;
      PathFinder finder(source, mesh->pointsOf(this->Ends), options, this->Request.style);
      return action(finder, mesh);
    }
    catch (const IncompleteRing& end)
    {
      const PatchVertex& vertex = mesh->vertex(end.vertex());
      const Ball ball{ vertex.position, ReachInEdges * vertex.longestEdge };
      this->extend(corridor, { &ball, 1 });
    }
  }
}

Index DistributedPathFinder::followOrders()
{
  while (true)
  {
    const RankGroup::Message order = this->Request.ranks.fromFirst({});
    const RankGroup::Message content(order.begin() + 1, order.end());
    if (static_cast<Order>(order.front()) == Order::Done)
    {
      return valuesIn<Index>(content).front();
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
    this->cutInputOnAll(valuesIn<GlobalVertex>(content));
  }
}

void DistributedPathFinder::sendOrder(Order order, const RankGroup::Message& content)
{
  RankGroup::Message message{ static_cast<char>(order) };
  message.insert(message.end(), content.begin(), content.end());
  this->Request.ranks.fromFirst(message);
}

void DistributedPathFinder::extend(Corridor& corridor, std::span<const Ball> balls)
{
  this->sendOrder(Order::Cut, bytesOf(balls));
  corridor.add(this->cutOnAll(balls), balls);
  this->LargestCorridor = std::max(this->LargestCorridor, corridor.vertices().size());
}

std::vector<SurfacePatch> DistributedPathFinder::cutOnAll(std::span<const Ball> balls)
{
  return patchesOfAll(this->Request.ranks, [&] { return this->Cutter->cut(balls, this->Field); });
}

void DistributedPathFinder::takeToInput(
  const SurfacePath& path, const CorridorMesh& corridor, TracedPath& traced)
{
  std::vector<GlobalVertex> carriers;
  std::map<GlobalVertex, Index> numbers;
  const auto numberOf = [&](const GlobalVertex& vertex)
  {
    const auto [known, isNew] = numbers.emplace(vertex, static_cast<Index>(carriers.size()));
    if (isNew)
    {
      carriers.push_back(vertex);
    }
    return known->second;
  };
  const auto originOf = [&](Index vertex)
  {
    const GlobalVertex global = corridor.vertex(vertex).vertex;
    if (!this->Request.gathered)
    {
      return PathPoint::atVertex(numberOf(global));
    }
    const GlobalPathPoint origin = this->Request.gathered->originOf(global, this->Request.split);
    PathPoint point{ {}, origin.weights };
    std::transform(origin.corners.begin(), origin.corners.end(), point.corners.begin(), numberOf);
    return point;
  };
  traced.path = basePath(corridor.mesh(), path, originOf);
  this->sendOrder(Order::CutInput, bytesOf<GlobalVertex>(carriers));
  Corridor alongPath;
  alongPath.add(this->cutInputOnAll(carriers), {});
  traced.corridor = std::make_shared<const CorridorMesh>(alongPath, false);
  for (PathPoint& point : traced.path)
  {
    for (Index& corner : point.corners)
    {
      corner = traced.corridor->find(carriers[corner]);
    }
  }
}

std::vector<SurfacePatch> DistributedPathFinder::cutInputOnAll(
  std::span<const GlobalVertex> vertices)
{
  const DistributedSurface& surface = this->Request.surface;
  std::vector<Index> local;
  for (const GlobalVertex& vertex : vertices)
  {
    if (const Index known = surface.shared().find(vertex); known != NoIndex)
    {
      local.push_back(known);
    }
  }
  return patchesOfAll(this->Request.ranks,
    [&]
    {
      SurfacePatch patch = this->InputCutter->cutRound(local, nullptr);
      for (PatchVertex& vertex : patch.vertices)
      {
        const Index number = surface.shared().find(vertex.vertex);
        const std::optional<Vector3> normal = this->Request.input.normalOf(number);
        vertex.hasNormal = normal ? 1 : 0;
        vertex.normal = normal.value_or(Vector3{});
        vertex.id =
          surface.piece().numbering().hasUniqueIds() ? this->Request.input.idOf(number) : -1;
      }
      return patch;
    });
}

bool DistributedPathFinder::reach(const std::vector<GlobalVertex>& targets)
{
  const bool reachesAll = this->Field && this->Field->stopReason() == StopReason::Exhausted;
  const bool reachesThese = !targets.empty() &&
    std::all_of(targets.begin(), targets.end(),
      [&](const GlobalVertex& target) { return this->Reached.contains(target); });
  if (reachesAll || reachesThese)
  {
    return false;
  }
  this->Reached.insert(targets.begin(), targets.end());
  // Later paths may need the targets of earlier paths again.
  std::vector<GlobalVertex> all;
  if (!targets.empty())
  {
    all.assign(this->Reached.begin(), this->Reached.end());
  }
  this->sendOrder(Order::Solve, bytesOf<GlobalVertex>(all));
  this->solve(all);
  this->FirstCorridor.reset();
  return true;
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
