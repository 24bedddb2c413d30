// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of TriangleMesh that find triangles and points on it.

#include "base/SortUnique.h"
#include "base/WorkCount.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <iterator>

namespace geodesic
{

SurfacePoint TriangleMesh::pointAtVertex(Index vertex) const
{
  const std::span<const RingEntry> ring = this->ring(vertex);
  const auto open = std::find_if(
    ring.begin(), ring.end(), [](const RingEntry& entry) { return entry.opensTriangle(); });
  SurfacePoint point;
  point.triangle =
    this->trianglesOf({ vertex, open->neighbour(), std::next(open)->neighbour() }).front();
  for (int c = 0; c < 3; ++c)
  {
    point.weights[c] = this->Triangles[point.triangle][c] == vertex ? 1.0 : 0.0;
  }
  return point;
}

std::vector<Index> TriangleMesh::trianglesWith(std::span<const Index> corners) const
{
  if (corners.size() == 3)
  {
    return this->trianglesOf({ corners[0], corners[1], corners[2] });
  }
  std::vector<Index> found;
  this->visitTrianglesWith(corners,
    [&](Index, std::size_t, const Triangle& wanted)
    {
      const std::vector<Index> same = this->trianglesOf(wanted);
      found.insert(found.end(), same.begin(), same.end());
    });
  sortUnique(found);
  return found;
}

bool TriangleMesh::hasTriangleWith(std::span<const Index> corners) const
{
  if (corners.size() == 3)
  {
    return !this->trianglesOf({ corners[0], corners[1], corners[2] }).empty();
  }
  bool hasAny = false;
  this->visitTrianglesWith(corners, [&](Index, std::size_t, const Triangle&) { hasAny = true; });
  return hasAny;
}

Index TriangleMesh::firstTriangleWith(std::span<const Index> corners) const
{
  if (corners.size() == 3)
  {
    const std::vector<Index> same = this->trianglesOf({ corners[0], corners[1], corners[2] });
    return same.empty() ? NoIndex : same.front();
  }
  Index lowest = NoIndex;
  std::ptrdiff_t count = 0;
  Triangle least{ NoIndex, NoIndex, NoIndex };
  this->visitTrianglesWith(corners,
    [&](Index, std::size_t, const Triangle& t)
    {
      const Index ofThis = lowestCorner(t);
      count = ofThis < lowest ? 1 : count + (ofThis == lowest ? 1 : 0);
      lowest = std::min(lowest, ofThis);
      least = std::min(least, sortedCorners(t));
    });
  if (lowest == NoIndex)
  {
    return NoIndex;
  }
  Index first = this->trianglesOf(least).front();
  if (count > 1 && count <= MostUnsorted)
  {
    this->visitTrianglesWith(corners,
      [&](Index, std::size_t, const Triangle& t)
      {
        if (lowestCorner(t) == lowest)
        {
          first = std::min(first, this->trianglesOf(t).front());
        }
      });
  }
  return first;
}

std::vector<Index> TriangleMesh::trianglesOf(const Triangle& corners) const
{
  const Triangle wanted = sortedCorners(corners);
  const auto isBefore = [](const Triangle& t, Index lowest) { return lowestCorner(t) < lowest; };
  const auto isAfter = [](Index lowest, const Triangle& t) { return lowest < lowestCorner(t); };
  auto first =
    std::lower_bound(this->Triangles.begin(), this->Triangles.end(), wanted[0], isBefore);
  // Most vertices are the lowest corner of few triangles, which are looked at one by one.
  const auto near = std::min<std::ptrdiff_t>(MostUnsorted + 1, this->Triangles.end() - first);
  auto last = std::find_if(
    first, first + near, [&](const Triangle& t) { return lowestCorner(t) != wanted[0]; });
  if (last - first > MostUnsorted)
  {
    last = std::upper_bound(first, this->Triangles.end(), wanted[0], isAfter);
    first = std::lower_bound(first, last, wanted,
      [](const Triangle& t, const Triangle& than) { return sortedCorners(t) < than; });
    last = std::upper_bound(first, last, wanted,
      [](const Triangle& than, const Triangle& t) { return than < sortedCorners(t); });
  }
  WorkCount::add(last - first);
  std::vector<Index> found;
  for (auto t = first; t != last; ++t)
  {
    if (sortedCorners(*t) == wanted)
    {
      found.push_back(static_cast<Index>(t - this->Triangles.begin()));
    }
  }
  return found;
}

Vector3 TriangleMesh::positionOf(const SurfacePoint& point) const
{
  const Triangle& corners = this->Triangles[point.triangle];
  return point.weights[0] * this->Positions[corners[0]] +
    point.weights[1] * this->Positions[corners[1]] + point.weights[2] * this->Positions[corners[2]];
}

}
