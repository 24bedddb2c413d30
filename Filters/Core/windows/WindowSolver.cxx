// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowSolver.h"

#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "windows/WindowRequest.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

WindowSolver::WindowSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
  , Edges(this->mesh())
  , Workspace(this->mesh())
{
}

bool WindowSolver::marchWindows(const char* distances, const WindowMerging* merging,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  checkWindowRequest(distances, request.hasCost, request.partition);
  this->Passable.emplace(this->mesh(), this->Edges, request.options);
  this->keepSeeds(request.seeds);
  this->Found = &field;
  this->Reach = -1.0;
  bool isFinished = false;
  {
    WindowFront front(this->mesh(), this->Edges, request.closed, *this->Passable, request.options,
      request.seeds.size(), leastKeyOf(labels, limit), limit, field, this->Workspace, merging);
    isFinished = marchFrom(request.seeds, this->mesh(), front);
  }
  if (merging)
  {
    for (const Index vertex : field.reached())
    {
      field.lowerDistance(vertex, field.distance(vertex) + this->Workspace.excesses[vertex]);
    }
  }
  // What is nearer than the limit was found, with a bound that is larger by the tolerance at most.
  const double most = merging ? 1.0 + request.options.tolerance : 1.0;
  this->Reach = isFinished ? most * limit.value() : -1.0;
  return isFinished;
}

void WindowSolver::keepSeeds(std::span<const Seed> seeds)
{
  this->SeedPoints.clear();
  this->SeedValues.clear();
  this->ArePoints = std::all_of(
    seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.kind == Seed::Kind::Point; });
  if (this->ArePoints)
  {
    for (const Seed& seed : seeds)
    {
      this->SeedPoints.push_back(seed.points[0]);
      this->SeedValues.push_back(seed.value);
    }
  }
}

std::optional<FoundPath> WindowSolver::pathFrom(const SurfacePoint& start) const
{
  PathStarts::Start found;
  if (const Carriers carriers = carriersOf(this->mesh(), start); carriers.size() == 1)
  {
    const Index vertex = carriers[0];
    if (!this->Workspace.arrivals.empty())
    {
      found = { this->mesh().position(vertex), this->Found->distance(vertex),
        this->Found->nearestSeed(vertex), this->Workspace.arrivals[vertex] };
    }
  }
  else if (const PathStarts::Start* kept = this->Workspace.starts.find(start))
  {
    found = *kept;
  }
  if (!(found.distance < DistanceField::Unreached && found.distance <= this->Reach))
  {
    return std::nullopt;
  }
  if (!this->ArePoints)
  {
    return FoundPath{ found.distance, {} };
  }
  return FoundPath{ found.distance, this->trace(start, found) };
}

}
