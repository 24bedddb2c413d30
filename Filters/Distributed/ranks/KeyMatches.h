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

/** Identifies an object on all ranks: objects with equal keys are the same object. */
using Key = std::array<std::uint64_t, 4>;

/**
 * A hash of 64 bits. The hashes of different keys, and even sums of such hashes, are equal by a
 * chance of 1 in 2^64.
 */
std::uint64_t hashOf(const Key& key);

/** The key of an object of this rank, and the object's number. */
struct KeyedNumber
{
  Key key;
  Index number;
};

/**
 * An object of this rank, and an object of any rank with the same key. Both can be the same object.
 */
struct KeyMatch
{
  /** The number of this rank's object. */
  Index own;
  /** The rank and the number of the other object. */
  int rank;
  Index number;

  friend auto operator<=>(const KeyMatch&, const KeyMatch&) = default;
};

/**
 * Returns the matches of this rank's objects, sorted. An object whose key occurs only once has
 * none. Collective.
 *
 * Each key is sent to the rank that its hash selects, and that rank tells the senders of equal keys
 * of each other. So no rank gathers more than its share of the keys.
 */
std::vector<KeyMatch> matchKeys(RankGroup& ranks, const std::vector<KeyedNumber>& own);

}

#endif
