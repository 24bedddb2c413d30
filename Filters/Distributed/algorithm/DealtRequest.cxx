// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/DealtRequest.h"

#include "global/GlobalPoints.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceSolver.h"

#include <array>
#include <utility>

namespace geodesic::distributed
{

DealtRequest::DealtRequest(RankGroup& ranks, const DealtSurface& dealt, const SolveOptions& options,
  std::vector<Seed> seeds, const DealtSurface::Places& destinations)
  : Options(options)
{
  if (ranks.isAny(!options.cost.empty()))
  {
    this->Cost = dealt.ofVertices(ranks, options.cost);
  }
  if (ranks.isAny(!options.excluded.empty()))
  {
    this->Excluded = dealt.ofVertices(ranks, options.excluded);
  }
  if (ranks.isAny(!options.closedTriangles.empty()))
  {
    this->Closed = dealt.ofTriangles(ranks, options.closedTriangles);
  }
  for (const auto& place : dealt.places(ranks, destinations))
  {
    this->Targets.push_back(targetAt(dealt.mesh(), place));
  }
  this->Seeds = dealt.seeds(ranks, std::move(seeds));
  this->Options.cost = this->Cost;
  this->Options.excluded = this->Excluded;
  this->Options.closedTriangles = this->Closed;
  this->Options.targets = this->Targets;
  this->Options.partition = nullptr;
}

std::pair<const DistanceField*, StopReason> solveOnFirst(
  RankGroup& ranks, DealtRequest& request, DistanceSolver& solver)
{
  const DistanceField* field = nullptr;
  ranks.together([&]
    { field = ranks.rank() == 0 ? &solver.solve(request.seeds(), request.options()) : nullptr; });
  std::array reason{ field ? static_cast<double>(field->stopReason()) : 1e9 };
  ranks.takeLeast(reason);
  return { field, static_cast<StopReason>(static_cast<int>(reason[0])) };
}

}
