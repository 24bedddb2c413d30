// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/LinedSurface.h"

#include "global/SharedCostAndBarriers.h"
#include "pieces/DistributedSurface.h"
#include "split/SplitMesh.h"

#include <algorithm>
#include <array>

namespace geodesic::distributed
{
namespace
{

/** Returns the points of lines on the mesh, if there is only one rank. */
std::vector<bridge::LinePoints> localLines(const GlobalLines& lines)
{
  std::vector<bridge::LinePoints> local;
  for (const std::vector<GlobalPoint>& line : lines)
  {
    bridge::LinePoints& points = local.emplace_back();
    for (const GlobalPoint& point : line)
    {
      points.push_back(point.local.front());
    }
  }
  return local;
}

}

bridge::SolveSurface LinedSurface::update(RankGroup& ranks, const LinedRequest& request)
{
  if (ranks.size() == 1)
  {
    this->Surface = request.surface;
    this->Barriers = request.barriers;
    this->Lines.update(
      this->mesh(), localLines(request.seedLines), localLines(request.barrierLines));
  }
  else
  {
    this->updateOnSeveral(ranks, request);
  }
  bridge::SolveSurface surface(this->Surface->sharedPiece(), this->mesh(), this->Lines,
    this->Gathered ? this->Gathered->barriers() : request.barriers,
    this->Gathered ? this->Gathered->cost() : request.cost, request.alongEdges);
  if (this->Gathered)
  {
    if (!this->Divided)
    {
      this->Divided = std::make_shared<const DividedMesh>(
        ranks, surface.mesh(), this->Gathered->keysOf(*surface.mesh(), this->split()));
    }
    shareExcluded(ranks, *this->Divided, surface.excluded());
  }
  return surface;
}

void LinedSurface::updateOnSeveral(RankGroup& ranks, const LinedRequest& request)
{
  const bool hasSameLines = this->Surface == request.surface &&
    this->Known.seedLines == request.seedLines && this->Known.barrierLines == request.barrierLines;
  const bool hasSameValues = this->Barriers == request.barriers && this->Cost == request.cost;
  std::array areSame{ hasSameLines ? 1.0 : 0.0, hasSameValues ? 1.0 : 0.0 };
  ranks.takeLeast(areSame);
  const bool hasLines = !request.seedLines.empty() || !request.barrierLines.empty();
  const bool mustJoin = areSame[0] == 0.0;
  const bool mustGather = mustJoin || (hasLines && areSame[1] == 0.0);
  if (mustGather)
  {
    this->Divided.reset();
    this->Gathered.reset();
    this->Lines = {};
    this->Surface = request.surface;
  }
  if (mustJoin)
  {
    this->join(ranks, request);
  }
  if (mustGather && hasLines)
  {
    this->gather(ranks, request);
  }
}

void LinedSurface::join(RankGroup& ranks, const LinedRequest& request)
{
  this->Known = { request.seedLines, request.barrierLines,
    joinedLines(ranks, *this->Surface, request.input, request.seedLines, "SeedSource"),
    joinedLines(ranks, *this->Surface, request.input, request.barrierLines, "BarrierSource") };
}

void LinedSurface::gather(RankGroup& ranks, const LinedRequest& request)
{
  const Joined& lines = this->Known;
  std::vector<GlobalPath> paths = lines.seedPaths;
  paths.insert(paths.end(), lines.barrierPaths.begin(), lines.barrierPaths.end());
  this->Gathered = std::make_unique<const GatheredSurface>(
    ranks, *this->Surface, paths, request.barriers, request.cost);
  ranks.together(
    [&]
    {
      if (ranks.rank() == 0)
      {
        this->Lines.take(this->mesh(), this->Gathered->pathsOf(lines.seedPaths),
          this->Gathered->pathsOf(lines.barrierPaths));
      }
      this->Barriers = request.barriers;
      this->Cost = request.cost;
    });
}

const std::shared_ptr<const TriangleMesh>& LinedSurface::mesh() const
{
  return this->Gathered ? this->Gathered->mesh() : this->Surface->piece().mesh();
}

const std::shared_ptr<const DividedMesh>& LinedSurface::sharedDivided() const
{
  return this->Divided ? this->Divided : this->Surface->sharedDivided();
}

std::size_t LinedSurface::numberOfOwnReached(const DistanceField& field) const
{
  const SplitMesh* split = this->split();
  return static_cast<std::size_t>(std::count_if(field.reached().begin(), field.reached().end(),
    [&](Index vertex) {
      return this->divided().shared().owns(vertex) && (!split || isVertex(split->origin(vertex)));
    }));
}

std::vector<GlobalPoint> LinedSurface::relocated(std::vector<GlobalPoint> points) const
{
  for (GlobalPoint& point : points)
  {
    if (this->Gathered)
    {
      this->Gathered->relocate(point);
    }
  }
  return points;
}

}
