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
      const std::uint32_t place = this->placeOf(vertex);
      places.push_back(place);
      const Vector3& position = this->Vertices[place].position;
      this->Complete[place] = this->Complete[place] ||
        std::any_of(
          balls.begin(), balls.end(), [&](const Ball& ball) { return ball.contains(position); });
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

std::uint32_t Corridor::placeOf(const PatchVertex& vertex)
{
  const auto [known, isNew] =
    this->Places.emplace(vertex.vertex, static_cast<std::uint32_t>(this->Vertices.size()));
  if (isNew)
  {
    this->Vertices.push_back(vertex);
    this->Complete.push_back(false);
  }
  else
  {
    this->Vertices[known->second].distance = vertex.distance;
    this->Vertices[known->second].nearestSeed = vertex.nearestSeed;
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
