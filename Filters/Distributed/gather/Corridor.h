// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_Corridor_h
#define geodesic_distributed_Corridor_h

#include "gather/SurfacePatch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace geodesic::distributed
{

/** The number of points that a corridor of several paths may have: that of a piece of the surface,
 * or some thousands. */
inline std::size_t roomOfCorridor(std::size_t pointsOfPiece)
{
  constexpr std::size_t least = 4096;
  return std::max(least, pointsOfPiece);
}

/**
 * The part of a surface along a path, joined from patches that ranks cut out of their pieces. Equal
 * GlobalVertex mean the same vertex. A triangle that several ranks have is there once.
 */
class Corridor
{
public:
  /**
   * Adds the patches that all ranks cut for some balls. Vertices that are there already get the
   * distances of the patches.
   */
  void add(std::span<const SurfacePatch> patches, std::span<const Ball> balls);

  std::span<const Ball> balls() const { return this->Balls; }
  const std::vector<PatchVertex>& vertices() const { return this->Vertices; }
  /** The triangles; their corners are positions in vertices(). */
  const std::vector<PatchTriangle>& triangles() const { return this->Triangles; }
  /** Whether all triangles of the vertex at a position of vertices() are there. */
  bool isComplete(std::size_t place) const { return this->Vertices[place].depth >= 0.0f; }
  /** How deep a vertex lies in one of the balls, see PatchVertex; PatchVertex::Outside if it is not
   * there. */
  float depthOf(const GlobalVertex& vertex) const;

private:
  std::uint32_t placeOf(const PatchVertex& vertex);
  void addTriangle(const PatchTriangle& triangle);

  /** For the sorted corners of a triangle. */
  struct HashOfCorners
  {
    std::size_t operator()(const std::array<std::uint32_t, 3>& corners) const;
  };

  std::vector<Ball> Balls;
  std::vector<PatchVertex> Vertices;
  std::vector<PatchTriangle> Triangles;
  std::unordered_map<GlobalVertex, std::uint32_t, HashOfVertex> Places;
  /** The positions of triangles by their sorted corners. */
  std::unordered_map<std::array<std::uint32_t, 3>, std::size_t, HashOfCorners> TrianglePlaces;
};

}

#endif
