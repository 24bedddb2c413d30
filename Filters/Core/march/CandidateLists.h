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

/** From a row's vertex and the neighbour in a slot, over the edge between, to the neighbour in
 * the slot before or after. */
class EdgeCrossing
{
public:
  constexpr EdgeCrossing() = default;
  constexpr EdgeCrossing(std::size_t over, std::size_t target)
    : Both(static_cast<std::uint32_t>(over | target << Bits))
  {
  }
  constexpr Slot across() const { return static_cast<Slot>(this->Both); }
  constexpr Slot target() const { return static_cast<Slot>(this->Both >> Bits); }
  /** The same way between neighbours so many slots on. */
  constexpr EdgeCrossing later(std::size_t slots) const
  {
    EdgeCrossing way;
    way.Both = this->Both + static_cast<std::uint32_t>(slots * (1u + (1u << Bits)));
    return way;
  }

private:
  static constexpr int Bits = 16;
  /** Two slots in one number, which is written at once. */
  std::uint32_t Both = 0;
};

/**
 * A list that takes on one item for each bit of some masks. How many bits there are is not to be
 * guessed, so for up to @p Usual there is no branch on it.
 * @tparam Size  the most items there can be, and Usual more
 */
template <class Item, std::size_t Size, std::size_t Usual>
class BitList
{
public:
  /** @param itemOf gives the item of a bit's number */
  template <class ItemOf>
  GEODESIC_INLINED void add(BatchMasks::Some bits, ItemOf itemOf)
  {
    std::size_t count = this->Count;
    do
    {
      const auto found = static_cast<std::size_t>(std::popcount(bits));
      for (std::size_t i = 0; i < Usual; ++i)
      {
        // Of no bits the number is any, and they are not counted.
        constexpr BatchMasks::Some stop = ~(~BatchMasks::Some{ 0 } >> 1);
        this->Items[count + i] = itemOf(std::countr_zero(bits | stop));
        bits &= bits - 1;
      }
      count += std::min(found, Usual);
    } while (bits != 0);
    this->Count = count;
  }

  /** Repeats the first item behind the last, so that items can be taken @p several at a time. */
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
 * The crossings that fronts are to go in the batch, as what was noted of the neighbours says: lists
 * of those along edges and those over edges, made for the whole batch at once; a part of
 * NeighbourUpdate.
 */
class CandidateLists
{
public:
  using AlongList = BitList<Slot, UpdateBatch::Slots, 8>;
  using CrossingList = BitList<EdgeCrossing, 2 * UpdateBatch::Slots, 6>;

  /** To neighbours. */
  const AlongList& along() const { return this->Along; }
  /** Of fronts of a shape. */
  CrossingList& across(FrontShape shape)
  {
    return this->Crossings[static_cast<std::size_t>(shape)];
  }

  /** Makes the list along edges; only the edges of open triangles stay in UpdateBatch::along. */
  GEODESIC_INLINED void listAlong(UpdateBatch& batch)
  {
    const Masks end = batch.end.all();
    const Masks again = batch.again.all();
    const Masks isOpen = openTriangles(batch);
    // Before the first neighbour comes the triangle that ends where it comes again.
    const Masks isOpenBeforeFirst = BatchMasks::all((isOpen & again >> 1) != 0) & 1;
    const Masks isOpenEdge = isOpen | isOpen << 1 | isOpenBeforeFirst;
    const Masks isOnce = (end - 1) | (end & ~again);
    batch.along.set(batch.along.all() & isOnce & isOpenEdge);
    this->Along.clear();
    inSomeRows(
      [&](std::size_t first, std::size_t base)
      {
        this->Along.add(batch.along.some(first),
          [&](std::size_t slot) { return static_cast<Slot>(base + slot); });
      });
  }

  /** Makes the lists over edges. */
  GEODESIC_INLINED void listCrossings(UpdateBatch& batch)
  {
    const Masks again = batch.again.all();
    const auto rounded = [&](const Masks& masks) { return masks | (again & -(masks & 1)); };
    const Masks isOpen = openTriangles(batch);
    const Masks isThin = batch.isThin.all();
    const Masks isSettled = ~rounded(batch.isQueued.all());
    const Masks along = rounded(batch.along.all());
    // The edge to a vertex that waits is crossed from there; not so in a thin triangle, where what
    // lies behind the edge may come before it.
    const Masks first =
      (batch.first.all() | (isThin & along >> 1)) & isOpen & (isThin | isSettled >> 1);
    const Masks second = (batch.second.all() | (isThin & along)) & isOpen & (isThin | isSettled);
    const Masks isStraight = batch.isStraight.all();
    this->listCrossings(FrontShape::Round, first & ~isStraight, second & ~isStraight);
    this->listCrossings(FrontShape::Straight, first & isStraight, second & isStraight);
  }

private:
  using Masks = BatchMasks::All;

  /** Of all batch. */
  GEODESIC_INLINED static Masks openTriangles(const UpdateBatch& batch)
  {
    return batch.isOpen.all() & (batch.end.all() - 1);
  }

  /** Calls @p work with the first of some batch that come together in masks, and its first slot.
   */
  template <class Work>
  GEODESIC_INLINED static void inSomeRows(const Work& work)
  {
    for (std::size_t first = 0; first < UpdateBatch::Most; first += BatchMasks::SizeOfSome)
    {
      work(first, first * UpdateBatch::Size);
    }
  }

  /** @param first, second  as in UpdateBatch, of fronts of the shape */
  GEODESIC_INLINED void listCrossings(FrontShape shape, const Masks& first, const Masks& second)
  {
    CrossingList& crossings = this->across(shape);
    crossings.clear();
    BatchMasks back;
    BatchMasks on;
    back.set(first);
    on.set(second);
    if (!back.hasAny() && !on.hasAny())
    {
      return;
    }
    inSomeRows(
      [&](std::size_t row, std::size_t base)
      {
        crossings.add(
          back.some(row), [&](std::size_t slot) { return EdgeCrossing(1, 0).later(base + slot); });
        crossings.add(
          on.some(row), [&](std::size_t slot) { return EdgeCrossing(0, 1).later(base + slot); });
      });
  }

  AlongList Along;
  /** By the front's shape. */
  std::array<CrossingList, 2> Crossings;
};

}

#endif
