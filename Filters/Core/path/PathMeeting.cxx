// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathMeeting.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace geodesic
{
namespace
{

/** So many edges are crossed one after the other by paths that have met. */
constexpr std::size_t CommonEdges = 8;

/** Whether the same vertices carry two points. */
bool areOnSameEdge(const PathPoint& a, const PathPoint& b)
{
  const Carriers ofA = a.carriers();
  const Carriers ofB = b.carriers();
  return ofA.size() == ofB.size() &&
    std::all_of(ofA.begin(), ofA.end(), [&](Index vertex) { return ofB.contains(vertex); });
}

}

bool isSmoothAlong(const TriangleMesh& mesh, const SurfacePath& path)
{
  // Of the squares of all angles between faces, which stand for the curvature of the vertices.
  constexpr double most = 0.1;
  double sum = 0.0;
  Vector3 before;
  for (std::size_t i = 1; i < path.size() && sum < most; ++i)
  {
    const auto [a, b, c] = faceOf(mesh, path[i - 1], path[i]);
    const Vector3 normal =
      cross(mesh.position(b) - mesh.position(a), mesh.position(c) - mesh.position(a));
    if (i > 1)
    {
      // The corners of faces come in any order.
      const Vector3 across = cross(before, normal);
      sum += dot(across, across) / (dot(before, before) * dot(normal, normal));
    }
    before = normal;
  }
  return sum < most;
}

PathMeeting::PathMeeting(SurfacePath path)
  : Path(std::move(path))
  , Slots(std::bit_ceil(2 * this->Path.size() + 1), 0)
{
  for (std::size_t i = 1; i < this->Path.size(); ++i)
  {
    std::size_t slot = this->slotOf(this->Path[i]);
    while (this->Slots[slot] != 0)
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    this->Slots[slot] = i;
  }
}

std::size_t PathMeeting::placeOfMeeting(const SurfacePath& other) const
{
  if (other.size() < CommonEdges)
  {
    return 0;
  }
  for (std::size_t slot = this->slotOf(other.back()); this->Slots[slot] != 0;
       slot = (slot + 1) & (this->Slots.size() - 1))
  {
    const std::size_t place = this->Slots[slot];
    std::size_t common = 0;
    while (common < std::min(CommonEdges, place) &&
      areOnSameEdge(this->Path[place - common], other[other.size() - 1 - common]))
    {
      ++common;
    }
    if (common == CommonEdges)
    {
      return place;
    }
  }
  return 0;
}

std::size_t PathMeeting::slotOf(const PathPoint& point) const
{
  // The same for any order of the vertices.
  std::size_t sum = 0;
  for (const Index vertex : point.carriers())
  {
    sum += vertex;
  }
  return ((sum * 0x9E3779B97F4A7C15U) >> 32U) & (this->Slots.size() - 1);
}

}
