#include "VertexRings.h"

#include <algorithm>
#include <bit>
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
  Index first;
  Index second;
  float slack;
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
      this->Fan[front] = RingEntry(side.first, true, side.slack);
      this->Fan[back] = RingEntry(side.second, false);
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
        this->Fan[back] = RingEntry(end, true, next.slack);
        this->Fan[++back] = RingEntry(other, false);
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
        this->Fan[--front] = RingEntry(otherEnd(next, end), true, next.slack);
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
    return side.first ^ side.second ^ end;
  }

  void indexSides()
  {
    this->Ends.clear();
    this->Taken.assign(this->Sides.size(), 0);
    this->NextStart = 0;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      this->Ends.emplace_back(this->Sides[i].first, i);
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
      found |= static_cast<Mask>((side.first == vertex) | (side.second == vertex)) << i;
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

/** The rings of a range of vertices, by themselves. */
struct RingsOfRange
{
  std::vector<RingEntry> entries;
  /** Where the rings end among them. */
  std::vector<std::uint32_t> ends;
  std::vector<float> longestSides;
};

RingsOfRange ringsOfRange(Index first, Index last, std::span<const Triangle> triangles,
  std::span<const TriangleMeasure> measures)
{
  const auto visitCorners = [&](auto&& visit)
  {
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        if (triangles[t][c] >= first && triangles[t][c] < last)
        {
          visit(triangles[t][c] - first, t, c);
        }
      }
    }
  };
  std::vector<std::uint32_t> places(last - first, 0);
  visitCorners([&](Index v, std::size_t, int) { ++places[v]; });
  const std::size_t corners = std::accumulate(places.begin(), places.end(), std::size_t{ 0 });
  std::exclusive_scan(places.begin(), places.end(), places.begin(), 0u);
  std::vector<std::uint32_t> numbers(corners);
  visitCorners([&](Index v, std::size_t t, int c)
    { numbers[places[v]++] = static_cast<std::uint32_t>(3 * t + c); });
  // Filling moved each place to the next vertex's, so vertex v's corners begin where v - 1's ended.
  RingsOfRange rings;
  rings.entries.reserve(corners + corners / 6 + corners / 64);
  rings.ends.reserve(last - first);
  rings.longestSides.reserve(last - first);
  FanChainer chainer;
  std::vector<OppositeSide> sides;
  std::uint32_t begin = 0;
  for (std::uint32_t end : places)
  {
    sides.clear();
    float longest = 0.0f;
    for (std::uint32_t i = begin; i < end; ++i)
    {
      const std::uint32_t t = numbers[i] / 3;
      const std::uint32_t c = numbers[i] % 3;
      sides.push_back(
        { triangles[t][(c + 1) % 3], triangles[t][(c + 2) % 3], measures[t].slacks[c] });
      longest = std::max(longest, measures[t].longestSide);
    }
    chainer.chain(sides, rings.entries);
    rings.longestSides.push_back(longest);
    rings.ends.push_back(static_cast<std::uint32_t>(rings.entries.size()));
    begin = end;
  }
  return rings;
}

}

VertexRings::VertexRings(Index numberOfVertices, std::span<const Triangle> triangles,
  std::span<const TriangleMeasure> measures, const ThreadTeam& team)
{
  constexpr std::size_t maximumTriangles = std::numeric_limits<std::uint32_t>::max() / 6;
  if (triangles.size() > maximumTriangles)
  {
    throw std::length_error("The surface has " + std::to_string(triangles.size()) +
      " triangles; one process holds at most " + std::to_string(maximumTriangles) +
      ". Spread it over more ranks.");
  }
  std::vector<RingsOfRange> parts(team.numberOfRanges(numberOfVertices));
  team.run(numberOfVertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      parts[range] =
        ringsOfRange(static_cast<Index>(first), static_cast<Index>(last), triangles, measures);
    });

  std::vector<std::size_t> starts;
  starts.reserve(parts.size());
  for (const RingsOfRange& part : parts)
  {
    starts.push_back(part.entries.size());
  }
  const std::size_t total = startsOf(starts);
  this->Starts.resize(std::size_t{ numberOfVertices } + 1, 0);
  this->LongestSides.resize(numberOfVertices);
  if (parts.size() == 1)
  {
    this->Entries = std::move(parts[0].entries);
  }
  this->Entries.resize(total);
  team.run(numberOfVertices,
    [&](std::size_t range, std::size_t first, std::size_t)
    {
      RingsOfRange& part = parts[range];
      std::transform(part.ends.begin(), part.ends.end(), this->Starts.begin() + first + 1,
        [&](std::uint32_t end) { return static_cast<std::uint32_t>(starts[range] + end); });
      std::copy(
        part.longestSides.begin(), part.longestSides.end(), this->LongestSides.begin() + first);
      std::copy(part.entries.begin(), part.entries.end(), this->Entries.begin() + starts[range]);
      part = RingsOfRange();
    });
}

}
