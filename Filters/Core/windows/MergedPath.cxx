// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/MergedPath.h"

#include "mesh/Carriers.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "solve/PassableTriangles.h"
#include "windows/KeptWindows.h"
#include "windows/LaidTriangle.h"
#include "windows/WindowLine.h"

namespace geodesic
{

MergedPath::MergedPath(const TriangleMesh& mesh, const EdgeTable& edges,
  const PassableTriangles& passable, const KeptWindows& kept, const DistanceField& bounds,
  std::span<const SurfacePoint> seeds, std::span<const double> values,
  std::span<const Arrival> arrivals)
  : Mesh(mesh)
  , Edges(edges)
  , Passable(passable)
  , Kept(kept)
  , Bounds(bounds)
  , Seeds(seeds)
  , Values(values)
  , Arrivals(arrivals)
{
  for (Index i = 0; i < seeds.size(); ++i)
  {
    const Carriers carriers = carriersOf(mesh, seeds[i]);
    if (carriers.size() > 1)
    {
      for (const Index t : mesh.trianglesWith({ carriers.begin(), carriers.end() }))
      {
        this->SeedsOn[t].push_back(i);
      }
    }
  }
}

std::vector<SurfacePoint> MergedPath::from(const SurfacePoint& start, const Arrival& arrival) const
{
  std::vector<SurfacePoint> path{ start };
  Arrival next = arrival;
  // Where rounding makes steps that have no length, there is no end of them.
  std::size_t steps = 64 + 8 * static_cast<std::size_t>(this->Mesh.numberOfTriangles());
  while (next.kind != Arrival::Kind::FromSeed)
  {
    if (steps-- == 0)
    {
      return {};
    }
    if (next.kind == Arrival::Kind::FromVertex)
    {
      path.push_back(this->Mesh.pointAtVertex(next.number));
      next = this->Arrivals[next.number];
    }
    else
    {
      path.push_back(pointOn(this->Mesh, next.number, next.place));
      next = this->before(next.number, this->Mesh.positionOf(path.back()));
    }
  }
  if (next.number == NoIndex)
  {
    return {};
  }
  const SurfacePoint& end = this->Seeds[next.number];
  if (this->Mesh.positionOf(path.back()) != this->Mesh.positionOf(end))
  {
    path.push_back(end);
  }
  return path;
}

Arrival MergedPath::before(Index halfEdge, const Vector3& position) const
{
  Arrival best;
  double least = DistanceField::Unreached;
  const auto consider = [&](double bound, const Arrival& arrival)
  {
    if (bound < least)
    {
      least = bound;
      best = arrival;
    }
  };
  for (Index other = this->Edges.next(halfEdge); other != halfEdge; other = this->Edges.next(other))
  {
    const Index t = EdgeTable::triangleOf(other);
    if (!this->Passable.contains(t))
    {
      continue;
    }
    if (const auto found = this->SeedsOn.find(t); found != this->SeedsOn.end())
    {
      for (const Index seed : found->second)
      {
        consider(this->Values[seed] + norm(this->Mesh.positionOf(this->Seeds[seed]) - position),
          Arrival::fromSeed(seed));
      }
    }
    for (const Index corner : this->Mesh.triangle(t))
    {
      consider(this->Bounds.distance(corner) + norm(this->Mesh.position(corner) - position),
        Arrival::fromVertex(corner));
    }
    for (Index side = 3 * t; side < 3 * t + 3; ++side)
    {
      if (side == other)
      {
        continue;
      }
      const LaidTriangle laid(this->Mesh, side);
      if (!(laid.length > 0.0))
      {
        continue;
      }
      const PlanePoint at = placeBeside(this->Mesh, laid.lower, laid.higher, laid.length, position);
      this->Kept.visit(side,
        [&](const Window& window)
        {
          if (const auto line = lineTo(window, side, at.x, at.y, laid.length))
          {
            consider(line->distance + window.excess, line->arrival);
          }
        });
    }
  }
  return best;
}

}
