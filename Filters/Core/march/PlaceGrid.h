// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PlaceGrid_h
#define geodesic_PlaceGrid_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** Numbered places in space, sorted into the cubes of a grid, to find those near a position. */
class PlaceGrid
{
public:
  /** @param numbers   of the places, in increasing order
   * @param side       of a cube, more than 0
   * @param placeOf    gives the position of a number */
  template <class PlaceOf>
  PlaceGrid(std::span<const Index> numbers, double side, const PlaceOf& placeOf)
    : PerSide(1.0 / side)
  {
    this->Members.reserve(numbers.size());
    for (const Index number : numbers)
    {
      this->Members.emplace_back(keyOf(this->cubeOf(placeOf(number))), number);
    }
    std::sort(this->Members.begin(), this->Members.end());
  }

  /** Calls @p visit with the number of each place in the cubes that a ball touches, in an order
   * that depends on the places and numbers alone. */
  template <class Visit>
  void visitNear(const Vector3& centre, double radius, const Visit& visit) const
  {
    const Vector3 reach{ radius, radius, radius };
    const Cube first = this->cubeOf(centre - reach);
    const Cube last = this->cubeOf(centre + reach);
    for (std::int64_t x = first[0]; x <= last[0]; ++x)
    {
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
      {
        // Cubes that differ in z alone have consecutive keys.
        const std::uint64_t end = keyOf({ x, y, last[2] });
        const std::pair begin{ keyOf({ x, y, first[2] }), Index{ 0 } };
        for (auto member = std::lower_bound(this->Members.begin(), this->Members.end(), begin);
             member != this->Members.end() && member->first <= end; ++member)
        {
          visit(member->second);
        }
      }
    }
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  static constexpr int Bits = 21;

  /** The cube of a position. Positions far from the origin share the outermost cubes. */
  Cube cubeOf(const Vector3& p) const
  {
    constexpr double most = 1 << (Bits - 1);
    const auto along = [&](double x)
    {
      return static_cast<std::int64_t>(
        std::floor(std::clamp(x * this->PerSide, -most, most - 1.0)) + most);
    };
    return { along(p.x), along(p.y), along(p.z) };
  }
  static std::uint64_t keyOf(const Cube& cube)
  {
    return static_cast<std::uint64_t>(cube[0] << 2 * Bits | cube[1] << Bits | cube[2]);
  }

  double PerSide;
  /** The keys of cubes with the numbers in them, sorted. */
  std::vector<std::pair<std::uint64_t, Index>> Members;
};

}

#endif
