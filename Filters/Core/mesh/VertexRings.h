// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexRings_h
#define geodesic_VertexRings_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/Platform.h"
#include "base/SharedVector.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"
#include "mesh/RingNumbers.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * One neighbour in the ring of a vertex. Where opensTriangle() holds, the vertex, this neighbour
 * and the next entry's neighbour are the corners of a triangle.
 */
class RingEntry
{
public:
  constexpr RingEntry() = default;
  constexpr explicit RingEntry(Index neighbour, bool opensTriangle = false)
    : Bits(neighbour | (opensTriangle ? OpensTriangle : 0u))
  {
  }

  constexpr Index neighbour() const { return this->Bits & NeighbourBits; }
  constexpr bool opensTriangle() const { return (this->Bits & OpensTriangle) != 0; }

  friend constexpr bool operator==(const RingEntry&, const RingEntry&) = default;

  /** The bits of an entry that hold its neighbour, for code that reads several entries at once. */
  static constexpr Index NeighbourBits = 0x7fffffffu;

private:
  static constexpr Index OpensTriangle = ~NeighbourBits;
  Index Bits = 0;
};

/**
 * The triangles round every vertex, as fans of neighbours. A fan of k triangles has k + 1 entries;
 * a fan that closes round the vertex repeats its first neighbour at its end. A manifold vertex,
 * inside or on the boundary, has one fan. Edges with more than two triangles, or sheets that meet
 * in a vertex, add fans. The orientation of the triangles does not matter.
 */
class VertexRings
{
public:
  VertexRings() = default;
  /**
   * @param triangles  three different vertices each, sorted by the lowest of them
   * @param positions  of the vertices
   * @param room       workspace, RoomOfTriangle numbers for each triangle
   * @param team       threads to work on; the rings do not depend on their number
   * @param numbers    numbers to make along with the rings by their measurer; null for none
   * @throws std::length_error for more than about 700 million triangles
   * Time O(n).
   */
  VertexRings(std::span<const Triangle> triangles, std::span<const Vector3> positions,
    std::span<Index> room, const ThreadTeam& team, RingNumbers* numbers = nullptr);

  /** The same rings of vertices that were moved. @param longestSides see longestSides() */
  VertexRings withLongestSides(BulkVector<float> longestSides) const;
  /** Whether these are the rings of another object, but for the longest sides. */
  bool areShared(const VertexRings& other) const { return this->Entries.isShared(other.Entries); }

  /** @throws std::length_error where rings can't hold so many triangles: above 715,827,882 */
  static void checkNumber(std::size_t triangles);

  /** Numbers of workspace that each triangle takes while the rings are made. */
  static constexpr std::size_t RoomOfTriangle = 3;
  /** The number of entries that may be read past the end of a ring, so that code can read several
   * at once. */
  static constexpr std::size_t Overrun = 3;

  /** The ring of a vertex. */
  std::span<const RingEntry> operator[](Index vertex) const
  {
    return { this->Entries.data() + this->Starts[vertex],
      this->Entries.data() + this->Starts[vertex + 1] };
  }

  /** Asks the processor to fetch a ring that will soon be read: all of it at most vertices, the
   * beginning of longer ones. GCC drops the call unless it is inlined. */
  GEODESIC_INLINED void prefetch(Index vertex) const
  {
    const RingEntry* const entries = this->Entries.data() + this->Starts[vertex];
    prefetchToRead(entries);
    prefetchToRead(entries + 6);
  }

  /** Asks the processor to fetch the start index of a ring, which prefetch() reads. */
  GEODESIC_INLINED void prefetchStart(Index vertex) const { prefetchToRead(&this->Starts[vertex]); }

  /** The index of a ring's entry among the entries of all rings. */
  std::size_t numberOf(const RingEntry* entry) const
  {
    return static_cast<std::size_t>(entry - this->Entries.data());
  }
  /** The index of a vertex's first entry; see numberOf(). */
  std::uint32_t firstEntry(Index vertex) const { return this->Starts[vertex]; }
  /** For each vertex the length of the longest side of the triangles round it, rounded up. */
  std::span<const float> longestSides() const { return this->LongestSides; }
  std::size_t numberOfEntries() const { return this->Starts.back(); }

private:
  struct Ring
  {
    Index vertex;
    std::vector<RingEntry> entries;
    /** The number of each entry; empty if no numbers are made. */
    std::vector<EntryNumber> numbers;
  };
  class Range;
  template <bool HasNumbers>
  class Filling;
  /** What rings are made of, while they are made. */
  struct Parts
  {
    /** Counts the triangles at each vertex of a range in starts; returns the sum of the counts. */
    std::size_t countCorners(const Range& range);
    /** Replaces the rings of some vertices by @p others, sorted by vertex, which may be longer, and
     * the numbers of their entries, if there are any. */
    void replace(std::span<const Ring> others, RingNumbers* numbers);

    std::vector<std::uint32_t> starts;
    BulkVector<RingEntry> entries;
    BulkVector<float> longestSides;
  };

  SharedVector<std::uint32_t> Starts;
  /** The entries of all rings, one ring after the other, and Overrun more. */
  SharedVector<RingEntry> Entries;
  BulkVector<float> LongestSides;
};

}

#endif
