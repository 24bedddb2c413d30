// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MortonCurve_h
#define geodesic_MortonCurve_h

#include "base/BoundingBox.h"
#include "base/Vector3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace geodesic
{

/**
 * A Morton (Z) curve through a cube that holds a box and shares the box's low corner. Each side of
 * the cube is cut into 2^21 cells.
 * G. M. Morton, A computer oriented geodetic data base, IBM (1966).
 */
class MortonCurve
{
public:
  static constexpr int BitsPerAxis = 21;

  explicit MortonCurve(const BoundingBox& box)
    : Low(box.low)
  {
    const Vector3 size = box.high - box.low;
    const double extent = std::max({ size.x, size.y, size.z });
    this->CellsPerUnit = extent > 0.0 ? ((1 << BitsPerAxis) - 1) / extent : 0.0;
  }

  /** The number of a point's cell along the curve, in 63 bits. @pre the point is in the box */
  std::uint64_t codeOf(const Vector3& point) const
  {
    const Cell cell = this->cellOf(point);
    return spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
  }

  /** The highest 32 bits of codeOf(), faster than the whole. */
  std::uint32_t leadingBitsOf(const Vector3& point) const
  {
    const Cell cell = this->cellOf(point);
    // Three times 11 bits, without the lowest one, which otherBitsOf() returns.
    return Spread[cell.x >> LastBits] >> 1 | Spread[cell.y >> LastBits] |
      Spread[cell.z >> LastBits] << 1;
  }

  /** The lowest 31 bits of codeOf(). */
  std::uint32_t otherBitsOf(const Vector3& point) const
  {
    const Cell cell = this->cellOf(point);
    constexpr std::uint32_t last = (1u << LastBits) - 1;
    return Spread[cell.x & (2 * last + 1)] | Spread[cell.y & last] << 1 |
      Spread[cell.z & last] << 2;
  }

private:
  struct Cell
  {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t z;
  };

  Cell cellOf(const Vector3& point) const
  {
    const auto numberOf = [](double x)
    { return static_cast<std::uint32_t>(static_cast<std::int32_t>(x)); };
    const Vector3 cell = this->CellsPerUnit * (point - this->Low);
    return { numberOf(cell.x), numberOf(cell.y), numberOf(cell.z) };
  }

  static constexpr int FirstBits = 11;
  static constexpr int LastBits = BitsPerAxis - FirstBits;

  /** For each number of 11 bits: the number with bit i moved to bit 3 i. */
  static constexpr auto Spread = []
  {
    std::array<std::uint32_t, std::size_t{ 1 } << FirstBits> spread{};
    for (std::uint32_t number = 0; number < spread.size(); ++number)
    {
      for (int bit = 0; bit < FirstBits; ++bit)
      {
        spread[number] |= (number >> bit & 1) << 3 * bit;
      }
    }
    return spread;
  }();

  /** Moves bit i of a number of 21 bits to bit 3 i. */
  static std::uint64_t spread(std::uint32_t number)
  {
    constexpr std::uint32_t last = (1u << LastBits) - 1;
    return Spread[number & last] | std::uint64_t{ Spread[number >> LastBits] } << 3 * LastBits;
  }

  Vector3 Low;
  double CellsPerUnit;
};

}

#endif
