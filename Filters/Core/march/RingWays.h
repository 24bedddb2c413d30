#ifndef geodesic_RingWays_h
#define geodesic_RingWays_h

#include "base/Lanes.h"
#include "march/RingWindows.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace geodesic
{

/** From a window's vertex and the neighbour in a slot, over the edge between, to the neighbour in
 * the slot before or after. */
class WayOver
{
public:
  constexpr WayOver() = default;
  constexpr WayOver(std::size_t over, std::size_t target)
    : Both(static_cast<std::uint32_t>(over | target << Bits))
  {
  }
  constexpr Slot over() const { return static_cast<Slot>(this->Both); }
  constexpr Slot target() const { return static_cast<Slot>(this->Both >> Bits); }
  /** The same way between neighbours so many slots on. */
  constexpr WayOver later(std::size_t slots) const
  {
    WayOver way;
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
  GEODESIC_INLINED void add(WindowMasks::Some bits, ItemOf itemOf)
  {
    std::size_t count = this->Count;
    do
    {
      const auto found = static_cast<std::size_t>(std::popcount(bits));
      for (std::size_t i = 0; i < Usual; ++i)
      {
        // Of no bits the number is any, and they are not counted.
        constexpr WindowMasks::Some stop = ~(~WindowMasks::Some{ 0 } >> 1);
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
 * The ways that fronts are to go in the windows, as what was noted of the neighbours says: lists of
 * those along edges and those over edges, made in all windows at once; a part of RingSweep.
 */
class RingWays
{
public:
  using AlongList = BitList<Slot, RingWindows::Slots, 8>;
  using OverList = BitList<WayOver, 2 * RingWindows::Slots, 6>;

  /** To neighbours. */
  const AlongList& along() const { return this->Along; }
  /** Of fronts of a shape. */
  OverList& over(FrontShape shape) { return this->Over[static_cast<std::size_t>(shape)]; }

  /** Makes the list along edges; only the edges of open triangles stay in RingWindows::along. */
  GEODESIC_INLINED void noteAlong(RingWindows& windows)
  {
    const Masks end = windows.end.all();
    const Masks again = windows.again.all();
    const Masks isOpen = openTriangles(windows);
    // Before the first neighbour comes the triangle that ends where it comes again.
    const Masks isOpenBeforeFirst = WindowMasks::all((isOpen & again >> 1) != 0) & 1;
    const Masks isOpenEdge = isOpen | isOpen << 1 | isOpenBeforeFirst;
    const Masks isOnce = (end - 1) | (end & ~again);
    windows.along.set(windows.along.all() & isOnce & isOpenEdge);
    this->Along.clear();
    inSomeWindows(
      [&](std::size_t first, std::size_t base)
      {
        this->Along.add(windows.along.some(first),
          [&](std::size_t slot) { return static_cast<Slot>(base + slot); });
      });
  }

  /** Makes the lists over edges. */
  GEODESIC_INLINED void noteOver(RingWindows& windows)
  {
    const Masks again = windows.again.all();
    const auto rounded = [&](const Masks& masks) { return masks | (again & -(masks & 1)); };
    const Masks isOpen = openTriangles(windows);
    const Masks isThin = windows.isThin.all();
    const Masks isSettled = ~rounded(windows.isQueued.all());
    const Masks along = rounded(windows.along.all());
    // The edge to a vertex that waits is crossed from there; not so in a thin triangle, where what
    // lies behind the edge may come before it.
    const Masks first =
      (windows.first.all() | (isThin & along >> 1)) & isOpen & (isThin | isSettled >> 1);
    const Masks second = (windows.second.all() | (isThin & along)) & isOpen & (isThin | isSettled);
    const Masks isStraight = windows.isStraight.all();
    this->noteOver(FrontShape::Round, first & ~isStraight, second & ~isStraight);
    this->noteOver(FrontShape::Straight, first & isStraight, second & isStraight);
  }

private:
  using Masks = WindowMasks::All;

  /** Of all windows. */
  GEODESIC_INLINED static Masks openTriangles(const RingWindows& windows)
  {
    return windows.isOpen.all() & (windows.end.all() - 1);
  }

  /** Calls @p work with the first of some windows that come together in masks, and its first slot.
   */
  template <class Work>
  GEODESIC_INLINED static void inSomeWindows(const Work& work)
  {
    for (std::size_t first = 0; first < RingWindows::Most; first += WindowMasks::SizeOfSome)
    {
      work(first, first * RingWindows::Size);
    }
  }

  /** @param first, second  as in RingWindows, of fronts of the shape */
  GEODESIC_INLINED void noteOver(FrontShape shape, const Masks& first, const Masks& second)
  {
    OverList& ways = this->over(shape);
    ways.clear();
    WindowMasks back;
    WindowMasks on;
    back.set(first);
    on.set(second);
    if (!back.hasAny() && !on.hasAny())
    {
      return;
    }
    inSomeWindows(
      [&](std::size_t window, std::size_t base)
      {
        ways.add(
          back.some(window), [&](std::size_t slot) { return WayOver(1, 0).later(base + slot); });
        ways.add(
          on.some(window), [&](std::size_t slot) { return WayOver(0, 1).later(base + slot); });
      });
  }

  AlongList Along;
  /** By the front's shape. */
  std::array<OverList, 2> Over;
};

}

#endif
