// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexRings_h
#define geodesic_VertexRings_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"

#include <bit>
#include <cstdint>
#include <limits>
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
  /** Opens no triangle. */
  constexpr explicit RingEntry(Index neighbour)
    : Neighbour(neighbour)
  {
  }
  /** Opens a triangle, of which the rest tells: a finite slack, less than 0 where it is thin. */
  constexpr RingEntry(Index neighbour, float slack, bool isThin)
    : Neighbour(neighbour)
    , Slack(slackWith(isThin, slack))
  {
  }
  /** The entry of another neighbour that opens the same triangle. */
  constexpr RingEntry at(Index neighbour) const
  {
    RingEntry entry = *this;
    entry.Neighbour = neighbour;
    return entry;
  }
  constexpr Index neighbour() const { return this->Neighbour; }
  constexpr bool opensTriangle() const { return this->Slack < NoSlack; }
  /** Whether the triangle's height over its longest side is less than a quarter of that. */
  constexpr bool isThin() const
  {
    return (std::bit_cast<std::uint32_t>(this->Slack) & ThinBit) != 0;
  }

  /**
   * Tells from three values that no update of the triangle can gain anything: the least of 2 h - c
   * over its sides, with c the length of the side and h the height over it, rounded down. A
   * distance is 1-Lipschitz, so nowhere on a side less than (a + b - c) / 2 with a and b at its
   * ends; over it the third corner gets no less than (a + b + slack) / 2. +infinity without a
   * triangle.
   */
  constexpr float slack() const { return this->Slack; }

  friend constexpr bool operator==(const RingEntry&, const RingEntry&) = default;

  /** For who reads several at once: the bit of a slack that isThin() is. */
  static constexpr std::uint32_t ThinBit = 1;

private:
  static constexpr float NoSlack = std::numeric_limits<float>::infinity();

  /** Rounded down to where its last bit says whether the triangle is thin, by that bit or none. */
  static constexpr float slackWith(bool isThin, float slack)
  {
    const auto bits = std::bit_cast<std::uint32_t>(slack);
    const std::uint32_t off = (bits ^ (isThin ? ThinBit : 0u)) & ThinBit;
    const std::uint32_t isNegative = bits >> 31;
    return std::bit_cast<float>(bits - off + 2 * (off & isNegative));
  }

  Index Neighbour = 0;
  float Slack = NoSlack;
};

/** The largest of what is measured of the triangles round a vertex. */
struct VertexSize
{
  /** Longest side, rounded up. */
  float longestSide = 0.0f;
  /** labelMargin(), rounded up. */
  float margin = 0.0f;
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
  [[gnu::always_inline]] void prefetch(Index vertex) const
  {
    const RingEntry* const entries = this->Entries.data() + this->Starts[vertex];
    constexpr std::size_t cacheLine = 64;
    __builtin_prefetch(entries);
    __builtin_prefetch(entries + cacheLine / sizeof(RingEntry));
  }

  /** Has it fetch what tells where that ring is. */
  [[gnu::always_inline]] void prefetchStart(Index vertex) const
  {
    __builtin_prefetch(&this->Starts[vertex]);
  }

  /** Number of a vertex's first entry, counted over the rings of all vertices. */
  std::uint32_t firstEntry(Index vertex) const { return this->Starts[vertex]; }
  /** One a vertex. */
  std::span<const VertexSize> sizes() const { return this->Sizes; }
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
  BulkVector<VertexSize> Sizes;
};

}

#endif
