// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UpdateBatch_h
#define geodesic_UpdateBatch_h

#include "base/Index.h"
#include "base/Lanes.h"
#include "march/NeighbourValues.h"
#include "march/UpdateBounds.h"
#include "mesh/VertexRings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace geodesic
{

/** The number of a slot of UpdateBatch. */
using Slot = std::uint16_t;

/** Numbers from an array. @param slotAt gives, for the number of a lane, the place of its number */
template <class Real, std::size_t Size, class SlotAt>
GEODESIC_INLINED Real gathered(const std::array<double, Size>& numbers, SlotAt slotAt)
{
  return lanesOf<Real>([&](std::size_t lane) { return numbers[slotAt(lane)]; });
}

/** One mask of 16 bits for each row of an UpdateBatch. The masks of all rows are treated at once.
 */
class BatchMasks
{
public:
  /** One bit for each slot of a row, or for each triangle between a slot and the next. */
  using Mask = std::uint16_t;
  /** Number of slots of a row. */
  static constexpr std::size_t Size = 16;
  /** Largest number of rows. */
  static constexpr std::size_t Most = 16;
  /** The masks of all rows. */
  using All = Mask __attribute__((vector_size(Most * sizeof(Mask))));
  /** The masks of four consecutive rows in one number; the first slot is its lowest bit. */
  using Some = std::uint64_t;
  static constexpr std::size_t SizeOfSome = sizeof(Some) / sizeof(Mask);

  /** A mask with all bits set if @p test holds, else with none. */
  static Mask allIf(bool test) { return static_cast<Mask>(test ? ~0u : 0u); }

  BatchMasks() = default;
  explicit BatchMasks(Mask mask) { this->Masks.fill(mask); }
  Mask& operator[](std::size_t row) { return this->Masks[row]; }
  Mask operator[](std::size_t row) const { return this->Masks[row]; }

  GEODESIC_INLINED All all() const
  {
    All all;
    std::memcpy(&all, this->Masks.data(), sizeof all);
    return all;
  }
  GEODESIC_INLINED void set(const All& all) { std::memcpy(this->Masks.data(), &all, sizeof all); }
  /** The result of a comparison as masks: all bits for the rows where it holds, else none. */
  GEODESIC_INLINED static All all(const decltype(All() == All())& test)
  {
    return reinterpret_cast<const All&>(test);
  }
  /** Whether any bit of any row is set. */
  bool hasAny() const
  {
    Some any = 0;
    for (std::size_t first = 0; first < Most; first += SizeOfSome)
    {
      any |= this->some(first);
    }
    return any != 0;
  }
  /** The masks of rows @p first to first + 3. */
  Some some(std::size_t first) const
  {
    if constexpr (std::endian::native == std::endian::little)
    {
      Some some;
      std::memcpy(&some, &this->Masks[first], sizeof some);
      return some;
    }
    // A big-endian processor would read the rows in the wrong order.
    Some some = 0;
    for (std::size_t i = SizeOfSome; i > 0; --i)
    {
      some = some << Size | this->Masks[first + i - 1];
    }
    return some;
  }

private:
  alignas(All) std::array<Mask, Most> Masks{};
};

/**
 * The data of one batch: up to 12 vertices that are updated round together. The ring of each vertex
 * has a row of 16 slots, one for each neighbour; a longer ring is cut into several rows. What an
 * update needs to know of the neighbours is in flat arrays with a number for each slot, so that
 * several neighbours can be treated at once. NeighbourUpdate.h says what is done with a batch.
 */
struct UpdateBatch
{
  /** Number of slots of a row. */
  static constexpr std::size_t Size = BatchMasks::Size;
  /** Largest number of rows. */
  static constexpr std::size_t Most = 12;
  /** Number of slots of all rows. */
  static constexpr std::size_t Slots = Size * Most;
  static_assert(Most <= BatchMasks::Most && Most % BatchMasks::SizeOfSome == 0);

  /** A vertex and its ring, or a part of the ring. */
  struct Row
  {
    /** The vertex whose neighbours are updated. */
    Index vertex;
    /** Number of slots in use; 0 if nothing is to be done. */
    Index size;
    /** The ring entries of the row, one for each slot in use. */
    const RingEntry* entries;
    /** The slacks of the triangles that these entries open, see TriangleSlack::stored(). */
    const EntryNumber* slacks;
    /** The item of the queue that the row was made for: a value of the vertex. */
    Index item;
    /** In a ring that closes: the last slot, in which the first neighbour comes again; else 0. */
    Index last = 0;
    /** The label of that value. */
    const SourceFront* label;
  };

  /**
   * Adds a row for a ring.
   * @param vertex  the vertex of the ring
   * @param item    what was taken from the queue for it
   * @param ring    the ring, or the rest of one; the row holds its first 16 entries at most
   * @param slacks  of the triangles that the entries open
   * @pre Count < Most
   */
  void add(Index vertex, Index item, std::span<const RingEntry> ring, const EntryNumber* slacks)
  {
    Row& row = this->Rows[this->Count++];
    row.vertex = vertex;
    row.item = item;
    row.entries = ring.data();
    row.slacks = slacks;
    row.size = static_cast<Index>(std::min(Size, ring.size()));
  }

  /** Two or four neighbours in consecutive slots, some of which have a best value of another label
   * than their row. */
  class Others
  {
  public:
    Others() = default;
    /** @param first the first slot; @param which bit i: whether slot first + i has such a value */
    Others(std::size_t first, unsigned which)
      : Both(static_cast<std::uint32_t>(first | which << Bits))
    {
    }
    Slot first() const { return static_cast<Slot>(this->Both); }
    unsigned which() const { return this->Both >> Bits; }

  private:
    static constexpr int Bits = 16;
    /** Both in one number, so that one instruction stores them. */
    std::uint32_t Both = 0;
  };

  /** Removes all rows. */
  void clear()
  {
    this->Count = 0;
    this->OthersCount = 0;
    for (BatchMasks* masks : { &this->along, &this->first, &this->second, &this->isThin })
    {
      masks->set(BatchMasks::All());
    }
  }

  /** The number of a slot's row. */
  static std::size_t rowOf(Slot slot) { return slot / Size; }
  /** The row of a slot. */
  Row& at(Slot slot) { return this->Rows[rowOf(slot)]; }
  const Row& at(Slot slot) const { return this->Rows[rowOf(slot)]; }

  /** Number of rows in use. */
  std::size_t Count = 0;
  std::array<Row, Most> Rows;
  /** Number of items in OthersSeen; one item more may be written behind them. */
  std::size_t OthersCount = 0;
  std::array<Others, Slots / lanes<Pair> + 1> OthersSeen;
  /** For each row, the value of its vertex. */
  std::array<double, Most> OwnValues;

  // Masks, one for each row. Bit i belongs to the neighbour in slot i of the row, or to the
  // triangle that this neighbour opens: that of the row's vertex and the neighbours in slots i and
  // i + 1. In rows that are not in use along, first, second and isThin are 0.

  /** The last slot in use. */
  BatchMasks end;
  /** In a ring that closes, the slot in which the first neighbour comes again. */
  BatchMasks again;
  /** All bits if the row's label has a straight front, else none. */
  BatchMasks isStraight;
  /** Neighbours that wait in the queue with their values of the row's label. */
  BatchMasks isQueued;
  /** Triangles that fronts may cross. */
  BatchMasks isOpen{ BatchMasks::allIf(true) };
  /** Triangles that are thin, see TriangleSlack. */
  BatchMasks isThin;
  /** Neighbours that may gain by the edge from the row's vertex to them. */
  BatchMasks along;
  /** Triangles in which neighbour i may gain by a crossing of the edge from the row's vertex to
   * neighbour i + 1. */
  BatchMasks first;
  /** Triangles in which neighbour i + 1 may gain by a crossing of the edge to neighbour i. */
  BatchMasks second;

  // Numbers, one for each slot. In a ring that closes, the last slot repeats the first neighbour.

  std::array<Index, Slots> Neighbours;
  /** NeighbourValue::value for the row's label. */
  alignas(Quad) std::array<double, Slots> Values{};
  /** NeighbourValue::ceiling; only in use with several labels. */
  alignas(Quad) std::array<double, Slots> Ceilings{};
  /** The vector from the row's vertex to the neighbour, and the square of its length. */
  alignas(Quad) std::array<double, Slots> X;
  alignas(Quad) std::array<double, Slots> Y;
  alignas(Quad) std::array<double, Slots> Z;
  alignas(Quad) std::array<double, Slots> SquaredLengths;
  /** The cost of the triangle that the neighbour before opens; not in use with cost 1. */
  alignas(Quad) std::array<double, Slots> Costs;
};

}

#endif
