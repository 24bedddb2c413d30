// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_KeyMatches_h
#define geodesic_distributed_KeyMatches_h

#include "base/Index.h"
#include "ranks/RankGroup.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic::distributed
{

/** What makes things of different ranks one: equal keys. */
using Key = std::array<std::uint64_t, 4>;

/** Even sums of these are equal for equal keys only, but for chances of 1 in 2^64. */
std::uint64_t hashOf(const Key& key);

/** A thing of this rank. */
struct KeyedNumber
{
  Key key;
  Index number;
};

/** A thing of this rank, and one with the same key of any rank: itself is among them. */
struct KeyMatch
{
  Index own;
  int rank;
  Index number;

  friend auto operator<=>(const KeyMatch&, const KeyMatch&) = default;
};

/**
 * All things of any rank that have the key of one of this rank's, if it is not the only one;
 * sorted. Collective.
 *
 * Each key goes to the rank that its hash names, which tells those who sent it of each other: no
 * rank gathers more than its share of them.
 */
std::vector<KeyMatch> matchKeys(RankGroup& ranks, const std::vector<KeyedNumber>& own);

}

#endif
