// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_ThinTriangleNotice_h
#define geodesic_distributed_ThinTriangleNotice_h

#include "mesh/ThinTriangles.h"
#include "ranks/RankGroup.h"
#include "solve/Seed.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace geodesic::bridge
{

class InputBlocks;

}

namespace geodesic::distributed
{

class DistributedSurface;

/** Tells users of fast marching where many triangles are thin, see countThinTriangles(). */
class ThinTriangleNotice
{
public:
  /** Counts the thin triangles of all ranks; those of a surface are counted once. Ghost cells do
   * not count. Collective. */
  void update(RankGroup& ranks, const std::shared_ptr<const DistributedSurface>& surface,
    const bridge::InputBlocks& blocks);

  /** The count of all ranks. */
  const ThinTriangles& count() const { return this->OfAll; }
  /** Whether fast marching is to go over intrinsic triangles: where many triangles are thin, from
   * points, and if the memory is enough. Collective.
   * @param hasCost   on any rank
   * @param vertices  on this rank
   * @param limit     the most memory in bytes; 0: three quarters of the machine's */
  bool needOthers(RankGroup& ranks, std::span<const Seed> seeds, bool hasCost, Index vertices,
    std::size_t limit) const;
  /** What the user should know; empty if there is nothing.
   * @param isIntrinsic  whether fast marching goes over intrinsic triangles instead
   * @param hasCost      with costs no other method serves */
  std::string text(bool isIntrinsic, bool hasCost) const;

private:
  /** The surface whose triangles were counted, which this does not keep alive. */
  std::weak_ptr<const DistributedSurface> Counted;
  ThinTriangles OfThisRank;
  ThinTriangles OfAll;
};

}

#endif
