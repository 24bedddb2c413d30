// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DividedMesh_h
#define geodesic_distributed_DividedMesh_h

#include "mesh/TriangleMesh.h"
#include "pieces/SharedPoints.h"
#include "pieces/SlotsBeside.h"
#include "ranks/RankGroup.h"

#include <memory>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/** This rank's mesh, and the vertices that it shares with other ranks' meshes. */
class DividedMesh
{
public:
  /**
   * Finds the vertices that the mesh shares with other ranks' meshes. Collective.
   * @param keys one key for each vertex, see SharedPoints; empty on one rank
   */
  DividedMesh(
    RankGroup& ranks, std::shared_ptr<const TriangleMesh> mesh, std::span<const Key> keys);

  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return this->Mesh; }
  const TriangleMesh& mesh() const { return *this->Mesh; }
  const SharedPoints& shared() const { return this->Shared; }
  const SlotsBeside& slotsBeside() const { return this->Beside; }

  /** See Partition::longestSides. */
  std::span<const float> longestSides() const { return this->LongestSides; }
  /**
   * The growth of the march's limit from round to round, in units of
   * MarchingFront::meanLongestEdge(). Infinite if no vertices are shared.
   *
   * The more vertices are shared, the more work the ranks repeat. If nearly all are shared, as when
   * triangles are dealt out at random, half an edge led to twice the work of one rank, and one edge
   * to up to ten times that work. If few are shared, a round must hold enough work to be worth its
   * messages.
   */
  double stepInEdges() const { return this->StepInEdges; }

private:
  void agreeOnLongestSides(RankGroup& ranks);
  void chooseStep(RankGroup& ranks);

  std::shared_ptr<const TriangleMesh> Mesh;
  SharedPoints Shared;
  SlotsBeside Beside;
  std::vector<float> LongestSides;
  double StepInEdges = 0.0;
};

}

#endif
