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
 * By what the points of all ranks are one: the rule of bridge::identityOf for pieces. Collective.
 * @throws std::exception on all ranks where nothing tells
 */
bridge::PointIdentity identityOf(RankGroup& ranks, const bridge::InputBlocks& blocks,
  bool mergeCoincidentPoints, bool connectBlocks);

/** Of a point that is on this rank only. */
constexpr Key NoKey{ ~0ull, ~0ull, ~0ull, ~0ull };

/** Gives points of different ranks or data sets that are one equal keys. */
class PointKeys
{
public:
  PointKeys(const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

  /**
   * @param point  its number in all blocks
   * @param block  see bridge::DataSetLeaf::block
   */
  Key of(Index point, const Vector3& position, unsigned int block) const;

private:
  bool AcrossBlocks;
  /** Empty where points are one by their coordinates. */
  std::vector<vtkIdType> Ids;
};

}

#endif
