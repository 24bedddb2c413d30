// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/LinedSurface.h"

#include "global/SharedCostAndBarriers.h"
#include "pieces/DistributedSurface.h"
#include "split/SplitMesh.h"

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
  this->Surface = request.surface;
  this->Divided.reset();
  this->Gathered.reset();
  if (ranks.size() == 1)
  {
    this->Lines.update(
      this->mesh(), localLines(request.seedLines), localLines(request.barrierLines));
  }
  else
  {
    this->gather(ranks, request);
  }
  bridge::SolveSurface surface(this->Surface->sharedPiece(), this->mesh(), this->Lines,
    this->Gathered ? this->Gathered->barriers() : request.barriers,
    this->Gathered ? this->Gathered->cost() : request.cost, request.alongEdges);
  if (this->Gathered)
  {
    this->Divided = std::make_unique<const DividedMesh>(
      ranks, surface.mesh(), this->Gathered->keysOf(*surface.mesh(), this->split()));
    shareExcluded(ranks, *this->Divided, surface.excluded());
  }
  return surface;
}

void LinedSurface::gather(RankGroup& ranks, const LinedRequest& request)
{
  this->Lines = {};
  if (request.seedLines.empty() && request.barrierLines.empty())
  {
    return;
  }
  const auto seedPaths =
    joinedLines(ranks, *this->Surface, request.input, request.seedLines, "SeedSource");
  const auto barrierPaths =
    joinedLines(ranks, *this->Surface, request.input, request.barrierLines, "BarrierSource");
  std::vector<GlobalPath> paths = seedPaths;
  paths.insert(paths.end(), barrierPaths.begin(), barrierPaths.end());
  this->Gathered = std::make_unique<const GatheredSurface>(
    ranks, *this->Surface, paths, request.barriers, request.cost);
  ranks.together(
    [&]
    {
      if (ranks.rank() == 0)
      {
        this->Lines.take(
          this->mesh(), this->Gathered->pathsOf(seedPaths), this->Gathered->pathsOf(barrierPaths));
      }
    });
}

const std::shared_ptr<const TriangleMesh>& LinedSurface::mesh() const
{
  return this->Gathered ? this->Gathered->mesh() : this->Surface->piece().mesh();
}

const DividedMesh& LinedSurface::divided() const
{
  return this->Divided ? *this->Divided : this->Surface->divided();
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
