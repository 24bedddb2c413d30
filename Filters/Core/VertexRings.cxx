#include "VertexRings.h"

#include "TriangleMeasure.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic
{
namespace
{

/** The side of a triangle that faces the vertex whose ring is built. */
struct OppositeSide
{
  /** That of the side's first end, where it opens the triangle. */
  RingEntry opening;
  Index second;

  Index first() const { return this->opening.neighbour(); }
};

/** Chains the sides opposite to one vertex into fans; reused from vertex to vertex. */
class FanChainer
{
public:
  /** Appends the fans made of @p sides to @p entries; @p sides is used up. */
  void chain(std::span<OppositeSide> sides, std::vector<RingEntry>& entries)
  {
    this->Sides = sides;
    this->Left = sides.size();
    if (this->isIndexed())
    {
      this->indexSides();
    }
    this->Fan.resize(2 * sides.size() + 2);
    while (this->Left > 0)
    {
      // The fan grows from the middle, to its end and then, unless it closed, to its front.
      std::size_t front = sides.size();
      std::size_t back = front + 1;
      const OppositeSide side = this->takeAny();
      this->Fan[front] = side.opening;
      this->Fan[back] = RingEntry(side.second);
      bool isClosed = false;
      while (!isClosed)
      {
        const Index end = this->Fan[back].neighbour();
        const std::size_t place = this->find(end);
        if (place == None)
        {
          break;
        }
        const OppositeSide next = this->take(place);
        const Index other = otherEnd(next, end);
        this->Fan[back] = next.opening.at(end);
        this->Fan[++back] = RingEntry(other);
        isClosed = other == this->Fan[front].neighbour();
      }
      while (!isClosed)
      {
        const Index end = this->Fan[front].neighbour();
        const std::size_t place = this->find(end);
        if (place == None)
        {
          break;
        }
        const OppositeSide next = this->take(place);
        this->Fan[--front] = next.opening.at(otherEnd(next, end));
        isClosed = this->Fan[front].neighbour() == this->Fan[back].neighbour();
      }
      entries.insert(entries.end(), this->Fan.begin() + front, this->Fan.begin() + back + 1);
    }
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  using Mask = std::uint32_t;
  /** Above this many triangles round a vertex a linear look-up would be quadratic. */
  static constexpr std::size_t LinearLimit = 32;

  bool isIndexed() const { return this->Sides.size() > LinearLimit; }

  static Index otherEnd(const OppositeSide& side, Index end)
  {
    return side.first() ^ side.second ^ end;
  }

  void indexSides()
  {
    this->Ends.clear();
    this->Taken.assign(this->Sides.size(), 0);
    this->NextStart = 0;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      this->Ends.emplace_back(this->Sides[i].first(), i);
      this->Ends.emplace_back(this->Sides[i].second, i);
    }
    std::sort(this->Ends.begin(), this->Ends.end());
    this->Cursors.resize(this->Ends.size());
    for (std::size_t i = 0; i < this->Ends.size(); ++i)
    {
      this->Cursors[i] = i;
    }
  }

  OppositeSide takeAny()
  {
    if (!this->isIndexed())
    {
      return this->take(0);
    }
    while (this->Taken[this->NextStart])
    {
      ++this->NextStart;
    }
    return this->take(this->NextStart);
  }

  /** Takes the side at a place; the places of others may change. */
  OppositeSide take(std::size_t place)
  {
    --this->Left;
    if (this->isIndexed())
    {
      this->Taken[place] = 1;
      return this->Sides[place];
    }
    return std::exchange(this->Sides[place], this->Sides[this->Left]);
  }

  /** The place of a side left that ends in @p vertex, None if there is none. */
  std::size_t find(Index vertex)
  {
    return this->isIndexed() ? this->findIndexed(vertex) : this->findLinear(vertex);
  }

  std::size_t findLinear(Index vertex) const
  {
    // No branch on what is found: which side follows is not to be guessed.
    Mask found = 0;
    for (std::size_t i = 0; i < this->Left; ++i)
    {
      const OppositeSide& side = this->Sides[i];
      found |= static_cast<Mask>((side.first() == vertex) | (side.second == vertex)) << i;
    }
    return found == 0 ? None : std::countr_zero(found);
  }

  std::size_t findIndexed(Index vertex)
  {
    const auto first = std::lower_bound(
      this->Ends.begin(), this->Ends.end(), std::pair<Index, std::size_t>{ vertex, 0 });
    if (first == this->Ends.end() || first->first != vertex)
    {
      return None;
    }
    // The first end of a run remembers how far its run is used up.
    std::size_t& cursor = this->Cursors[first - this->Ends.begin()];
    for (; cursor < this->Ends.size() && this->Ends[cursor].first == vertex; ++cursor)
    {
      const std::size_t side = this->Ends[cursor].second;
      if (!this->Taken[side])
      {
        return side;
      }
    }
    return None;
  }

  std::span<OppositeSide> Sides;
  std::size_t Left = 0;
  std::vector<RingEntry> Fan;
  std::vector<std::pair<Index, std::size_t>> Ends;
  std::vector<std::size_t> Cursors;
  std::vector<std::uint8_t> Taken;
  std::size_t NextStart = 0;
};

/** Chains the sides opposite to a vertex where that is easy, as it is at most vertices. */
class ClosedFanChainer
{
public:
  explicit ClosedFanChainer(Index numberOfVertices)
    : PlaceOf(numberOfVertices)
  {
  }

  /**
   * Where all sides follow each other, first end to second end, as one fan that closes, brings them
   * into that order; leaves them as they are and returns false elsewhere.
   * @param seconds  the other ends of the sides
   * @param fan      what opens them, and room for one entry more
   */
  bool chain(std::span<const Index> seconds, std::span<RingEntry> fan)
  {
    const std::size_t size = seconds.size();
    if (size == 0 || size > std::numeric_limits<Place>::max())
    {
      return false;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const RingEntry side = fan[i];
      this->Sides[i] = side;
      this->PlaceOf[side.neighbour()] = static_cast<Place>(i);
    }
    std::size_t place = 0;
    std::size_t chained = 0;
    bool isFound = false;
    do
    {
      fan[chained++] = this->Sides[place];
      const Index end = seconds[place];
      place = this->PlaceOf[end];
      // The place of a vertex where no side begins is one from another ring.
      isFound = place < size && this->Sides[place].neighbour() == end;
    } while (isFound && place != 0 && chained < size);
    const bool isWhole = isFound && place == 0 && chained == size;
    if (isWhole)
    {
      fan[size] = RingEntry(this->Sides[0].neighbour());
    }
    else
    {
      std::copy_n(this->Sides.begin(), chained, fan.begin());
    }
    return isWhole;
  }

private:
  using Place = std::uint8_t;
  std::vector<Place> PlaceOf;
  std::array<RingEntry, std::numeric_limits<Place>::max()> Sides;
};

VertexSize largest(const VertexSize& a, const VertexSize& b)
{
  // Both of its numbers at once.
  using Both = float __attribute__((vector_size(sizeof(VertexSize))));
  const Both x = std::bit_cast<Both>(a);
  const Both y = std::bit_cast<Both>(b);
  return std::bit_cast<VertexSize>(x > y ? x : y);
}

/** Tells the numbers from a first to before a last one. */
class IndexRange
{
public:
  IndexRange(std::size_t first, std::size_t last)
    : First(static_cast<Index>(first))
    , Size(static_cast<Index>(last - first))
  {
  }
  bool has(Index i) const { return i - this->First < this->Size; }

private:
  Index First;
  Index Size;
};

}

VertexRings::VertexRings(std::vector<std::uint32_t> corners, std::span<const Triangle> triangles,
  std::span<const Vector3> positions, std::span<Index> room, const ThreadTeam& team)
  : Starts(std::move(corners))
  , Sizes(positions.size())
{
  const std::size_t numberOfVertices = positions.size();
  constexpr std::size_t maximumTriangles = std::numeric_limits<std::uint32_t>::max() / 6;
  if (triangles.size() > maximumTriangles)
  {
    throw std::length_error("The surface has " + std::to_string(triangles.size()) +
      " triangles; one process holds at most " + std::to_string(maximumTriangles) +
      ". Spread it over more ranks.");
  }
  std::vector<std::size_t> starts(team.numberOfRanges(numberOfVertices));
  team.run(numberOfVertices,
    [&](std::size_t range, std::size_t first, std::size_t last) {
      starts[range] = std::accumulate(&this->Starts[first], &this->Starts[last], std::size_t{ 0 });
    });
  // Room for one fan a vertex.
  this->Starts.back() = static_cast<std::uint32_t>(startsOf(starts) + numberOfVertices);
  this->Entries.resize(this->Starts.back() + Overrun);
  std::fill(this->Entries.end() - Overrun, this->Entries.end(), RingEntry(0));
  std::vector<std::vector<Ring>> others(starts.size());
  team.run(numberOfVertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      this->fillCorners(first, last, starts[range] + first, triangles, positions, room);
      others[range] = this->chainCorners(first, last, starts[range] + first, room);
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

void VertexRings::fillCorners(std::size_t first, std::size_t last, std::size_t start,
  std::span<const Triangle> triangles, std::span<const Vector3> positions, std::span<Index> seconds)
{
  for (std::size_t v = first; v < last; ++v)
  {
    start += std::exchange(this->Starts[v], static_cast<std::uint32_t>(start)) + 1;
    this->Sizes[v] = {};
  }
  const IndexRange range(first, last);
  TriangleMeasurer measures;
  const auto fill = [&, starts = this->Starts.data(), entries = this->Entries.data(),
                      sizes = this->Sizes.data()](std::span<const Triangle> some)
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
        if (range.has(v))
        {
          // Moves the start of the ring to its end.
          const std::uint32_t place = starts[v]++;
          entries[place] = opening.at(t[(c + 1) % 3]);
          seconds[place - v] = t[(c + 2) % 3];
          sizes[v] = largest(sizes[v], size);
        }
      }
    }
  };
  const auto firstFrom = [&](std::size_t vertex)
  {
    return std::partition_point(triangles.begin(), triangles.end(),
      [&](const Triangle& t) { return lowestCorner(t) < vertex; });
  };
  const auto own = firstFrom(first);
  // Of the triangles before its own some reach into the range.
  std::vector<Triangle> others;
  std::copy_if(triangles.begin(), own, std::back_inserter(others),
    [&](const Triangle& t) { return range.has(t[0]) || range.has(t[1]) || range.has(t[2]); });
  fill(others);
  fill({ own, firstFrom(last) });
}

std::vector<VertexRings::Ring> VertexRings::chainCorners(
  std::size_t first, std::size_t last, std::size_t start, std::span<const Index> seconds)
{
  ClosedFanChainer closedFan(static_cast<Index>(this->Starts.size() - 1));
  FanChainer anyFans;
  std::vector<OppositeSide> sides;
  std::vector<RingEntry> fans;
  std::vector<Ring> others;
  for (std::size_t v = first; v < last; ++v)
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
        others.push_back({ static_cast<Index>(v), fans });
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
