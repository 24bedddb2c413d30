// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SurfacePatch_h
#define geodesic_distributed_SurfacePatch_h

#include "base/BoundingBox.h"
#include "pieces/DividedMesh.h"
#include "pieces/SharedPoints.h"
#include "ranks/RankGroup.h"
#include "solve/DistanceField.h"
#include "solve/SolveOptions.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <functional>
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
RankGroup::Message messageOf(const SurfacePatch& patch);
SurfacePatch patchIn(const RankGroup::Message& message);
/** What each rank cuts, on the first rank; nothing on the others. Collective. */
std::vector<SurfacePatch> patchesOfAll(
  RankGroup& ranks, const std::function<SurfacePatch()>& cutHere);

/** Cuts patches out of this rank's mesh. */
class PatchCutter
{
public:
  /**
   * The mesh and the arrays of the options must live as long as this. Time O(n).
   * @param options costs and barriers
   * @param leftOut one flag a triangle that another rank has in place of this one, or empty
   */
  PatchCutter(const DividedMesh& mesh, const SolveOptions& options, std::vector<bool> leftOut = {});

  /** @param field null: no vertex has a distance yet */
  SurfacePatch cut(std::span<const Ball> balls, const DistanceField* field) const;
  /** The same of the triangles round some vertices. */
  SurfacePatch cutRound(std::span<const Index> vertices, const DistanceField* field) const;
  std::vector<Index> trianglesRound(std::span<const Index> vertices) const;

private:
  std::vector<Index> verticesIn(std::span<const Ball> balls) const;
  PatchVertex patchVertex(Index vertex, const DistanceField* field) const;

  const DividedMesh& Mesh;
  SolveOptions Options;
  std::vector<bool> LeftOut;
  /** A box round each block of consecutive vertices, which lie near each other. */
  std::vector<BoundingBox> Boxes;
};

}

#endif
