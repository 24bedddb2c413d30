// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DistributedSurface_h
#define geodesic_distributed_DistributedSurface_h

#include "input/InputSurface.h"
#include "pieces/DividedMesh.h"
#include "pieces/SharedPoints.h"
#include "ranks/RankGroup.h"

#include "vtkType.h"

#include <memory>
#include <vector>

namespace geodesic::distributed
{

/**
 * This rank's piece of a surface, and the vertices that it shares with other ranks' pieces. Both
 * are built once for an input's points and cells and shared by all filters and runs.
 */
class DistributedSurface
{
public:
  /**
   * Returns the surface of an input; it is built now unless all ranks still hold the one that they
   * built together. This rank's piece may have no triangles. Collective.
   * @param identity see identityOf()
   * @param team     builds this rank's piece
   * @throws std::exception on all ranks if no rank has a triangle
   */
  static std::shared_ptr<const DistributedSurface> of(RankGroup& ranks,
    const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity,
    const ThreadTeam& team);

  DistributedSurface(RankGroup& ranks, std::shared_ptr<const bridge::InputSurface> piece,
    const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

  const bridge::InputSurface& piece() const { return *this->Piece; }
  const std::shared_ptr<const bridge::InputSurface>& sharedPiece() const { return this->Piece; }
  const TriangleMesh& mesh() const { return *this->Piece->mesh(); }
  const DividedMesh& divided() const { return *this->Divided; }
  const std::shared_ptr<const DividedMesh>& sharedDivided() const { return this->Divided; }
  const SharedPoints& shared() const { return this->Divided->shared(); }

  /** The largest number of points on any rank. */
  vtkIdType mostPointsOnARank() const { return this->MostPoints; }

private:
  std::shared_ptr<const bridge::InputSurface> Piece;
  std::shared_ptr<const DividedMesh> Divided;
  vtkIdType MostPoints = 0;
};

}

#endif
