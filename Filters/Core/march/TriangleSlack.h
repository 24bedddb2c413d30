// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleSlack_h
#define geodesic_TriangleSlack_h

#include "mesh/RingNumbers.h"

#include <bit>
#include <cstdint>
#include <limits>

namespace geodesic
{

/**
 * The slack of a triangle, and whether the triangle is thin. The slack tells from the values at the
 * corners that no crossing of an edge can lower a value.
 *
 * The slack is the least of 2 h - c over the triangle's sides, with c the length of the side and h
 * the height over it, rounded down to 8 significant bits: reading fewer bytes gains more than
 * the few crossings cost that are not passed over for it. At cost 1 a distance is 1-Lipschitz: with
 * a and b at the ends of a side it is nowhere on the side less than (a + b - c) / 2, so a crossing
 * of the side gives the opposite corner at least (a + b + slack) / 2. A cost w is a factor of the
 * slack. Both updates of EikonalUpdate.h keep this bound; if their formula changes, it must be
 * checked.
 */
class TriangleSlack
{
public:
  /** An infinite slack, for a ring entry that opens no triangle: nothing crosses it. */
  constexpr TriangleSlack() = default;
  /** @param slack finite; less than 0 if the triangle is thin */
  constexpr TriangleSlack(float slack, bool isThin)
    : Bits(rounded(slack, isThin))
  {
  }

  /** A slack as it is stored beside a ring entry; see stored(). */
  static constexpr TriangleSlack from(EntryNumber stored)
  {
    TriangleSlack slack;
    slack.Bits = stored;
    return slack;
  }

  /** The slack; its last bit, which holds isThin(), makes no difference. */
  constexpr float value() const
  {
    return std::bit_cast<float>(std::uint32_t{ this->Bits } << DroppedBits);
  }
  /** The slack together with isThin(): the upper half of a float. */
  constexpr EntryNumber stored() const { return this->Bits; }
  /** Whether the triangle's height over its longest side is less than a quarter of that side. */
  constexpr bool isThin() const { return (this->Bits & ThinBit) != 0; }

  // For code that reads several slacks at once.

  /** The bits of a float that stored() is without. */
  static constexpr int DroppedBits = 16;
  /** The bit of stored() that holds isThin(). */
  static constexpr EntryNumber ThinBit = 1;

private:
  /** The largest number of so few bits that is at most @p slack and whose last bit is @p isThin. */
  static constexpr EntryNumber rounded(float slack, bool isThin)
  {
    const auto bits = std::bit_cast<std::uint32_t>(slack);
    const std::uint32_t isNegative = bits >> 31;
    constexpr std::uint32_t dropped = (1u << DroppedBits) - 1u;
    const std::uint32_t down = (bits + dropped * isNegative) >> DroppedBits;
    const std::uint32_t off = (down ^ (isThin ? 1u : 0u)) & ThinBit;
    return static_cast<EntryNumber>(down - off + 2 * (off & isNegative));
  }

  EntryNumber Bits =
    std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity()) >> DroppedBits;
};

}

#endif
