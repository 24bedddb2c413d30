// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/PointKeys.h"

#include "filter/VtkVersions.h"

#include <bit>
#include <stdexcept>
#include <string>

namespace geodesic::distributed
{
using By = bridge::PointIdentity::By;

bridge::PointIdentity identityOf(RankGroup& ranks, const bridge::InputBlocks& blocks,
  bool mergeCoincidentPoints, bool connectBlocks)
{
  if (ranks.size() == 1)
  {
    return bridge::identityOf(blocks, mergeCoincidentPoints, connectBlocks);
  }
  double haveIds = blocks.haveGlobalPointIds() ? 1.0 : 0.0;
  ranks.takeLeast({ &haveIds, 1 });
  const By by = bridge::identityBy(haveIds > 0.0, mergeCoincidentPoints);
  if (by == By::Nothing)
  {
    throw std::invalid_argument("The surface is spread over " + std::to_string(ranks.size()) +
      " ranks, but it is not known which points of the pieces belong together. Turn "
      "MergeCoincidentPoints on, or make global point ids " +
      bridge::MakeGlobalIds + ".");
  }
  return { by, connectBlocks, ranks.rank() };
}

PointKeys::PointKeys(const bridge::InputBlocks& blocks, const bridge::PointIdentity& identity)
  : AcrossBlocks(identity.acrossBlocks)
{
  if (identity.by == By::GlobalIds)
  {
    this->Ids = bridge::globalPointIdsOf(blocks);
  }
}

Key PointKeys::of(Index point, const Vector3& position, unsigned int block) const
{
  // Points of blocks that are not connected get different keys.
  const std::uint64_t apart = this->AcrossBlocks ? 0 : block;
  if (!this->Ids.empty())
  {
    const vtkIdType id = this->Ids[point];
    return id < 0 ? NoKey : Key{ static_cast<std::uint64_t>(id), 0, 0, apart };
  }
  // Adding 0 turns -0 into 0.
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };
  return { bits(position.x), bits(position.y), bits(position.z), apart };
}

}
