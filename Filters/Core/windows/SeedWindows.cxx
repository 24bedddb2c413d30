// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/SeedWindows.h"

#include "base/SortUnique.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "windows/WindowFront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace geodesic
{

SeedWindows::SeedWindows(const TriangleMesh& mesh, WindowFront& front)
  : Mesh(mesh)
  , Front(front)
{
}

bool SeedWindows::start(const Seed& seed, Index number)
{
  switch (seed.kind)
  {
    case Seed::Kind::Point:
      this->Front.startAt(seed.points[0], seed.value, number);
      break;
    case Seed::Kind::Curve:
      return this->startCurve(seed, number);
    case Seed::Kind::Region:
      return this->startRegion(seed, number);
  }
  return this->Front.mayGoOn();
}

bool SeedWindows::startCurve(const Seed& seed, Index number)
{
  std::vector<Carriers> carriers;
  carriers.reserve(seed.points.size());
  for (const SurfacePoint& point : seed.points)
  {
    carriers.push_back(carriersOf(this->Mesh, point));
  }
  // Both ways along each edge from vertex to vertex.
  std::vector<std::pair<Index, Index>> sides;
  for (std::size_t i = 0; i + 1 < carriers.size(); ++i)
  {
    if (carriers[i].size() == 1 && carriers[i + 1].size() == 1)
    {
      const Index a = carriers[i][0];
      const Index b = carriers[i + 1][0];
      sides.insert(sides.end(), { { a, b }, { b, a } });
    }
  }
  sortUnique(sides);
  for (std::size_t i = 0; i < carriers.size(); ++i)
  {
    const Index vertex = carriers[i][0];
    if (carriers[i].size() == 1 &&
      !this->sends(vertex,
        [&](Index neighbour)
        { return std::binary_search(sides.begin(), sides.end(), std::pair(vertex, neighbour)); }))
    {
      this->Front.set(vertex, seed.value, number);
    }
    else
    {
      this->Front.startAt(seed.points[i], seed.value, number);
    }
    if (i > 0)
    {
      Carriers both = carriers[i - 1];
      for (const Index carrier : carriers[i])
      {
        both.add(carrier);
      }
      for (const Index t : this->Mesh.trianglesWith({ both.begin(), both.end() }))
      {
        this->Front.startAlong(t, seed.points[i - 1], seed.points[i], seed.value, number);
      }
    }
    if (!this->Front.mayGoOn())
    {
      return false;
    }
  }
  return true;
}

bool SeedWindows::startRegion(const Seed& seed, Index number)
{
  std::vector<Index> vertices = seed.vertices;
  sortUnique(vertices);
  const auto isInside = [&](Index vertex)
  { return std::binary_search(vertices.begin(), vertices.end(), vertex); };
  for (const Index vertex : vertices)
  {
    if (this->sends(vertex, isInside))
    {
      this->Front.startAt(this->Mesh.pointAtVertex(vertex), seed.value, number);
    }
    else
    {
      this->Front.set(vertex, seed.value, number);
    }
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
      const Index a = ring[i].neighbour();
      const Index b = ring[i + 1].neighbour();
      // Of each edge between the region and a corner outside, the lower vertex takes care.
      if (!ring[i].opensTriangle() || isInside(a) == isInside(b))
      {
        continue;
      }
      const Index other = isInside(a) ? a : b;
      const std::array corners{ vertex, a, b };
      for (const Index t :
        other > vertex ? this->Mesh.trianglesWith(corners) : std::vector<Index>{})
      {
        this->Front.startAlong(
          t, this->Mesh.pointAtVertex(vertex), this->Mesh.pointAtVertex(other), seed.value, number);
      }
    }
    if (!this->Front.mayGoOn())
    {
      return false;
    }
  }
  return true;
}

template <class IsSide>
bool SeedWindows::sends(Index vertex, const IsSide& isSide) const
{
  constexpr double rounding = 1e-12;
  constexpr double halfTurn = std::numbers::pi * (1.0 + rounding);
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  std::size_t first = 0;
  while (first < ring.size())
  {
    std::size_t last = first;
    while (ring[last].opensTriangle())
    {
      ++last;
    }
    const bool isClosed = last > first && ring[first].neighbour() == ring[last].neighbour();
    // The angle from the border, or the last side, on; and that before the first side.
    double angle = 0.0;
    double before = -1.0;
    for (std::size_t i = first; i <= last; ++i)
    {
      if (isSide(ring[i].neighbour()))
      {
        const bool isFirst = before < 0.0;
        before = isFirst ? angle : before;
        if (!isFirst && angle > halfTurn)
        {
          return true;
        }
        angle = 0.0;
      }
      if (i < last)
      {
        angle += this->angleAt(vertex, ring[i].neighbour(), ring[i + 1].neighbour());
      }
    }
    const bool hasSide = before >= 0.0;
    if (!hasSide ||
      (isClosed ? before + angle > halfTurn : std::max(before, angle) > 0.5 * halfTurn))
    {
      return true;
    }
    first = last + 1;
  }
  return false;
}

double SeedWindows::angleAt(Index vertex, Index a, Index b) const
{
  const Vector3 toA = this->Mesh.position(a) - this->Mesh.position(vertex);
  const Vector3 toB = this->Mesh.position(b) - this->Mesh.position(vertex);
  return std::atan2(norm(cross(toA, toB)), dot(toA, toB));
}

}
