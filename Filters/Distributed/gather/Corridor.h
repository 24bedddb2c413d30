// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_Corridor_h
#define geodesic_distributed_Corridor_h

#include "gather/SurfacePatch.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/**
 * The part of a surface round a path, joined from patches that ranks cut out of their pieces. A
 * vertex is one by its GlobalVertex, and a triangle that several ranks have is there once.
 */
class Corridor
{
public:
  /**
   * Takes in what all ranks cut along some balls. What it has already takes on the patches'
   * distances.
   */
  void add(std::span<const SurfacePatch> patches, std::span<const Ball> balls);

  std::span<const Ball> balls() const { return this->Balls; }
  const std::vector<PatchVertex>& vertices() const { return this->Vertices; }
  /** Their corners are places in that list. */
  const std::vector<PatchTriangle>& triangles() const { return this->Triangles; }
  /** Whether a vertex, by its place, lies in one of the balls: then it has all its triangles. */
  bool isComplete(std::size_t place) const { return this->Complete[place]; }

private:
  std::uint32_t placeOf(const PatchVertex& vertex);
  void addTriangle(const PatchTriangle& triangle);

  std::vector<Ball> Balls;
  std::vector<PatchVertex> Vertices;
  std::vector<bool> Complete;
  std::vector<PatchTriangle> Triangles;
  std::map<GlobalVertex, std::uint32_t> Places;
  /** The places of triangles by their sorted corners. */
  std::map<std::array<std::uint32_t, 3>, std::size_t> TrianglePlaces;
};

}

#endif
