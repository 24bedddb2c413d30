// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexRings_h
#define geodesic_VertexRings_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/Platform.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"

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

  /** Those bits of an entry that are its neighbour, for code that reads several entries at once. */
  static constexpr Index NeighbourBits = 0x7fffffffu;

private:
  static constexpr Index OpensTriangle = ~NeighbourBits;
  Index Bits = 0;
};

/**
 * The triangles round every vertex, as fans of neighbours. A fan of k triangles has k + 1 entries;
 * one that closes round the vertex ends with its first neighbour again. A boundary or manifold
 * vertex has one fan; an edge with more than two triangles, or sheets that meet in a vertex, only
 * mean more fans. The orientation of the triangles plays no part.
 */
class VertexRings
{
public:
  VertexRings() = default;
  /**
   * @param triangles  three different vertices each, in the order of the lowest ones
   * @param positions  of the vertices
   * @param room       to work in, three numbers a triangle
   * @param team       threads to work on; the rings do not depend on their number
   * Time O(n).
   */
  VertexRings(std::span<const Triangle> triangles, std::span<const Vector3> positions,
    std::span<Index> room, const ThreadTeam& team);

  /** How many entries after the end of a ring may be read. */
  static constexpr std::size_t Overrun = 3;

  /** The ring of a vertex. */
  std::span<const RingEntry> operator[](Index vertex) const
  {
    return { this->Entries.data() + this->Starts[vertex],
      this->Entries.data() + this->Starts[vertex + 1] };
  }

  /** Has the processor fetch a ring that is soon to be read, the whole of most. GCC drops
   * the call unless it is inlined. */
  GEODESIC_INLINED void prefetch(Index vertex) const
  {
    const RingEntry* const entries = this->Entries.data() + this->Starts[vertex];
    prefetchToRead(entries);
    prefetchToRead(entries + 6);
  }

  /** Has it fetch what tells where that ring is. */
  GEODESIC_INLINED void prefetchStart(Index vertex) const { prefetchToRead(&this->Starts[vertex]); }

  /** The number of an entry of a ring, counted over the rings of all vertices. */
  std::size_t numberOf(const RingEntry* entry) const
  {
    return static_cast<std::size_t>(entry - this->Entries.data());
  }
  /** That of a vertex's first entry. */
  std::uint32_t firstEntry(Index vertex) const { return this->Starts[vertex]; }
  /** Of each vertex the length of the longest side of the triangles round it, rounded up. */
  std::span<const float> longestSides() const { return this->LongestSides; }
  std::size_t numberOfEntries() const { return this->Starts.back(); }

private:
  struct Ring
  {
    Index vertex;
    std::vector<RingEntry> entries;
  };
  class Range;
  class Filling;

  /** Counts the corners at each vertex of a range to Starts; returns their sum. */
  std::size_t countCorners(const Range& range);
  /** Replaces rings, which are sorted by vertex, by others of other sizes. */
  void replace(std::span<const Ring> others);

  std::vector<std::uint32_t> Starts;
  /** And Overrun more. */
  BulkVector<RingEntry> Entries;
  BulkVector<float> LongestSides;
};

}

#endif
