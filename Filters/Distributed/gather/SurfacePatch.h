// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SurfacePatch_h
#define geodesic_distributed_SurfacePatch_h

#include "base/Vector3.h"
#include "pieces/SharedPoints.h"
#include "ranks/RankGroup.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace geodesic::distributed
{

/** A ball in space. It selects the triangles of a surface that have a corner inside. */
struct Ball
{
  Vector3 centre;
  double radius;

  bool contains(const Vector3& position) const
  {
    return norm(position - this->centre) <= this->radius;
  }
  /** See PatchVertex::depth. */
  float depthOf(const Vector3& position) const
  {
    const double distance = norm(position - this->centre);
    return distance > 0.0 ? static_cast<float>(1.0 - distance / this->radius) : 1.0f;
  }
};

/** A vertex as ranks send it, with all that finding and writing a path needs. */
struct PatchVertex
{
  static constexpr float Outside = -1.0f;

  GlobalVertex vertex;
  Vector3 position;
  double longestEdge;
  /** 1 if there is no cost. */
  double cost;
  double distance;
  Index nearestSeed;
  std::uint32_t isExcluded;
  /** How deep the vertex lies in a ball that the patch was cut by: 1 at the centre, 0 at the
   * border, less outside. All triangles of a vertex inside are in patches. */
  float depth = Outside;
  /** The global id; -1 if there is none or it was not asked for. */
  vtkIdType id = -1;
  std::uint32_t hasNormal = 0;
  /** The input's normal, of any length. */
  Vector3 normal = {};
};

/** A triangle as ranks send it. */
struct PatchTriangle
{
  /** Positions in the patch's list of vertices. */
  std::array<std::uint32_t, 3> corners;
  std::uint32_t isClosed;
};

/** A part of a surface that one rank sends to another. */
struct SurfacePatch
{
  std::vector<PatchVertex> vertices;
  std::vector<PatchTriangle> triangles;
};

/** Converts a patch to a message, and back. */
RankGroup::Message packed(const SurfacePatch& patch);
SurfacePatch unpacked(const RankGroup::Message& message);
/**
 * Returns the patches of all ranks, in their order, on the first rank, and nothing on the others.
 * Collective.
 */
std::vector<SurfacePatch> patchesOfAll(
  RankGroup& ranks, const std::function<SurfacePatch()>& cutLocally);

}

#endif
