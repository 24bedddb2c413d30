// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What the first rank does while the others follow its orders.
#include "algorithm/DistributedPathFinder.h"

#include "algorithm/WholeSurface.h"
#include "gather/GatheredSurface.h"
#include "pieces/DistributedSurface.h"
#include "split/BaseMeshPath.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** After so many attempts the corridor grows along the whole of what is left of a path. */
constexpr int AttemptsByBalls = 4;

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
      this->Collected.add(this->Finder.orderCut(this->Collected.balls()), {});
    }
    return this->Mesh.fieldOf(this->Collected, this->Finder.Field->stopReason());
  }

private:
  DistributedPathFinder& Finder;
  Corridor& Collected;
  CorridorMesh& Mesh;
};

DistributedPathFinder::Answers DistributedPathFinder::leadMarch(std::span<const GlobalPoint> starts)
{
  bool isMarched = false;
  if (this->OnWhole)
  {
    isMarched = this->OnWhole->march(this->Request.whole->corridor()->pointsOf(starts));
    return { { isMarched ? 0 : NoIndex } };
  }
  this->shrinkCorridor();
  this->extend(ballsRound(starts));
  this->onCorridor(
    [&](PathFinder& finder, const CorridorPointer& corridor)
    {
      isMarched = finder.march(corridor->pointsOf(starts));
      return std::vector<PatchVertex>();
    });
  return { { isMarched ? 0 : NoIndex } };
}

DistributedPathFinder::Answers DistributedPathFinder::leadToNearest(
  std::span<const GlobalPoint> starts)
{
  Answers answers;
  this->shrinkCorridor();
  this->extend(ballsRound(starts));
  this->onCorridor(
    [&](PathFinder& finder, const CorridorPointer& corridor)
    {
      const std::vector<SurfacePoint> points = corridor->pointsOf(starts);
      answers.assign(starts.size(), {});
      const bool isMarched = finder.march(points);
      for (std::size_t i = 0; i < points.size() && isMarched; ++i)
      {
        answers[i].end = finder.nearestSeed(points[i]);
      }
      return std::vector<PatchVertex>();
    });
  return answers;
}

DistributedPathFinder::Answers DistributedPathFinder::leadPaths(
  std::span<const GlobalPoint> starts, std::span<TracedPath> traced)
{
  Answers answers;
  while (answers.size() < starts.size())
  {
    const Answers some =
      this->leadSomePaths(starts.subspan(answers.size()), traced.subspan(answers.size()));
    answers.insert(answers.end(), some.begin(), some.end());
  }
  return answers;
}

DistributedPathFinder::Answers DistributedPathFinder::leadSomePaths(
  std::span<const GlobalPoint> starts, std::span<TracedPath> traced)
{
  Answers answers(starts.size());
  std::vector<bool> isPending(starts.size(), true);
  if (this->OnWhole)
  {
    this->tracePaths(
      starts, *this->OnWhole, this->Request.whole->corridor(), isPending, answers, traced);
    return answers;
  }
  try
  {
    std::size_t count = std::min(starts.size(), this->Together);
    bool haveRoom = true;
    this->shrinkCorridor();
    while (!this->scout().followFrom(starts.first(count),
      count == 1 ? std::numeric_limits<std::size_t>::max() : this->mostPointsOfCorridor()))
    {
      count = (count + 1) / 2;
      haveRoom = false;
      this->Along.reset();
      this->shrinkCorridor();
    }
    this->Together = haveRoom ? 2 * count : count;
    starts = starts.first(count);
    answers.resize(count);
    isPending.resize(count);
    this->onCorridor([&](PathFinder& finder, const CorridorPointer& corridor)
      { return this->tracePaths(starts, finder, corridor, isPending, answers, traced); });
  }
  catch (const SearchCancelled&)
  {
    // What is not found is none.
  }
  return answers;
}

std::vector<PatchVertex> DistributedPathFinder::tracePaths(std::span<const GlobalPoint> starts,
  PathFinder& finder, const CorridorPointer& corridor, std::vector<bool>& isPending,
  Answers& answers, std::span<TracedPath> traced)
{
  const std::vector<SurfacePoint> points = corridor->pointsOf(starts);
  std::vector<SurfacePoint> pending;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (isPending[i])
    {
      pending.push_back(points[i]);
    }
  }
  if (!this->OnWhole && !finder.march(pending))
  {
    return {};
  }
  std::map<GlobalVertex, PatchVertex> missing;
  std::vector<TracedPath*> found;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!isPending[i])
    {
      continue;
    }
    try
    {
      if (auto path = finder.pathFrom(points[i]))
      {
        answers[i] = { finder.seedAtEnd(*path), finder.isProvenShortest() ? 1u : 0u };
        traced[i].cost = finder.cost();
        traced[i].path = std::move(*path);
        found.push_back(&traced[i]);
      }
      isPending[i] = false;
    }
    catch (const IncompleteRing& end)
    {
      const PatchVertex& vertex = corridor->vertex(end.vertex());
      missing.emplace(vertex.vertex, vertex);
    }
  }
  if (!found.empty())
  {
    this->takeToInput(found, *corridor);
  }
  std::vector<PatchVertex> vertices;
  std::transform(missing.begin(), missing.end(), std::back_inserter(vertices),
    [](const auto& entry) { return entry.second; });
  return vertices;
}

void DistributedPathFinder::onCorridor(const Attempt& attempt)
{
  const auto missingIn = [&]
  {
    this->LargestCorridor = std::max(this->LargestCorridor, this->Along->vertices().size());
    const auto mesh = std::make_shared<CorridorMesh>(*this->Along, this->HasCost);
    CorridorSolver source(*this, *this->Along, *mesh);
    SolveOptions options = mesh->options();
    options.onProgress = this->Request.options.onProgress;
    PathFinder finder(source, mesh->pointsOf(this->Ends), options, this->Request.style);
    try
    {
      return attempt(finder, mesh);
    }
    catch (const IncompleteRing& end)
    {
      return std::vector<PatchVertex>{ mesh->vertex(end.vertex()) };
    }
  };
  std::vector<PatchVertex> missing = missingIn();
  for (int attempts = 1; !missing.empty(); ++attempts)
  {
    if (attempts > AttemptsByBalls)
    {
      try
      {
        this->scout().followFrom(missing);
      }
      catch (const SearchCancelled&)
      {
        return;
      }
    }
    else
    {
      std::vector<Ball> balls;
      for (const PatchVertex& vertex : missing)
      {
        balls.push_back({ vertex.position, PathScout::ReachInEdges * vertex.longestEdge });
      }
      this->extend(balls);
    }
    missing = missingIn();
  }
}

void DistributedPathFinder::shrinkCorridor()
{
  if (!this->Along ||
    this->Along->vertices().size() - this->PointsAtEnds > this->mostPointsOfCorridor() / 2)
  {
    this->Along.emplace();
    this->PointsAtEnds = 0;
    this->extend(ballsRound(this->Ends));
    this->PointsAtEnds = this->Along->vertices().size();
  }
}

std::size_t DistributedPathFinder::mostPointsOfCorridor() const
{
  return this->PointsAtEnds + roomOfCorridor(this->Request.surface.mostPointsOnARank());
}

PathScout DistributedPathFinder::scout()
{
  return { *this->Along, this->Ends, this->Request.style, this->Request.options, this->HasCost,
    [this](std::span<const Ball> balls) { return this->orderCut(balls); } };
}

std::vector<SurfacePatch> DistributedPathFinder::orderCut(std::span<const Ball> balls)
{
  this->sendOrder(Order::Cut, bytesOf(balls));
  return this->cutOnAll(balls);
}

void DistributedPathFinder::extend(std::span<const Ball> balls)
{
  this->Along->add(this->orderCut(balls), balls);
}

void DistributedPathFinder::takeToInput(std::span<TracedPath*> paths, const CorridorMesh& corridor)
{
  std::vector<GlobalVertex> carriers;
  std::unordered_map<GlobalVertex, Index, HashOfVertex> numbers;
  const auto numberOf = [&](const GlobalVertex& vertex)
  {
    const auto [known, isNew] = numbers.emplace(vertex, static_cast<Index>(carriers.size()));
    if (isNew)
    {
      carriers.push_back(vertex);
    }
    return known->second;
  };
  const auto foundOriginOf = [&](Index vertex)
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
  std::unordered_map<Index, PathPoint> origins;
  const auto originOf = [&](Index vertex)
  {
    const auto [known, isNew] = origins.try_emplace(vertex);
    if (isNew)
    {
      known->second = foundOriginOf(vertex);
    }
    return known->second;
  };
  for (TracedPath* traced : paths)
  {
    traced->path = basePath(corridor.mesh(), traced->path, originOf);
  }
  this->sendOrder(Order::CutInput, bytesOf<GlobalVertex>(carriers));
  Corridor alongPaths;
  alongPaths.add(this->OfInput->cutOnAll(carriers), {});
  const auto onInput = std::make_shared<const CorridorMesh>(alongPaths, false);
  std::vector<Index> vertices;
  std::transform(carriers.begin(), carriers.end(), std::back_inserter(vertices),
    [&](const GlobalVertex& carrier) { return onInput->find(carrier); });
  for (TracedPath* traced : paths)
  {
    traced->corridor = onInput;
    for (PathPoint& point : traced->path)
    {
      for (Index& corner : point.corners)
      {
        corner = vertices[corner];
      }
    }
  }
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
  return true;
}

}
