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
 * This rank's piece of a surface, and what it has in common with those of the others: built once
 * for an input's points and cells and shared by every run of every filter on it.
 */
class DistributedSurface
{
public:
  /**
   * Collective; built now unless all ranks still hold what they built together. This rank may be
   * without triangles.
   * @param identity see identityOf
   * @throws std::exception on all ranks where no rank has a triangle
   */
  static std::shared_ptr<const DistributedSurface> of(
    RankGroup& ranks, const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

  DistributedSurface(RankGroup& ranks, std::shared_ptr<const bridge::InputSurface> piece,
    const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

  const bridge::InputSurface& piece() const { return *this->Piece; }
  const std::shared_ptr<const bridge::InputSurface>& sharedPiece() const { return this->Piece; }
  const TriangleMesh& mesh() const { return *this->Piece->mesh(); }
  const DividedMesh& divided() const { return *this->Divided; }
  const SharedPoints& shared() const { return this->Divided->shared(); }

  /** The number of points on the rank that has most. */
  vtkIdType mostPointsOnARank() const { return this->MostPoints; }

private:
  std::shared_ptr<const bridge::InputSurface> Piece;
  std::unique_ptr<const DividedMesh> Divided;
  vtkIdType MostPoints = 0;
};

}

#endif
