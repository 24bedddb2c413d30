// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_PatchCutter_h
#define geodesic_distributed_PatchCutter_h

#include "base/BoundingBox.h"
#include "gather/SurfacePatch.h"
#include "pieces/DividedMesh.h"
#include "solve/DistanceField.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/** Cuts patches out of this rank's mesh. */
class PatchCutter
{
public:
  /**
   * The mesh and the arrays of the options must outlive this object. Time O(n).
   * @param options cost and barriers
   */
  PatchCutter(const DividedMesh& mesh, const SolveOptions& options);

  /**
   * Cuts out the triangles with a corner in one of the balls.
   * @param field gives the distances; null if there are none yet
   */
  SurfacePatch cut(std::span<const Ball> balls, const DistanceField* field) const;
  /** How many vertices are in the balls, some in several. It ends with more than @p most. */
  std::size_t count(std::span<const Ball> balls, std::size_t most) const;
  /** Cuts out the triangles at some vertices; see cut(). */
  SurfacePatch cutRound(std::span<const Index> vertices, const DistanceField* field) const;
  std::vector<Index> trianglesRound(std::span<const Index> vertices) const;

private:
  /** A vertex in a ball. */
  struct Inner
  {
    Index vertex;
    /** See PatchVertex. */
    float depth;
  };

  /** Calls @p visit with the vertices in a ball, until it returns false. */
  template <class Visit>
  void visitIn(const Ball& ball, const Visit& visit) const;
  /** In ascending order of the vertices, each once. */
  std::vector<Inner> verticesIn(std::span<const Ball> balls) const;
  PatchVertex patchVertex(Index vertex, const DistanceField* field) const;

  const DividedMesh& Mesh;
  SolveOptions Options;
  /** A box round each block of consecutive vertices, which lie near each other. */
  std::vector<BoundingBox> Boxes;
};

}

#endif
