// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/VertexRings.h"

#include "base/Interruption.h"
#include "base/Platform.h"
#include "mesh/RingBuilder.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic
{
namespace
{

/** Consecutive numbers, from first() to before last(). */
class IndexRange
{
public:
  IndexRange(Index first, Index size)
    : First(first)
    , Size(size)
  {
  }
  Index first() const { return this->First; }
  Index last() const { return this->First + this->Size; }
  Index size() const { return this->Size; }
  bool has(Index i) const { return i - this->First < this->Size; }

private:
  Index First;
  Index Size;
};

/** The range of all numbers: its test always holds and costs nothing. */
struct EveryIndex
{
  static bool has(Index) { return true; }
};

}

/** A range of consecutive vertices, and the triangles that have a corner in it. */
class VertexRings::Range
{
public:
  /**
   * @param first      the first vertex
   * @param last       the vertex after the last one
   * @param triangles  those of the whole mesh, sorted by their lowest corners
   * @param isWhole    whether the range is all vertices
   */
  Range(std::size_t first, std::size_t last, std::span<const Triangle> triangles, bool isWhole)
    : Vertices(static_cast<Index>(first), static_cast<Index>(last - first))
    , IsWhole(isWhole)
  {
    const auto firstFrom = [&](std::size_t vertex)
    {
      return std::partition_point(triangles.begin(), triangles.end(),
        [&](const Triangle& t) { return lowestCorner(t) < vertex; });
    };
    const auto own = firstFrom(first);
    std::copy_if(triangles.begin(), own, std::back_inserter(this->ReachIn),
      [vertices = this->Vertices](const Triangle& t)
      { return vertices.has(t[0]) || vertices.has(t[1]) || vertices.has(t[2]); });
    this->BeginHere = { own, firstFrom(last) };
  }

  IndexRange vertices() const { return this->Vertices; }
  /** Calls @p work with an object whose has(vertex) tells whether a vertex is in the range. */
  template <class Work>
  void withVertices(const Work& work) const
  {
    this->IsWhole ? work(EveryIndex()) : work(this->Vertices);
  }
  /** The triangles whose lowest corner is before the range. */
  std::span<const Triangle> reachIn() const { return this->ReachIn; }
  /** The triangles whose lowest corner is in the range. */
  std::span<const Triangle> beginHere() const { return this->BeginHere; }

private:
  IndexRange Vertices;
  bool IsWhole;
  std::vector<Triangle> ReachIn;
  std::span<const Triangle> BeginHere;
};

/**
 * Makes the rings of a range of vertices. It goes through the triangles once and appends, for each
 * corner, an entry to the place where the corner's ring will be. As soon as all triangles of a
 * vertex have come, its entries are put into the order of fans, while they are still in the cache.
 */
template <bool HasNumbers>
class VertexRings::Filling
{
public:
  /**
   * @param rings      gets the rings; its starts hold the number of triangles at each vertex
   * @param start      index of the first entry of the range's first vertex
   * @param room       workspace, a number for each triangle at each vertex
   * @param numbers    to make along with the rings, if @p HasNumbers
   */
  Filling(Parts& rings, const Range& range, std::size_t start, std::span<const Vector3> positions,
    std::span<Index> room, RingNumbers* numbers)
    : OfRange(range)
    , Positions(positions)
    , Measurer(numbers ? numbers->measurer : nullptr)
    , OfNoTriangle(numbers ? numbers->measurer->ofNoTriangle() : EntryNumber{})
    , AllRings{ rings.starts.data(), rings.entries.data(), room.data(), rings.longestSides.data(),
      numbers ? numbers->ofEntries.data() : nullptr,
      numbers ? numbers->ofVertices.data() : nullptr }
    , NextVertex(range.vertices().first())
    , NextStart(start)
    , ClosedFan(static_cast<Index>(positions.size()))
  {
  }

  /** Makes the rings. Those of more than one fan have too many entries for their places: they are
   * returned instead, sorted by vertex. */
  std::vector<Ring> fill()
  {
    const IndexRange vertices = this->OfRange.vertices();
    std::size_t start = this->NextStart;
    for (Index v = vertices.first(); v < vertices.last(); ++v)
    {
      start += std::exchange(this->AllRings.starts[v], static_cast<std::uint32_t>(start)) + 1;
      this->AllRings.longestSides[v] = 0.0f;
    }
    if constexpr (HasNumbers)
    {
      std::fill_n(this->AllRings.ofVertices + vertices.first(), vertices.size(), 0.0f);
    }
    this->OfRange.withVertices(
      [&](const auto& ours)
      {
        this->put(this->OfRange.reachIn(), ours);
        this->put(this->OfRange.beginHere(), ours);
      });
    this->chainBefore(vertices.last());
    return std::move(this->Others);
  }

private:
  /** The rings of all vertices while triangles are added to them. */
  struct Rings
  {
    /** @param i the number of the triangle among those measured last */
    template <class Vertices>
    GEODESIC_INLINED void put(
      const Triangle& t, const TriangleNumbers& measured, std::size_t i, const Vertices& ours) const
    {
      const float longestSide = measured.longestSides[i];
      const EntryNumber ofEntry = HasNumbers ? measured.ofEntries[i] : EntryNumber{};
      const float ofVertex = HasNumbers ? measured.ofVertices[i] : 0.0f;
      for (int c = 0; c < 3; ++c)
      {
        const Index v = t[c];
        if (ours.has(v))
        {
          // While entries are added, starts holds the end of the ring; chainBefore() restores it.
          const std::uint32_t place = this->starts[v]++;
          this->entries[place] = RingEntry(t[(c + 1) % 3], true);
          this->ends[place - v] = t[(c + 2) % 3];
          this->longestSides[v] = std::max(this->longestSides[v], longestSide);
          if constexpr (HasNumbers)
          {
            this->ofEntries[place] = ofEntry;
            this->ofVertices[v] = std::max(this->ofVertices[v], ofVertex);
          }
        }
      }
    }

    /** Asks the processor to fetch the place in the ring of the highest corner, the one least
     * likely to be in the cache. GCC drops the call unless it is inlined. */
    template <class Vertices>
    GEODESIC_INLINED void prefetch(const Triangle& t, const Vertices& ours) const
    {
      const Index v = highestCorner(t);
      if (ours.has(v))
      {
        const std::uint32_t place = this->starts[v];
        prefetchToWrite(&this->entries[place]);
        prefetchToWrite(&this->ends[place - v]);
        prefetchToWrite(&this->longestSides[v]);
        if constexpr (HasNumbers)
        {
          prefetchToWrite(&this->ofEntries[place]);
          prefetchToWrite(&this->ofVertices[v]);
        }
      }
    }

    std::uint32_t* starts;
    RingEntry* entries;
    /** The second end of the side opposite to the vertex, for each triangle at each vertex. */
    Index* ends;
    float* longestSides;
    EntryNumber* ofEntries;
    float* ofVertices;
  };

  /** Adds triangles, sorted by their lowest corners, to the rings of their corners. */
  template <class Vertices>
  void put(std::span<const Triangle> triangles, const Vertices& ours)
  {
    for (std::size_t first = 0; first < triangles.size(); first += TriangleNumbers::Most)
    {
      const std::span<const Triangle> rest = triangles.subspan(first);
      const std::span<const Triangle> some =
        rest.first(std::min(TriangleNumbers::Most, rest.size()));
      Interruption::check();
      // Triangles still to come have no lower corner, so the rings of lower vertices are complete.
      this->chainBefore(lowestCorner(some.front()));
      measureTriangles(this->Measurer, some, this->Positions, this->Measured);
      // A copy, so that the compiler knows that what is written does not change the pointers.
      const Rings rings = this->AllRings;
      for (std::size_t i = 0; i < some.size(); ++i)
      {
        constexpr std::size_t ahead = 32;
        rings.prefetch(rest[std::min(i + ahead, rest.size() - 1)], ours);
        rings.put(some[i], this->Measured, i, ours);
      }
    }
  }

  /** Puts the rings of all vertices before @p last that aren't yet into the order of fans.
   * @pre all triangles of these vertices were added */
  void chainBefore(Index last)
  {
    for (Index v = this->NextVertex; v < last; ++v)
    {
      const std::size_t start = this->NextStart;
      const std::size_t size =
        std::exchange(this->AllRings.starts[v], static_cast<std::uint32_t>(start)) - start;
      const std::span<RingEntry> ring{ this->AllRings.entries + start, size + 1 };
      const std::span<const Index> ends{ this->AllRings.ends + (start - v), size };
      EntryNumber* const numbers = HasNumbers ? this->AllRings.ofEntries + start : nullptr;
      if (!this->ClosedFan.template chain<HasNumbers>(ends, ring, numbers))
      {
        this->chainAny(v, ends, ring, numbers);
      }
      else if constexpr (HasNumbers)
      {
        numbers[size] = this->OfNoTriangle;
      }
      this->NextStart += ring.size();
    }
    this->NextVertex = std::max(this->NextVertex, last);
  }

  /** @param numbersHere those of the ring's entries, brought into their order */
  void chainAny(
    Index v, std::span<const Index> ends, std::span<RingEntry> ring, EntryNumber* numbersHere)
  {
    this->Sides.clear();
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      this->Sides.push_back({ ring[i].neighbour(), ends[i], static_cast<Index>(i) });
    }
    this->Fans.clear();
    this->FanTriangles.clear();
    this->AnyFans.chain(this->Sides, this->Fans, this->FanTriangles);
    std::vector<EntryNumber> numbers(HasNumbers ? this->Fans.size() : 0);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      const Index triangle = this->FanTriangles[i];
      numbers[i] = triangle == NoIndex ? this->OfNoTriangle : numbersHere[triangle];
    }
    if (this->Fans.size() == ring.size())
    {
      std::copy(this->Fans.begin(), this->Fans.end(), ring.begin());
      std::copy(numbers.begin(), numbers.end(), numbersHere);
    }
    else
    {
      this->Others.push_back({ v, this->Fans, std::move(numbers) });
    }
  }

  const Range& OfRange;
  std::span<const Vector3> Positions;
  const RingMeasurer* Measurer;
  EntryNumber OfNoTriangle;
  TriangleNumbers Measured;
  Rings AllRings;
  Index NextVertex;
  std::size_t NextStart;
  ClosedRingBuilder ClosedFan;
  RingBuilder AnyFans;
  std::vector<OppositeSide> Sides;
  std::vector<RingEntry> Fans;
  std::vector<Index> FanTriangles;
  std::vector<Ring> Others;
};

void VertexRings::checkNumber(std::size_t triangles)
{
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 6;
  if (triangles > most)
  {
    throw std::length_error("The surface has " + std::to_string(triangles) +
      " triangles; one process holds at most " + std::to_string(most) +
      ". Spread it over more ranks.");
  }
}

VertexRings::VertexRings(std::span<const Triangle> triangles, std::span<const Vector3> positions,
  std::span<Index> room, const ThreadTeam& team, RingNumbers* numbers)
{
  const std::size_t vertices = positions.size();
  checkNumber(triangles.size());
  Parts parts;
  parts.starts.resize(vertices + 1);
  parts.longestSides.resize(vertices);
  std::vector<std::optional<Range>> ranges(team.numberOfRanges(vertices));
  std::vector<std::size_t> starts(ranges.size());
  team.run(vertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      ranges[range].emplace(first, last, triangles, ranges.size() == 1);
      starts[range] = parts.countCorners(*ranges[range]);
    });
  // One fan for each vertex: an entry for each of its triangles and one more.
  parts.starts.back() = static_cast<std::uint32_t>(startsOf(starts) + vertices);
  parts.entries.resize(parts.starts.back() + Overrun);
  std::fill(parts.entries.end() - Overrun, parts.entries.end(), RingEntry(0));
  if (numbers)
  {
    numbers->ofVertices.resize(vertices);
    numbers->ofEntries.resize(parts.entries.size());
    std::fill(numbers->ofEntries.end() - Overrun, numbers->ofEntries.end(),
      numbers->measurer->ofNoTriangle());
  }
  std::vector<std::vector<Ring>> others(ranges.size());
  team.run(vertices,
    [&](std::size_t range, std::size_t first, std::size_t)
    {
      const auto fill = [&]<bool HasNumbers>()
      {
        return Filling<HasNumbers>(
          parts, *ranges[range], starts[range] + first, positions, room, numbers)
          .fill();
      };
      others[range] =
        numbers ? fill.template operator()<true>() : fill.template operator()<false>();
    });
  for (std::size_t range = 1; range < others.size(); ++range)
  {
    std::move(others[range].begin(), others[range].end(), std::back_inserter(others[0]));
  }
  if (!others[0].empty())
  {
    parts.replace(others[0], numbers);
  }
  this->Starts = SharedVector(std::move(parts.starts));
  this->Entries = SharedVector(std::move(parts.entries));
  this->LongestSides = std::move(parts.longestSides);
}

VertexRings VertexRings::withLongestSides(BulkVector<float> longestSides) const
{
  VertexRings rings;
  rings.Starts = this->Starts;
  rings.Entries = this->Entries;
  rings.LongestSides = std::move(longestSides);
  return rings;
}

std::size_t VertexRings::Parts::countCorners(const Range& range)
{
  std::uint32_t* const starts = this->starts.data();
  std::size_t sum = 0;
  range.withVertices(
    [&](const auto& vertices)
    {
      for (const std::span<const Triangle> some : { range.reachIn(), range.beginHere() })
      {
        for (const Triangle& t : some)
        {
          for (Index v : t)
          {
            if (vertices.has(v))
            {
              ++starts[v];
              ++sum;
            }
          }
        }
      }
    });
  return sum;
}

void VertexRings::Parts::replace(std::span<const Ring> others, RingNumbers* numbers)
{
  BulkVector<RingEntry> entries;
  BulkVector<EntryNumber> ofEntries;
  entries.reserve(this->entries.size());
  ofEntries.reserve(numbers ? this->entries.size() : 0);
  auto other = others.begin();
  for (Index v = 0; v + 1 < this->starts.size(); ++v)
  {
    const bool isOther = other != others.end() && other->vertex == v;
    const std::span<const RingEntry> ring = isOther
      ? std::span<const RingEntry>(other->entries)
      : std::span(this->entries).subspan(this->starts[v], this->starts[v + 1] - this->starts[v]);
    if (numbers)
    {
      const EntryNumber* const ofRing =
        isOther ? other->numbers.data() : numbers->ofEntries.data() + this->starts[v];
      ofEntries.insert(ofEntries.end(), ofRing, ofRing + ring.size());
    }
    other += isOther;
    this->starts[v] = static_cast<std::uint32_t>(entries.size());
    entries.insert(entries.end(), ring.begin(), ring.end());
  }
  this->starts.back() = static_cast<std::uint32_t>(entries.size());
  entries.insert(entries.end(), Overrun, RingEntry(0));
  this->entries = std::move(entries);
  if (numbers)
  {
    ofEntries.insert(ofEntries.end(), Overrun, numbers->measurer->ofNoTriangle());
    numbers->ofEntries = std::move(ofEntries);
  }
}

}
