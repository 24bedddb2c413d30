// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_PointKeys_h
#define geodesic_distributed_PointKeys_h

#include "base/Vector3.h"
#include "input/PointIdentity.h"
#include "ranks/KeyMatches.h"
#include "ranks/RankGroup.h"

#include <vector>

namespace geodesic::distributed
{

/**
 * Chooses the rule by which points of all ranks are one vertex, as bridge::identityOf() does for
 * one rank. Collective.
 * @throws std::exception on all ranks if nothing tells which points are the same
 */
bridge::PointIdentity identityOf(RankGroup& ranks, const bridge::InputBlocks& blocks,
  bool mergeCoincidentPoints, bool connectBlocks);

/** The key of a point that is on this rank only. */
constexpr Key NoKey{ ~0ull, ~0ull, ~0ull, ~0ull };

/** Makes keys that are equal for points of different ranks or data sets that are one vertex. */
class PointKeys
{
public:
  PointKeys(const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

  /**
   * @param point  the point's number, counted over all blocks
   * @param block  see bridge::DataSetLeaf::block
   */
  Key of(Index point, const Vector3& position, unsigned int block) const;

private:
  bool AcrossBlocks;
  /** The global ids; empty if equal coordinates make points one vertex. */
  std::vector<vtkIdType> Ids;
};

}

#endif
