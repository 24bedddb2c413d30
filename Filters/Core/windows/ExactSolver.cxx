// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/ExactSolver.h"

#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "windows/WindowPath.h"
#include "windows/WindowRequest.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geodesic
{

ExactSolver::ExactSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
  , Edges(this->mesh())
  , Workspace(this->mesh())
{
}

bool ExactSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  checkWindowRequest("Exact distances", request.hasCost, request.partition);
  this->Passable.emplace(this->mesh(), this->Edges, request.options);
  this->keepSeeds(request.seeds);
  this->Found = &field;
  this->Reach = -1.0;
  WindowFront front(this->mesh(), this->Edges, request.closed, *this->Passable, request.options,
    leastKeyOf(labels, limit), limit, field, this->Workspace);
  const bool finished = marchFrom(request.seeds, this->mesh(), front);
  this->Reach = finished ? limit.value() : -1.0;
  return finished;
}

void ExactSolver::keepSeeds(std::span<const Seed> seeds)
{
  this->Seeds.clear();
  this->ArePoints = std::all_of(
    seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.kind == Seed::Kind::Point; });
  if (this->ArePoints)
  {
    std::transform(seeds.begin(), seeds.end(), std::back_inserter(this->Seeds),
      [](const Seed& seed) { return seed.points[0]; });
  }
}

std::optional<FoundPath> ExactSolver::pathFrom(const SurfacePoint& start) const
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
  WindowPath path(this->mesh(), this->Edges, *this->Passable, *this->Found, this->Seeds,
    this->Workspace.arrivals);
  return FoundPath{ found.distance, path.from(start, found.distance, found.seed, found.arrival) };
}

}
