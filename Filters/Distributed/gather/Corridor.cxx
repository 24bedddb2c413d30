// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gather/Corridor.h"

#include <algorithm>

namespace geodesic::distributed
{

void Corridor::add(std::span<const SurfacePatch> patches, std::span<const Ball> balls)
{
  for (const SurfacePatch& patch : patches)
  {
    std::vector<std::uint32_t> places;
    for (const PatchVertex& vertex : patch.vertices)
    {
      places.push_back(this->placeOf(vertex));
    }
    for (PatchTriangle triangle : patch.triangles)
    {
      for (std::uint32_t& corner : triangle.corners)
      {
        corner = places[corner];
      }
      this->addTriangle(triangle);
    }
  }
  this->Balls.insert(this->Balls.end(), balls.begin(), balls.end());
}

float Corridor::depthOf(const GlobalVertex& vertex) const
{
  const auto known = this->Places.find(vertex);
  return known == this->Places.end() ? PatchVertex::Outside : this->Vertices[known->second].depth;
}

std::size_t Corridor::HashOfCorners::operator()(const std::array<std::uint32_t, 3>& corners) const
{
  // Odd numbers near the golden ratio of 2^64.
  constexpr std::uint64_t first = 0x9e3779b97f4a7c15;
  constexpr std::uint64_t second = 0xbf58476d1ce4e5b9;
  const std::uint64_t hash = (corners[0] * first) ^ (corners[1] * second);
  return static_cast<std::size_t>((hash ^ hash >> 32) * first + corners[2]);
}

std::uint32_t Corridor::placeOf(const PatchVertex& vertex)
{
  const auto [known, isNew] =
    this->Places.emplace(vertex.vertex, static_cast<std::uint32_t>(this->Vertices.size()));
  if (isNew)
  {
    this->Vertices.push_back(vertex);
  }
  else
  {
    PatchVertex& here = this->Vertices[known->second];
    here.distance = vertex.distance;
    here.nearestSeed = vertex.nearestSeed;
    here.depth = std::max(here.depth, vertex.depth);
  }
  return known->second;
}

void Corridor::addTriangle(const PatchTriangle& triangle)
{
  std::array<std::uint32_t, 3> sorted = triangle.corners;
  std::sort(sorted.begin(), sorted.end());
  const auto [known, isNew] = this->TrianglePlaces.emplace(sorted, this->Triangles.size());
  if (isNew)
  {
    this->Triangles.push_back(triangle);
  }
  else
  {
    this->Triangles[known->second].isClosed |= triangle.isClosed;
  }
}

}
