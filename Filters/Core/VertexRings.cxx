#include "VertexRings.h"

#include "FanChainer.h"
#include "TriangleMeasure.h"

#include <algorithm>
#include <array>
#include <bit>
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

VertexSize largest(const VertexSize& a, const VertexSize& b)
{
  // Both of its numbers at once.
  using Both = float __attribute__((vector_size(sizeof(VertexSize))));
  const Both x = std::bit_cast<Both>(a);
  const Both y = std::bit_cast<Both>(b);
  return std::bit_cast<VertexSize>(x > y ? x : y);
}

/** Numbers that follow each other. */
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
  bool has(Index i) const { return i - this->First < this->Size; }

private:
  Index First;
  Index Size;
};

}

/** Some vertices that follow each other, and the triangles that have a corner among them. */
class VertexRings::Range
{
public:
  /** @param triangles in the order of their lowest corners */
  Range(std::size_t first, std::size_t last, std::span<const Triangle> triangles)
    : Vertices(static_cast<Index>(first), static_cast<Index>(last - first))
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
  /** Of both parts in turn: those with a lowest corner before the range, and those with one in it.
   */
  std::array<std::span<const Triangle>, 2> triangles() const
  {
    return { this->ReachIn, this->BeginHere };
  }

private:
  IndexRange Vertices;
  std::vector<Triangle> ReachIn;
  std::span<const Triangle> BeginHere;
};

VertexRings::VertexRings(std::span<const Triangle> triangles, std::span<const Vector3> positions,
  std::span<Index> room, const ThreadTeam& team)
  : Starts(positions.size() + 1)
  , Sizes(positions.size())
{
  const std::size_t vertices = positions.size();
  constexpr std::size_t maximumTriangles = std::numeric_limits<std::uint32_t>::max() / 6;
  if (triangles.size() > maximumTriangles)
  {
    throw std::length_error("The surface has " + std::to_string(triangles.size()) +
      " triangles; one process holds at most " + std::to_string(maximumTriangles) +
      ". Spread it over more ranks.");
  }
  std::vector<std::optional<Range>> ranges(team.numberOfRanges(vertices));
  std::vector<std::size_t> starts(ranges.size());
  team.run(vertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      ranges[range].emplace(first, last, triangles);
      starts[range] = this->countCorners(*ranges[range]);
    });
  // Room for one fan a vertex.
  this->Starts.back() = static_cast<std::uint32_t>(startsOf(starts) + vertices);
  this->Entries.resize(this->Starts.back() + Overrun);
  std::fill(this->Entries.end() - Overrun, this->Entries.end(), RingEntry(0));
  std::vector<std::vector<Ring>> others(ranges.size());
  team.run(vertices,
    [&](std::size_t range, std::size_t first, std::size_t)
    {
      this->fillCorners(*ranges[range], starts[range] + first, positions, room);
      others[range] = this->chainCorners(*ranges[range], starts[range] + first, room);
    });
  for (std::size_t range = 1; range < others.size(); ++range)
  {
    std::move(others[range].begin(), others[range].end(), std::back_inserter(others[0]));
  }
  if (!others[0].empty())
  {
    this->replace(others[0]);
  }
}

std::size_t VertexRings::countCorners(const Range& range)
{
  const IndexRange vertices = range.vertices();
  std::uint32_t* const starts = this->Starts.data();
  std::size_t sum = 0;
  for (const std::span<const Triangle> some : range.triangles())
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
  return sum;
}

void VertexRings::fillCorners(const Range& range, std::size_t start,
  std::span<const Vector3> positions, std::span<Index> seconds)
{
  const IndexRange vertices = range.vertices();
  for (Index v = vertices.first(); v < vertices.last(); ++v)
  {
    start += std::exchange(this->Starts[v], static_cast<std::uint32_t>(start)) + 1;
    this->Sizes[v] = {};
  }
  // At hand, as what is written could be of these arrays' own kind.
  std::uint32_t* const starts = this->Starts.data();
  RingEntry* const entries = this->Entries.data();
  VertexSize* const sizes = this->Sizes.data();
  TriangleMeasurer measures;
  for (const std::span<const Triangle> some : range.triangles())
  {
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      const std::size_t number = i % TriangleMeasurer::Most;
      if (number == 0)
      {
        measures.measure(
          some.subspan(i, std::min(TriangleMeasurer::Most, some.size() - i)), positions);
      }
      const Triangle& t = some[i];
      const TriangleMeasure measure = measures[number];
      const RingEntry opening(0, measure.slack, measure.isThin());
      const VertexSize size{ measure.longestSide, measure.margin };
      for (int c = 0; c < 3; ++c)
      {
        const Index v = t[c];
        if (vertices.has(v))
        {
          // Moves the start of the ring to its end.
          const std::uint32_t place = starts[v]++;
          entries[place] = opening.at(t[(c + 1) % 3]);
          seconds[place - v] = t[(c + 2) % 3];
          sizes[v] = largest(sizes[v], size);
        }
      }
    }
  }
}

std::vector<VertexRings::Ring> VertexRings::chainCorners(
  const Range& range, std::size_t start, std::span<const Index> seconds)
{
  ClosedFanChainer closedFan(static_cast<Index>(this->Starts.size() - 1));
  FanChainer anyFans;
  std::vector<OppositeSide> sides;
  std::vector<RingEntry> fans;
  std::vector<Ring> others;
  const IndexRange vertices = range.vertices();
  for (Index v = vertices.first(); v < vertices.last(); ++v)
  {
    const std::size_t size =
      std::exchange(this->Starts[v], static_cast<std::uint32_t>(start)) - start;
    const std::span<RingEntry> ring{ &this->Entries[start], size + 1 };
    const std::span<const Index> ends = seconds.subspan(start - v, size);
    start += ring.size();
    if (!closedFan.chain(ends, ring))
    {
      sides.clear();
      for (std::size_t i = 0; i < size; ++i)
      {
        sides.push_back({ ring[i], ends[i] });
      }
      fans.clear();
      anyFans.chain(sides, fans);
      if (fans.size() == ring.size())
      {
        std::copy(fans.begin(), fans.end(), ring.begin());
      }
      else
      {
        others.push_back({ v, fans });
      }
    }
  }
  return others;
}

void VertexRings::replace(std::span<const Ring> others)
{
  BulkVector<RingEntry> entries;
  entries.reserve(this->Entries.size());
  auto other = others.begin();
  for (Index v = 0; v + 1 < this->Starts.size(); ++v)
  {
    const bool isOther = other != others.end() && other->vertex == v;
    const std::span<const RingEntry> ring = isOther ? (other++)->entries : (*this)[v];
    this->Starts[v] = static_cast<std::uint32_t>(entries.size());
    entries.insert(entries.end(), ring.begin(), ring.end());
  }
  this->Starts.back() = static_cast<std::uint32_t>(entries.size());
  entries.insert(entries.end(), Overrun, RingEntry(0));
  this->Entries = std::move(entries);
}

}
