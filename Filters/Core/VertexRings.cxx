#include "VertexRings.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
};

float slackOf(const Vector3& v, const Vector3& p, const Vector3& q)
{
  const double area = norm(cross(p - v, q - v));
  const auto over = [area](double c) { return c > 0.0 ? 2.0 * area / c - c : 0.0; };
  const double slack = std::min(over(norm(p - v)), over(norm(q - v)));
  const float rounded = static_cast<float>(slack);
  return rounded > slack ? std::nextafter(rounded, -std::numeric_limits<float>::infinity())
                         : rounded;
}

/** Chains the sides opposite to one vertex into fans; reused from vertex to vertex. */
class FanChainer
{
public:
  /** Appends the fans made of @p sides to @p entries; @p sides is used up. */
  void chain(std::span<OppositeSide> sides, std::vector<RingEntry>& entries,
    std::span<const Vector3> positions, Index v)
  {
    this->Sides = sides;
    this->Left = sides.size();
    this->indexSides();
    while (this->Left > 0)
    {
      const OppositeSide start = this->takeAny();
      this->Forward.assign({ start.first, start.second });
      this->extend(this->Forward);
      this->Backward.clear();
      if (this->Forward.front() != this->Forward.back())
      {
        this->Backward.push_back(start.first);
        this->extend(this->Backward);
        std::reverse(this->Backward.begin(), this->Backward.end());
        this->Backward.pop_back();
      }
      this->Backward.insert(this->Backward.end(), this->Forward.begin(), this->Forward.end());
      for (std::size_t i = 0; i < this->Backward.size(); ++i)
      {
        const bool opens = i + 1 < this->Backward.size();
        entries.emplace_back(this->Backward[i], opens,
          opens
            ? slackOf(positions[v], positions[this->Backward[i]], positions[this->Backward[i + 1]])
            : 0.0f);
      }
    }
  }

private:
  /** Above this many triangles round a vertex a linear look-up would be quadratic. */
  static constexpr std::size_t LinearLimit = 48;

  bool isIndexed() const { return this->Sides.size() > LinearLimit; }

  void indexSides()
  {
    if (!this->isIndexed())
    {
      return;
    }
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
      return this->Sides[--this->Left];
    }
    while (this->Taken[this->NextStart])
    {
      ++this->NextStart;
    }
    this->Taken[this->NextStart] = 1;
    --this->Left;
    return this->Sides[this->NextStart];
  }

  /** Takes a side that ends in @p vertex and returns its other end, or NoIndex if there is none. */
  Index takeAt(Index vertex)
  {
    return this->isIndexed() ? this->takeIndexed(vertex) : this->takeLinear(vertex);
  }

  Index takeLinear(Index vertex)
  {
    for (std::size_t i = 0; i < this->Left; ++i)
    {
      const OppositeSide side = this->Sides[i];
      if (side.first == vertex || side.second == vertex)
      {
        this->Sides[i] = this->Sides[--this->Left];
        return side.first == vertex ? side.second : side.first;
      }
    }
    return NoIndex;
  }

  Index takeIndexed(Index vertex)
  {
    const auto first = std::lower_bound(
      this->Ends.begin(), this->Ends.end(), std::pair<Index, std::size_t>{ vertex, 0 });
    if (first == this->Ends.end() || first->first != vertex)
    {
      return NoIndex;
    }
    // The first end of a run remembers how far its run is used up.
    std::size_t& cursor = this->Cursors[first - this->Ends.begin()];
    for (; cursor < this->Ends.size() && this->Ends[cursor].first == vertex; ++cursor)
    {
      const std::size_t i = this->Ends[cursor].second;
      if (!this->Taken[i])
      {
        this->Taken[i] = 1;
        --this->Left;
        return this->Sides[i].first == vertex ? this->Sides[i].second : this->Sides[i].first;
      }
    }
    return NoIndex;
  }

  void extend(std::vector<Index>& fan)
  {
    for (Index next = this->takeAt(fan.back()); next != NoIndex; next = this->takeAt(fan.back()))
    {
      fan.push_back(next);
      if (next == fan.front())
      {
        return;
      }
    }
  }

  std::span<OppositeSide> Sides;
  std::size_t Left = 0;
  std::vector<Index> Forward;
  std::vector<Index> Backward;
  std::vector<std::pair<Index, std::size_t>> Ends;
  std::vector<std::size_t> Cursors;
  std::vector<std::uint8_t> Taken;
  std::size_t NextStart = 0;
};

}

VertexRings::VertexRings(std::span<const Vector3> positions, std::span<const Triangle> triangles)
{
  const Index numberOfVertices = static_cast<Index>(positions.size());
  constexpr std::size_t maximumTriangles = std::numeric_limits<std::uint32_t>::max() / 6;
  if (triangles.size() > maximumTriangles)
  {
    throw std::length_error("The surface has " + std::to_string(triangles.size()) +
      " triangles; one process holds at most " + std::to_string(maximumTriangles) +
      ". Spread it over more ranks.");
  }
  std::vector<std::uint32_t> sideStarts(std::size_t{ numberOfVertices } + 1, 0);
  for (const Triangle& t : triangles)
  {
    for (Index corner : t)
    {
      ++sideStarts[corner + 1];
    }
  }
  for (Index v = 0; v < numberOfVertices; ++v)
  {
    sideStarts[v + 1] += sideStarts[v];
  }
  std::vector<OppositeSide> sides(3 * triangles.size());
  for (const Triangle& t : triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      sides[sideStarts[t[c]]++] = { t[(c + 1) % 3], t[(c + 2) % 3] };
    }
  }
  // Filling moved each start to the next vertex's, so vertex v's sides begin where v - 1's ended.
  this->Starts.resize(std::size_t{ numberOfVertices } + 1);
  this->Entries.reserve(sides.size() + numberOfVertices + numberOfVertices / 16);
  FanChainer chainer;
  std::uint32_t first = 0;
  for (Index v = 0; v < numberOfVertices; ++v)
  {
    this->Starts[v] = static_cast<std::uint32_t>(this->Entries.size());
    chainer.chain(
      { sides.data() + first, sides.data() + sideStarts[v] }, this->Entries, positions, v);
    first = sideStarts[v];
  }
  this->Starts[numberOfVertices] = static_cast<std::uint32_t>(this->Entries.size());
}

}
