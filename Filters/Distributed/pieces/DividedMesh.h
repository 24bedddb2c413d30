// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DividedMesh_h
#define geodesic_distributed_DividedMesh_h

#include "mesh/TriangleMesh.h"
#include "pieces/SharedPoints.h"
#include "ranks/RankGroup.h"

#include <memory>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/** This rank's mesh, and what it has in common with those of the others. */
class DividedMesh
{
public:
  /**
   * Collective.
   * @param keys one a vertex, see SharedPoints; none on one rank
   */
  DividedMesh(
    RankGroup& ranks, std::shared_ptr<const TriangleMesh> mesh, std::span<const Key> keys);

  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return this->Mesh; }
  const TriangleMesh& mesh() const { return *this->Mesh; }
  const SharedPoints& shared() const { return this->Shared; }

  /** See Partition::longestSides. */
  std::span<const float> longestSides() const { return this->LongestSides; }
  /**
   * By how many edges of MarchingFront::meanLongestEdge() the limit of the march grows from round
   * to round. The more vertices are shared, the more the ranks redo: where nearly all are, as when
   * triangles are dealt out at random, half an edge led to twice the work of one rank and one edge
   * to up to ten times. Where few are, a round is to hold enough work to be worth its messages.
   * Infinite where none are.
   */
  double stepInEdges() const { return this->StepInEdges; }

private:
  void agreeOnLongestSides(RankGroup& ranks);
  void chooseStep(RankGroup& ranks);

  std::shared_ptr<const TriangleMesh> Mesh;
  SharedPoints Shared;
  std::vector<float> LongestSides;
  double StepInEdges = 0.0;
};

}

#endif
