// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleSlack_h
#define geodesic_TriangleSlack_h

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
 * the height over it, rounded down. At cost 1 a distance is 1-Lipschitz: with a and b at the ends
 * of a side it is nowhere on the side less than (a + b - c) / 2, so a crossing of the side gives
 * the opposite corner at least (a + b + slack) / 2. A cost w is a factor of the slack. Both updates
 * of EikonalUpdate.h keep this bound; if their formula changes, it must be checked.
 */
class TriangleSlack
{
public:
  /** An infinite slack, for a ring entry that opens no triangle: nothing crosses it. */
  constexpr TriangleSlack() = default;
  /** @param slack finite; less than 0 if the triangle is thin */
  constexpr TriangleSlack(float slack, bool isThin)
    : Value(withFlag(isThin, slack))
  {
  }

  /** A slack as it is stored beside a ring entry; see stored(). */
  static constexpr TriangleSlack from(float stored)
  {
    TriangleSlack slack;
    slack.Value = stored;
    return slack;
  }

  /** The slack; its last bit, which holds isThin(), makes no difference. */
  constexpr float value() const { return this->Value; }
  /** The slack together with isThin(). */
  constexpr float stored() const { return this->Value; }
  /** Whether the triangle's height over its longest side is less than a quarter of that side. */
  constexpr bool isThin() const
  {
    return (std::bit_cast<std::uint32_t>(this->Value) & ThinBit) != 0;
  }

  /** The bit of a slack that holds isThin(), for code that reads several slacks at once. */
  static constexpr std::uint32_t ThinBit = 1;

private:
  /** The next float down from @p slack, or itself, whose last bit is @p isThin. */
  static constexpr float withFlag(bool isThin, float slack)
  {
    const auto bits = std::bit_cast<std::uint32_t>(slack);
    const std::uint32_t off = (bits ^ (isThin ? ThinBit : 0u)) & ThinBit;
    const std::uint32_t isNegative = bits >> 31;
    return std::bit_cast<float>(bits - off + 2 * (off & isNegative));
  }

  float Value = std::numeric_limits<float>::infinity();
};

}

#endif
