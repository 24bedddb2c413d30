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

/** Which part of a surface is wanted: the triangles with a corner in one of these. */
struct Ball
{
  Vector3 centre;
  double radius;

  bool contains(const Vector3& position) const
  {
    return norm(position - this->centre) <= this->radius;
  }
};

/** A vertex as one rank sends it to another, with all that a path needs of it. */
struct PatchVertex
{
  GlobalVertex vertex;
  Vector3 position;
  double longestEdge;
  /** 1 where there are no costs. */
  double cost;
  double distance;
  Index nearestSeed;
  std::uint32_t isExcluded;
  /** Its global id; -1 where there are none, or nobody asked. */
  vtkIdType id = -1;
  std::uint32_t hasNormal = 0;
  /** The input's, of any length. */
  Vector3 normal = {};
};

struct PatchTriangle
{
  /** Places in the patch's list of vertices. */
  std::array<std::uint32_t, 3> corners;
  std::uint32_t isClosed;
};

struct SurfacePatch
{
  std::vector<PatchVertex> vertices;
  std::vector<PatchTriangle> triangles;
};

/** A patch as it is sent, and back. */
RankGroup::Message packed(const SurfacePatch& patch);
SurfacePatch unpacked(const RankGroup::Message& message);
/** What each rank cuts, on the first rank; nothing on the others. Collective. */
std::vector<SurfacePatch> patchesOfAll(
  RankGroup& ranks, const std::function<SurfacePatch()>& cutLocally);

}

#endif
