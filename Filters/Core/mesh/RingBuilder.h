// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RingBuilder_h
#define geodesic_RingBuilder_h

#include "base/Index.h"
#include "base/Platform.h"
#include "mesh/RingNumbers.h"
#include "mesh/VertexRings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** The side of a triangle that is opposite to the vertex whose ring is built, by its two ends. */
struct OppositeSide
{
  Index first;
  Index second;
  /** A number by which the caller knows the triangle. */
  Index triangle;
};

/**
 * Chains the sides opposite to one vertex into fans. One builder serves many vertices, so that its
 * workspace is allocated once.
 */
class RingBuilder
{
public:
  /**
   * Appends the fans of one vertex to @p entries.
   * @param sides      the sides opposite to the vertex, in any order; their order is lost
   * @param triangles  gets for each entry the triangle that it opens, NoIndex if it opens none
   * Time O(k log k) for k sides.
   */
  void chain(
    std::span<OppositeSide> sides, std::vector<RingEntry>& entries, std::vector<Index>& triangles)
  {
    this->Sides = sides;
    this->Left = sides.size();
    if (this->isIndexed())
    {
      this->indexSides();
    }
    this->Fan.resize(2 * sides.size() + 2);
    this->FanTriangles.resize(this->Fan.size());
    while (this->Left > 0)
    {
      // The fan starts in the middle of Fan. It grows at its back, then, unless closed, at its
      // front.
      std::size_t front = sides.size();
      std::size_t back = front + 1;
      const OppositeSide side = this->takeAny();
      this->Fan[front] = RingEntry(side.first, true);
      this->FanTriangles[front] = side.triangle;
      this->Fan[back] = RingEntry(side.second);
      bool isClosed = false;
      while (!isClosed)
      {
        const Index end = this->Fan[back].neighbour();
        const std::size_t place = this->find(end);
        if (place == None)
        {
          break;
        }
        const OppositeSide next = this->take(place);
        const Index other = otherEnd(next, end);
        this->Fan[back] = RingEntry(end, true);
        this->FanTriangles[back] = next.triangle;
        this->Fan[++back] = RingEntry(other);
        isClosed = other == this->Fan[front].neighbour();
      }
      while (!isClosed)
      {
        const Index end = this->Fan[front].neighbour();
        const std::size_t place = this->find(end);
        if (place == None)
        {
          break;
        }
        const OppositeSide next = this->take(place);
        this->Fan[--front] = RingEntry(otherEnd(next, end), true);
        this->FanTriangles[front] = next.triangle;
        isClosed = this->Fan[front].neighbour() == this->Fan[back].neighbour();
      }
      this->FanTriangles[back] = NoIndex;
      entries.insert(entries.end(), this->Fan.begin() + front, this->Fan.begin() + back + 1);
      triangles.insert(
        triangles.end(), this->FanTriangles.begin() + front, this->FanTriangles.begin() + back + 1);
    }
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  using Mask = std::uint32_t;
  /** With more triangles round a vertex, sides are found by a sorted index: linear search in each
   * step would take quadratic time. */
  static constexpr std::size_t LinearLimit = 32;

  bool isIndexed() const { return this->Sides.size() > LinearLimit; }

  static Index otherEnd(const OppositeSide& side, Index end)
  {
    return side.first ^ side.second ^ end;
  }

  void indexSides()
  {
    this->Ends.clear();
    this->Taken.assign(this->Sides.size(), 0);
    this->NextStart = 0;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      this->Ends.emplace_back(this->Sides[i].first, i);
      this->Ends.emplace_back(this->Sides[i].second, i);
    }
    std::sort(this->Ends.begin(), this->Ends.end());
    this->Cursors.resize(this->Ends.size());
    for (std::size_t i = 0; i < this->Ends.size(); ++i)
    {
      this->Cursors[i] = i;
    }
  }

  OppositeSide takeAny()
  {
    if (!this->isIndexed())
    {
      return this->take(0);
    }
    while (this->Taken[this->NextStart])
    {
      ++this->NextStart;
    }
    return this->take(this->NextStart);
  }

  /** Removes and returns the side at a place. Other sides may change their places. */
  OppositeSide take(std::size_t place)
  {
    --this->Left;
    if (this->isIndexed())
    {
      this->Taken[place] = 1;
      return this->Sides[place];
    }
    return std::exchange(this->Sides[place], this->Sides[this->Left]);
  }

  /** The place of a remaining side that ends in @p vertex; None if there is none. */
  std::size_t find(Index vertex)
  {
    return this->isIndexed() ? this->findIndexed(vertex) : this->findLinear(vertex);
  }

  std::size_t findLinear(Index vertex) const
  {
    // No early exit: the processor cannot predict which side matches, so a branch would cost more.
    Mask found = 0;
    for (std::size_t i = 0; i < this->Left; ++i)
    {
      const OppositeSide& side = this->Sides[i];
      found |= static_cast<Mask>((side.first == vertex) | (side.second == vertex)) << i;
    }
    return found == 0 ? None : std::countr_zero(found);
  }

  std::size_t findIndexed(Index vertex)
  {
    const auto first = std::lower_bound(
      this->Ends.begin(), this->Ends.end(), std::pair<Index, std::size_t>{ vertex, 0 });
    if (first == this->Ends.end() || first->first != vertex)
    {
      return None;
    }
    // The cursor at the first of a vertex's ends skips those that earlier calls found taken.
    std::size_t& cursor = this->Cursors[first - this->Ends.begin()];
    for (; cursor < this->Ends.size() && this->Ends[cursor].first == vertex; ++cursor)
    {
      const std::size_t side = this->Ends[cursor].second;
      if (!this->Taken[side])
      {
        return side;
      }
    }
    return None;
  }

  std::span<OppositeSide> Sides;
  std::size_t Left = 0;
  std::vector<RingEntry> Fan;
  std::vector<Index> FanTriangles;
  std::vector<std::pair<Index, std::size_t>> Ends;
  std::vector<std::size_t> Cursors;
  std::vector<std::uint8_t> Taken;
  std::size_t NextStart = 0;
};

/**
 * Chains the sides opposite to a vertex in linear time in the common case: one closed fan of
 * triangles with the same orientation. RingBuilder handles the rest.
 */
class ClosedRingBuilder
{
public:
  explicit ClosedRingBuilder(Index numberOfVertices)
    : PlaceOf(numberOfVertices)
  {
  }

  /**
   * Brings sides into the order of a closed fan, where each side begins at the end of the one
   * before.
   * @param ends     the second end of each side
   * @param fan      the entry that opens each side's triangle, with the side's first end as
   *                 neighbour, and room for one more entry, which repeats the first neighbour
   * @param numbers  if @p HasNumbers, the number of each entry that opens a triangle; they are
   *                 brought into the order of the entries
   * @return false, with entries and numbers as they were, where the sides are not one such fan or
   * more than 255
   */
  template <bool HasNumbers>
  bool chain(std::span<const Index> ends, std::span<RingEntry> fan, EntryNumber* numbers)
  {
    const std::size_t size = ends.size();
    if (size == 0 || size > std::numeric_limits<Place>::max())
    {
      return false;
    }
    // Read once: a Place that is written could, by its type, change where the places are.
    Place* const placeOf = this->PlaceOf.data();
    for (std::size_t i = 0; i < size; ++i)
    {
      const RingEntry side = fan[i];
      this->Sides[i] = side;
      if constexpr (HasNumbers)
      {
        this->Numbers[i] = numbers[i];
      }
      placeOf[side.neighbour()] = static_cast<Place>(i);
    }
    std::size_t place = 0;
    std::size_t chained = 0;
    bool isFound = false;
    do
    {
      const Index end = ends[place];
      if constexpr (HasNumbers)
      {
        numbers[chained] = this->Numbers[place];
      }
      fan[chained++] = this->Sides[place];
      place = placeOf[end];
      // Where no side begins at a vertex, its place is left over from another ring: hence the test.
      isFound = place < size && this->Sides[place].neighbour() == end;
    } while (isFound && place != 0 && chained < size);
    const bool isWhole = isFound && place == 0 && chained == size;
    if (isWhole)
    {
      fan[size] = RingEntry(this->Sides[0].neighbour());
    }
    else
    {
      std::copy_n(this->Sides.begin(), chained, fan.begin());
      if constexpr (HasNumbers)
      {
        std::copy_n(this->Numbers.begin(), chained, numbers);
      }
    }
    return isWhole;
  }

private:
  using Place = std::uint8_t;
  std::vector<Place> PlaceOf;
  std::array<RingEntry, std::numeric_limits<Place>::max()> Sides;
  std::array<EntryNumber, std::numeric_limits<Place>::max()> Numbers;
};

}

#endif
