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

/** Numbers from a list, at the places that a lane's number leads to. */
template <class Real, std::size_t Size, class SlotAt>
GEODESIC_INLINED Real gathered(const std::array<double, Size>& numbers, SlotAt slotAt)
{
  return lanesOf<Real>([&](std::size_t lane) { return numbers[slotAt(lane)]; });
}

/** One mask for each of some rows, see UpdateBatch: treated all at once. */
class BatchMasks
{
public:
  /** One bit for each slot of a row, or for each triangle between a slot and the next. */
  using Mask = std::uint16_t;
  /** Slots of a row. */
  static constexpr std::size_t Size = 16;
  static constexpr std::size_t Most = 16;
  using All = Mask __attribute__((vector_size(Most * sizeof(Mask))));
  /** Those of rows side by side, whose slots follow each other. */
  using Some = std::uint64_t;
  static constexpr std::size_t SizeOfSome = sizeof(Some) / sizeof(Mask);

  /** All bits or none. */
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
  /** Each all bits where a test holds, else none. */
  GEODESIC_INLINED static All all(const decltype(All() == All())& test)
  {
    return reinterpret_cast<const All&>(test);
  }
  bool hasAny() const
  {
    Some any = 0;
    for (std::size_t first = 0; first < Most; first += SizeOfSome)
    {
      any |= this->some(first);
    }
    return any != 0;
  }
  /** Of the rows from @p first on. */
  Some some(std::size_t first) const
  {
    if constexpr (std::endian::native == std::endian::little)
    {
      Some some;
      std::memcpy(&some, &this->Masks[first], sizeof some);
      return some;
    }
    // The first slot is in the lowest bit.
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
 * Some vertices with their rings, cut into rows of a size, and what a update knows of the
 * neighbours: slot by slot in flat arrays, so that several can be treated at once, wherever they
 * are.
 */
struct UpdateBatch
{
  /** Slots of a row. */
  static constexpr std::size_t Size = BatchMasks::Size;
  static constexpr std::size_t Most = 12;
  static constexpr std::size_t Slots = Size * Most;
  static_assert(Most <= BatchMasks::Most && Most % BatchMasks::SizeOfSome == 0);

  struct Row
  {
    Index vertex;
    /** Slots in use; 0 where there is nothing to be done. */
    Index size;
    const RingEntry* entries;
    /** Of the triangles that they open. */
    const TriangleSlack* slacks;
    /** What of the queue the vertex is swept for. */
    Index item;
    /** The slot in which the first neighbour comes again, where the row closes; else 0. */
    Index last = 0;
    /** That the vertex is swept for. */
    const SourceFront* label;
  };

  /** Adds a row onto the first part of a ring, or of the rest of one. @pre Count < Most */
  void add(Index vertex, Index item, std::span<const RingEntry> ring, const TriangleSlack* slacks)
  {
    Row& row = this->Rows[this->Count++];
    row.vertex = vertex;
    row.item = item;
    row.entries = ring.data();
    row.slacks = slacks;
    row.size = static_cast<Index>(std::min(Size, ring.size()));
  }

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

  void clear()
  {
    this->Count = 0;
    this->OthersCount = 0;
    for (BatchMasks* masks : { &this->along, &this->first, &this->second, &this->isThin })
    {
      masks->set(BatchMasks::All());
    }
  }

  static std::size_t rowOf(Slot slot) { return slot / Size; }
  Row& at(Slot slot) { return this->Rows[rowOf(slot)]; }
  const Row& at(Slot slot) const { return this->Rows[rowOf(slot)]; }

  std::size_t Count = 0;
  std::array<Row, Most> Rows;
  std::size_t OthersCount = 0;
  std::array<Others, Slots / lanes<Pair> + 1> OthersSeen;
  /** Of the rows' vertices. */
  std::array<double, Most> OwnValues;

  // Of the rows; of those that are not there along, first, second and isThin are 0.

  /** The last slot in use. */
  BatchMasks end;
  /** The slot in which the first neighbour comes again, where the row closes. */
  BatchMasks again;
  /** Whether the front is straight: all bits or none. */
  BatchMasks isStraight;
  /** Neighbours that wait to be swept with their values. */
  BatchMasks isQueued;
  /** Triangles that may be crossed. */
  BatchMasks isOpen{ BatchMasks::allIf(true) };
  BatchMasks isThin;
  /** Neighbours that may gain, along the edge to them. */
  BatchMasks along;
  /** Triangles in which the neighbour that opens them, or the one after it, may gain over the
   * edge to the other. */
  BatchMasks first;
  BatchMasks second;

  // Of the neighbours; the first one in a row comes again in the last slot, where it closes.
  std::array<Index, Slots> Neighbours;
  /** As in NeighbourValue. */
  alignas(Quad) std::array<double, Slots> Values{};
  alignas(Quad) std::array<double, Slots> Ceilings{};
  /** From the row's vertex. */
  alignas(Quad) std::array<double, Slots> X;
  alignas(Quad) std::array<double, Slots> Y;
  alignas(Quad) std::array<double, Slots> Z;
  alignas(Quad) std::array<double, Slots> SquaredLengths;
};

}

#endif
