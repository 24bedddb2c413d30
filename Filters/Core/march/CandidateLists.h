// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CandidateLists_h
#define geodesic_CandidateLists_h

#include "base/Lanes.h"
#include "march/UpdateBatch.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace geodesic
{

/**
 * An update over the inside of an edge: the edge from a row's vertex to one neighbour is crossed,
 * to the neighbour in the slot before or after it.
 */
class EdgeCrossing
{
public:
  constexpr EdgeCrossing() = default;
  /** @param over slot of the edge's other end; @param target slot of the neighbour to be updated */
  constexpr EdgeCrossing(std::size_t over, std::size_t target)
    : Both(static_cast<std::uint32_t>(over | target << Bits))
  {
  }
  constexpr Slot across() const { return static_cast<Slot>(this->Both); }
  constexpr Slot target() const { return static_cast<Slot>(this->Both >> Bits); }
  /** The same crossing with both slots larger by @p slots. */
  constexpr EdgeCrossing later(std::size_t slots) const
  {
    EdgeCrossing crossing;
    crossing.Both = this->Both + static_cast<std::uint32_t>(slots * (1u + (1u << Bits)));
    return crossing;
  }

private:
  static constexpr int Bits = 16;
  /** Both slots in one number, so that one instruction stores them. */
  std::uint32_t Both = 0;
};

/**
 * A list with an item for each bit that is set in some masks. A processor can't predict how many
 * bits are set, so there is no branch on their number up to @p Usual bits.
 * @tparam Item   type of the items
 * @tparam Size   largest number of items
 * @tparam Usual  number of bits that are treated at a time; there is room for as many more items
 */
template <class Item, std::size_t Size, std::size_t Usual>
class BitList
{
public:
  /** Appends an item for each bit of @p bits. @param itemOf gives the item for a bit's number */
  template <class ItemOf>
  GEODESIC_INLINED void add(BatchMasks::Some bits, ItemOf itemOf)
  {
    std::size_t count = this->Count;
    do
    {
      const auto found = static_cast<std::size_t>(std::popcount(bits));
      for (std::size_t i = 0; i < Usual; ++i)
      {
        // Where no bit is left, the item is written but not counted.
        constexpr BatchMasks::Some stop = ~(~BatchMasks::Some{ 0 } >> 1);
        this->Items[count + i] = itemOf(std::countr_zero(bits | stop));
        bits &= bits - 1;
      }
      count += std::min(found, Usual);
    } while (bits != 0);
    this->Count = count;
  }

  /** Writes the first item behind the last until items can be read @p several at a time. The size
   * stays. */
  void pad(std::size_t several)
  {
    std::fill_n(this->Items.begin() + this->Count, several - 1, this->Items[0]);
  }

  void clear() { this->Count = 0; }
  std::size_t size() const { return this->Count; }
  const Item& operator[](std::size_t i) const { return this->Items[i]; }

private:
  std::size_t Count = 0;
  std::array<Item, Size + Usual> Items;
};

/**
 * Lists of the updates to be computed for a batch: along edges, and over edges for each shape of
 * front. They are made from the masks of UpdateBatch, for all rows at once. It is a part of
 * NeighbourUpdate.
 */
class CandidateLists
{
public:
  using AlongList = BitList<Slot, UpdateBatch::Slots, 8>;
  using CrossingList = BitList<EdgeCrossing, 2 * UpdateBatch::Slots, 6>;

  /** The slots of neighbours to be updated along the edges to them. */
  const AlongList& along() const { return this->Along; }
  /** The crossings of edges by fronts of a shape. */
  CrossingList& across(FrontShape shape)
  {
    return this->Crossings[static_cast<std::size_t>(shape)];
  }

  /** Makes the list along edges, and removes from UpdateBatch::along edges without an open triangle
   * beside them and neighbours that come again. */
  GEODESIC_INLINED void listAlong(UpdateBatch& batch)
  {
    const Masks end = batch.end.all();
    const Masks again = batch.again.all();
    const Masks isOpen = openTriangles(batch);
    // In a ring that closes, the triangle before the first neighbour is the last one of the row.
    const Masks isOpenBeforeFirst = BatchMasks::all((isOpen & again >> 1) != 0) & 1;
    const Masks isOpenEdge = isOpen | isOpen << 1 | isOpenBeforeFirst;
    const Masks isOnce = (end - 1) | (end & ~again);
    batch.along.set(batch.along.all() & isOnce & isOpenEdge);
    this->Along.clear();
    visitRows(batch.Count,
      [&](std::size_t first, std::size_t base)
      {
        this->Along.add(batch.along.some(first),
          [&](std::size_t slot) { return static_cast<Slot>(base + slot); });
      });
  }

  /** Makes the lists over edges, for each shape of front. */
  GEODESIC_INLINED void listCrossings(UpdateBatch& batch)
  {
    const Masks again = batch.again.all();
    // The first neighbour's bit is also needed in the slot where it comes again.
    const auto withRepeated = [&](const Masks& masks) { return masks | (again & -(masks & 1)); };
    const Masks isOpen = openTriangles(batch);
    const Masks isThin = batch.isThin.all();
    const Masks isSettled = ~withRepeated(batch.isQueued.all());
    const Masks along = withRepeated(batch.along.all());
    // If the other end of an edge waits in the queue, the edge is crossed when that end is taken.
    // In a thin triangle it is crossed at once: what lies behind the edge may have a lower value
    // than the end that waits, and be taken first.
    const Masks first =
      (batch.first.all() | (isThin & along >> 1)) & isOpen & (isThin | isSettled >> 1);
    const Masks second = (batch.second.all() | (isThin & along)) & isOpen & (isThin | isSettled);
    const Masks isStraight = batch.isStraight.all();
    this->listCrossings(FrontShape::Round, batch.Count, first & ~isStraight, second & ~isStraight);
    this->listCrossings(FrontShape::Straight, batch.Count, first & isStraight, second & isStraight);
  }

private:
  using Masks = BatchMasks::All;

  /** Masks of the open triangles of all rows. */
  GEODESIC_INLINED static Masks openTriangles(const UpdateBatch& batch)
  {
    return batch.isOpen.all() & (batch.end.all() - 1);
  }

  /** Calls @p work for each four of the first @p rows rows whose masks are in one number (see
   * BatchMasks::Some), with the number of the first row and of its first slot. */
  template <class Work>
  GEODESIC_INLINED static void visitRows(std::size_t rows, const Work& work)
  {
    for (std::size_t first = 0; first < rows; first += BatchMasks::SizeOfSome)
    {
      work(first, first * UpdateBatch::Size);
    }
  }

  /** Makes the list for a shape.
   * @param rows           how many are in use
   * @param first, second  as in UpdateBatch, for rows of the shape */
  GEODESIC_INLINED void listCrossings(
    FrontShape shape, std::size_t rows, const Masks& first, const Masks& second)
  {
    CrossingList& crossings = this->across(shape);
    crossings.clear();
    BatchMasks toFirst;
    BatchMasks toSecond;
    toFirst.set(first);
    toSecond.set(second);
    if (!toFirst.hasAny() && !toSecond.hasAny())
    {
      return;
    }
    visitRows(rows,
      [&](std::size_t row, std::size_t base)
      {
        crossings.add(toFirst.some(row),
          [&](std::size_t slot) { return EdgeCrossing(1, 0).later(base + slot); });
        crossings.add(toSecond.some(row),
          [&](std::size_t slot) { return EdgeCrossing(0, 1).later(base + slot); });
      });
  }

  AlongList Along;
  /** By the front's shape. */
  std::array<CrossingList, 2> Crossings;
};

}

#endif
