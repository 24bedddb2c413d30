#include "VertexRings.h"

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

OppositeSide oppositeSide(const Triangle& t, std::uint32_t corner, const TriangleMeasure& measure)
{
  constexpr std::array<std::uint8_t, 3> next{ 1, 2, 0 };
  constexpr std::array<std::uint8_t, 3> afterNext{ 2, 0, 1 };
  return { { t[next[corner]], measure.slack, measure.isThin() }, t[afterNext[corner]] };
}

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
   * Where all sides follow each other, first end to second end, as one fan that closes, writes it
   * to @p fan, which has one entry more than there are sides; returns false elsewhere.
   */
  bool chain(std::span<const OppositeSide> sides, std::span<RingEntry> fan)
  {
    if (sides.size() > std::numeric_limits<Place>::max())
    {
      return false;
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      this->PlaceOf[sides[i].first()] = static_cast<Place>(i);
    }
    // Looked up before they are followed: then no look-up waits for the one before.
    bool hasNext = true;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      // The place of a vertex where no side begins is one from another ring.
      const Place next = this->PlaceOf[sides[i].second];
      hasNext &= next < sides.size() && sides[next].first() == sides[i].second;
      this->NextOf[i] = next;
    }
    if (!hasNext)
    {
      return false;
    }
    std::size_t place = 0;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      fan[i] = sides[place].opening;
      place = this->NextOf[place];
      if (place == 0)
      {
        fan[i + 1] = RingEntry(sides[0].first());
        return i + 1 == sides.size();
      }
    }
    return false;
  }

private:
  using Place = std::uint8_t;
  std::vector<Place> PlaceOf;
  std::array<Place, std::numeric_limits<Place>::max()> NextOf;
};

/** Calls visit(v, t, c) for each corner c of a triangle t whose vertex v is in a range. */
template <class Visit>
void visitCorners(Index first, Index last, std::span<const Triangle> triangles, const Visit& visit)
{
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      const Index v = triangles[t][c];
      if (v >= first && v < last)
      {
        visit(v, t, c);
      }
    }
  }
}

}

VertexRings::VertexRings(Index numberOfVertices, std::span<const Triangle> triangles,
  std::span<const TriangleMeasure> measures, const ThreadTeam& team)
  : Starts(std::size_t{ numberOfVertices } + 1)
  , LongestSides(numberOfVertices)
  , Margins(numberOfVertices)
{
  constexpr std::size_t maximumTriangles = std::numeric_limits<std::uint32_t>::max() / 6;
  if (triangles.size() > maximumTriangles)
  {
    throw std::length_error("The surface has " + std::to_string(triangles.size()) +
      " triangles; one process holds at most " + std::to_string(maximumTriangles) +
      ". Spread it over more ranks.");
  }
  std::vector<std::size_t> starts(team.numberOfRanges(numberOfVertices));
  team.run(numberOfVertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      visitCorners(static_cast<Index>(first), static_cast<Index>(last), triangles,
        [&](Index v, std::uint32_t, std::uint32_t) { ++this->Starts[v]; });
      starts[range] = std::accumulate(&this->Starts[first], &this->Starts[last], std::size_t{ 0 });
    });
  // Room for one fan a vertex.
  this->Starts.back() = static_cast<std::uint32_t>(startsOf(starts) + numberOfVertices);
  this->Entries.resize(std::size_t{ this->Starts.back() } + 1);
  this->Entries.back() = RingEntry(0);
  std::vector<std::vector<Ring>> others(starts.size());
  team.run(numberOfVertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      std::size_t start = starts[range] + first;
      for (std::size_t v = first; v < last; ++v)
      {
        const std::uint32_t count = this->Starts[v];
        this->Starts[v] = static_cast<std::uint32_t>(start);
        start += count + 1;
      }
      // At first a ring names the corners at its vertex: triangles, and in the bits of slack which
      // corner. Filling moves its start to its end.
      visitCorners(static_cast<Index>(first), static_cast<Index>(last), triangles,
        [&](Index v, std::uint32_t t, std::uint32_t c)
        { this->Entries[this->Starts[v]++] = RingEntry(t, std::bit_cast<float>(c), false); });
      ClosedFanChainer closedFan(numberOfVertices);
      FanChainer anyFans;
      BulkVector<OppositeSide> sides;
      std::vector<RingEntry> fans;
      start = starts[range] + first;
      for (std::size_t v = first; v < last; ++v)
      {
        const std::size_t end = this->Starts[v];
        this->Starts[v] = static_cast<std::uint32_t>(start);
        sides.resize(end - start);
        float longest = 0.0f;
        float margin = 0.0f;
        for (OppositeSide& side : sides)
        {
          const RingEntry corner = this->Entries[start++];
          const std::uint32_t t = corner.neighbour();
          const TriangleMeasure& measure = measures[t];
          side = oppositeSide(triangles[t], std::bit_cast<std::uint32_t>(corner.slack()), measure);
          longest = std::max(longest, measure.longestSide);
          margin = std::max(margin, measure.margin);
        }
        ++start;
        this->LongestSides[v] = longest;
        this->Margins[v] = margin;
        const std::span<RingEntry> ring{ &this->Entries[this->Starts[v]], sides.size() + 1 };
        if (!closedFan.chain(sides, ring))
        {
          fans.clear();
          anyFans.chain(sides, fans);
          if (fans.size() == ring.size())
          {
            std::copy(fans.begin(), fans.end(), ring.begin());
          }
          else
          {
            others[range].push_back({ static_cast<Index>(v), fans });
          }
        }
      }
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
  entries.push_back(RingEntry(0));
  this->Entries = std::move(entries);
}

}
