#ifndef geodesic_RingWindows_h
#define geodesic_RingWindows_h

#include "Index.h"
#include "KnownValues.h"
#include "Lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace geodesic
{

/** The number of a slot of RingWindows. */
using Slot = std::uint16_t;

/** Numbers from a list, at the places that a lane's number leads to. */
template <class Real, std::size_t Size, class SlotAt>
GEODESIC_INLINED Real gathered(const std::array<double, Size>& numbers, SlotAt slotAt)
{
  return lanesOf<Real>([&](std::size_t lane) { return numbers[slotAt(lane)]; });
}

/**
 * Some vertices with their rings, cut into windows of a size, and what a sweep knows of the
 * neighbours: slot by slot in flat arrays, so that several can be treated at once, wherever they
 * are.
 */
struct RingWindows
{
  /** Slots of a window. */
  static constexpr std::size_t Size = 16;
  static constexpr std::size_t Most = 12;
  static constexpr std::size_t Slots = Size * Most;
  /** One bit for each slot of a window, or for each triangle between a slot and the next. */
  using Mask = std::uint32_t;

  struct Window
  {
    Index vertex;
    /** That the vertex is swept for. */
    const MarchedLabel* label;
    /** Where in the vertex's ring the window begins. */
    Index firstEntry;
    /** Slots in use. */
    Index size;
    /** The slot in which the first neighbour comes again, where the window closes; else 0. */
    Mask last;
    /** Neighbours that wait to be swept with their values. */
    Mask isQueued;
    /** Triangles that may be crossed. */
    Mask isOpen;
    Mask isThin;
    /** Neighbours that may gain, along the edge to them. */
    Mask along;
    /** Triangles in which the neighbour that opens them, or the one after it, may gain over the
     * edge to the other. */
    Mask first;
    Mask second;
  };

  /** Neighbours side by side, some of which have a best value of another label than the one that
   * is swept. */
  class Others
  {
  public:
    Others() = default;
    Others(std::size_t first, unsigned which)
      : Both(static_cast<std::uint32_t>(first | which << Bits))
    {
    }
    Slot first() const { return static_cast<Slot>(this->Both); }
    /** From the first on. */
    unsigned which() const { return this->Both >> Bits; }

  private:
    static constexpr int Bits = 16;
    /** In one number, which is written at once. */
    std::uint32_t Both = 0;
  };

  static std::size_t windowOf(Slot slot) { return slot / Size; }
  Window& at(Slot slot) { return this->Windows[windowOf(slot)]; }
  const Window& at(Slot slot) const { return this->Windows[windowOf(slot)]; }

  std::size_t Count = 0;
  std::array<Window, Most> Windows;
  std::size_t OthersCount = 0;
  std::array<Others, Slots / lanes<Pair> + 1> OthersSeen;
  /** Of the windows' vertices. */
  std::array<double, Most> OwnValues;

  // Of the neighbours; the first one in a window comes again in the last slot, where it closes.
  std::array<Index, Slots> Neighbours;
  /** As in KnownValue. */
  alignas(Quad) std::array<double, Slots> Values;
  alignas(Quad) std::array<double, Slots> Ceilings;
  /** From the window's vertex. */
  alignas(Quad) std::array<double, Slots> X;
  alignas(Quad) std::array<double, Slots> Y;
  alignas(Quad) std::array<double, Slots> Z;
  alignas(Quad) std::array<double, Slots> SquaredLengths;
};

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
  /** Adds slot by slot. */
  friend constexpr WayOver operator+(WayOver a, WayOver b)
  {
    a.Both += b.Both;
    return a;
  }

private:
  static constexpr int Bits = 16;
  /** Two slots in one number, which is written at once. */
  std::uint32_t Both = 0;
};

/** In the first window, by the number of a bit in Window::first and, RingWindows::Size higher,
 * Window::second. */
inline constexpr auto waysOver = []
{
  std::array<WayOver, 2 * RingWindows::Size> ways;
  for (std::size_t slot = 0; slot < RingWindows::Size; ++slot)
  {
    ways[slot] = WayOver(slot + 1, slot);
    ways[slot + RingWindows::Size] = WayOver(slot, slot + 1);
  }
  return ways;
}();

/**
 * A list that takes on one item for each bit of a mask. How many bits there are is not to be
 * guessed, so for up to @p Usual there is no branch on it.
 * @tparam Size  the most items there can be, and Usual more
 */
template <class Item, std::size_t Size, std::size_t Usual>
class BitList
{
public:
  /** @param itemOf gives the item of a bit's number */
  template <class ItemOf>
  GEODESIC_INLINED void add(RingWindows::Mask bits, ItemOf itemOf)
  {
    std::size_t count = this->Count;
    do
    {
      const auto found = static_cast<std::size_t>(std::popcount(bits));
      for (std::size_t i = 0; i < Usual; ++i)
      {
        // Of no bits the number is any, and they are not counted.
        constexpr RingWindows::Mask stop = 1u << 31;
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

}

#endif
