// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SurfacePatch_h
#define geodesic_distributed_SurfacePatch_h

#include "DistanceField.h"
#include "DistributedSurface.h"
#include "PathGround.h"
#include "SharedPoints.h"
#include "SolveOptions.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <span>
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
  /** Its global id; -1 where there are none. */
  vtkIdType id;
  std::uint32_t hasNormal;
  /** The input's, of any length. */
  Vector3 normal;
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
RankGroup::Message messageOf(const SurfacePatch& patch);
SurfacePatch patchIn(const RankGroup::Message& message);

/** Cuts patches out of this rank's piece of a surface. */
class PatchCutter
{
public:
  /**
   * All must live as long as this. Time O(n).
   * @param input   the same piece of the surface
   * @param options costs and barriers
   */
  PatchCutter(const DistributedSurface& surface, const SolveOptions& options,
    const bridge::PathGround& input);

  /** @param field null: no vertex has a distance yet */
  SurfacePatch cut(std::span<const Ball> balls, const DistanceField* field) const;
  /** The same of the triangles round some vertices. */
  SurfacePatch cutRound(std::span<const Index> vertices, const DistanceField* field) const;
  std::vector<Index> trianglesRound(std::span<const Index> vertices) const;

private:
  /** The box round consecutive vertices, which lie near each other. */
  struct Block
  {
    Vector3 low;
    Vector3 high;

    bool isNear(const Ball& ball) const;
  };

  std::vector<Index> verticesIn(std::span<const Ball> balls) const;
  PatchVertex patchVertex(Index vertex, const DistanceField* field) const;

  const DistributedSurface& Surface;
  const SolveOptions& Options;
  const bridge::PathGround& Input;
  std::vector<Block> Blocks;
};

}

#endif
