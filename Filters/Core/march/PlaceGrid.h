// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PlaceGrid_h
#define geodesic_PlaceGrid_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** Numbered places in space, put into the cubes of a grid, to find those near a position. */
class PlaceGrid
{
public:
  /** @param numbers   of the places, in increasing order
   * @param side       of a cube, more than 0
   * @param placeOf    gives the position of a number. Time O(n) */
  template <class PlaceOf>
  PlaceGrid(std::span<const Index> numbers, double side, const PlaceOf& placeOf)
    : PerSide(1.0 / side)
    , Shift(std::countl_zero(numbers.size() | 1) - 1)
    , Starts((std::size_t{ 2 } << (63 - Shift)) + 1)
    , Members(numbers.size())
  {
    std::vector<std::uint64_t> keys;
    keys.reserve(numbers.size());
    for (const Index number : numbers)
    {
      keys.push_back(keyOf(this->cubeOf(placeOf(number))));
      ++this->Starts[this->bucketOf(keys.back())];
    }
    // First the ends of the buckets, which then are filled from behind.
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    for (std::size_t i = numbers.size(); i-- > 0;)
    {
      this->Members[--this->Starts[this->bucketOf(keys[i])]] = { keys[i], numbers[i] };
    }
  }

  /** Calls @p visit with the number of each place in the cubes that a ball touches, in an order
   * that depends on the places and numbers alone.
   * @param radius  at most the side of a cube, or time grows with the cubes in the ball */
  template <class Visit>
  void visitNear(const Vector3& centre, double radius, const Visit& visit) const
  {
    this->anyNear(centre, radius,
      [&](Index number)
      {
        visit(number);
        return false;
      });
  }

  /** Whether a test holds for any of these places; those behind it are not looked at. */
  template <class Test>
  bool anyNear(const Vector3& centre, double radius, const Test& test) const
  {
    const Vector3 reach{ radius, radius, radius };
    const Cube first = this->cubeOf(centre - reach);
    const Cube last = this->cubeOf(centre + reach);
    for (std::int64_t x = first[0]; x <= last[0]; ++x)
    {
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int64_t z = first[2]; z <= last[2]; ++z)
        {
          if (this->anyInCube(keyOf({ x, y, z }), test))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** How many places share a bucket, in the mean over the places: those in a cube, and some of
   * cubes that share it. @pre there is a place */
  double meanInBucket() const
  {
    double sum = 0.0;
    for (std::size_t i = 1; i < this->Starts.size(); ++i)
    {
      const double size = this->Starts[i] - this->Starts[i - 1];
      sum += size * size;
    }
    return sum / static_cast<double>(this->Members.size());
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  static constexpr int Bits = 21;

  template <class Test>
  bool anyInCube(std::uint64_t key, const Test& test) const
  {
    const std::size_t bucket = this->bucketOf(key);
    return std::any_of(this->Members.begin() + this->Starts[bucket],
      this->Members.begin() + this->Starts[bucket + 1],
      [&](const std::pair<std::uint64_t, Index>& member)
      { return member.first == key && test(member.second); });
  }
  /** Fibonacci hashing, see Knuth, The Art of Computer Programming 3, section 6.4. */
  std::size_t bucketOf(std::uint64_t key) const
  {
    return (key * 0x9e3779b97f4a7c15u) >> this->Shift;
  }

  /** The cube of a position. Positions far from the origin share the outermost cubes. */
  Cube cubeOf(const Vector3& p) const
  {
    constexpr double most = 1 << (Bits - 1);
    const auto along = [&](double x)
    {
      // What is not negative is rounded down by the conversion.
      return static_cast<std::int64_t>(std::clamp(x * this->PerSide, -most, most - 1.0) + most);
    };
    return { along(p.x), along(p.y), along(p.z) };
  }
  static std::uint64_t keyOf(const Cube& cube)
  {
    return static_cast<std::uint64_t>(cube[0] << 2 * Bits | cube[1] << Bits | cube[2]);
  }

  double PerSide;
  /** Makes of 64 bits as many as number the buckets, of which there are at least as many as places.
   */
  int Shift;
  /** For each bucket, and for the one after the last, its first member. */
  std::vector<Index> Starts;
  /** The keys of cubes with the numbers in them, bucket by bucket, in the order of the numbers. */
  std::vector<std::pair<std::uint64_t, Index>> Members;
};

}

#endif
