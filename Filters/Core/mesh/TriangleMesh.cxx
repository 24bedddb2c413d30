// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/TriangleMesh.h"

#include "base/Mean.h"
#include "base/Platform.h"
#include "mesh/MotionTable.h"
#include "mesh/SpatialOrder.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

void checkNumbers(std::size_t points, std::size_t triangles)
{
  VertexRings::checkNumber(triangles);
  // A march's queue numbers its other items, secondary values, from the number of vertices on.
  constexpr std::size_t most = 0x3fffffff;
  if (points > most)
  {
    throw std::length_error("The surface has " + std::to_string(points) +
      " points; one process holds at most " + std::to_string(most) +
      ". Spread it over more ranks.");
  }
}

/** Flags the points that triangles use, after checking that these exist. */
std::vector<std::uint8_t> usedPoints(
  std::size_t count, std::span<const Triangle> triangles, const ThreadTeam& team)
{
  std::vector<std::uint8_t> used(count, 0);
  team.run(triangles.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const auto use = [flags = used.data()](Index point)
      { std::atomic_ref(flags[point]).store(1, std::memory_order_relaxed); };
      for (const Triangle& t : triangles.subspan(first, last - first))
      {
        const auto [a, b, c] = t;
        if (highestCorner(t) >= count)
        {
          throw std::invalid_argument("Triangle " + std::to_string(&t - triangles.data()) +
            " uses point " + std::to_string(highestCorner(t)) + ", but the surface has " +
            std::to_string(count) + " points. Clean the surface.");
        }
        use(a);
        use(b);
        use(c);
      }
    });
  return used;
}

bool repeatsCorner(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}

TriangleMesh::TriangleMesh(std::span<const Vector3> points, std::span<const Triangle> triangles,
  CoincidentPoints coincident, const ThreadTeam& team, const RingMeasurer* measurer)
{
  checkNumbers(points.size(), triangles.size());
  const std::vector<std::uint8_t> used = usedPoints(points.size(), triangles, team);
  this->build(numbered(points, used, coincident, team), triangles, team, measurer);
}

TriangleMesh::TriangleMesh(std::span<const Vector3> points, std::span<const Triangle> triangles,
  std::span<const Index> kinds, const ThreadTeam& team, const RingMeasurer* measurer)
{
  checkNumbers(points.size(), triangles.size());
  const std::vector<std::uint8_t> used = usedPoints(points.size(), triangles, team);
  std::vector<std::uint8_t> isFirst(points.size(), 0);
  std::vector<Index> firstOfKind(points.size(), NoIndex);
  for (Index i = 0; i < points.size(); ++i)
  {
    if (used[i])
    {
      checkFinite(i, points[i]);
      if (firstOfKind[kinds[i]] == NoIndex)
      {
        firstOfKind[kinds[i]] = i;
        isFirst[i] = 1;
      }
    }
  }
  Numbering numbering = numbered(points, isFirst, CoincidentPoints::Separate, team);
  for (Index i = 0; i < points.size(); ++i)
  {
    if (used[i])
    {
      numbering.vertexOfPoint[i] = numbering.vertexOfPoint[firstOfKind[kinds[i]]];
    }
  }
  this->build(std::move(numbering), triangles, team, measurer);
}

TriangleMesh TriangleMesh::without(const std::vector<bool>& leftOut, const ThreadTeam& team) const
{
  TriangleMesh mesh;
  mesh.Positions = this->Positions;
  mesh.VertexOfPoint = this->VertexOfPoint;
  mesh.PointOfVertex = this->PointOfVertex;
  mesh.BarePoints = this->BarePoints;
  OrderedTriangles kept;
  kept.triangles.reserve(this->numberOfTriangles());
  kept.sources.reserve(this->numberOfTriangles());
  for (Index t = 0; t < this->numberOfTriangles(); ++t)
  {
    if (!leftOut[t])
    {
      kept.triangles.push_back(this->Triangles[t]);
      kept.sources.push_back(this->SourceOfTriangle[t]);
    }
  }
  mesh.Triangles = SharedVector(std::move(kept.triangles));
  mesh.SourceOfTriangle = SharedVector(std::move(kept.sources));
  mesh.NumberOfSources = this->NumberOfSources;
  mesh.Motion = std::make_shared<LazyMotionTable>();
  BulkVector<Index> room(VertexRings::RoomOfTriangle * mesh.Triangles.size());
  mesh.makeRings(room, team, this->measurer());
  return mesh;
}

void TriangleMesh::build(Numbering numbering, std::span<const Triangle> triangles,
  const ThreadTeam& team, const RingMeasurer* measurer)
{
  this->Positions = std::move(numbering.positions);
  this->PointOfVertex = SharedVector(std::move(numbering.pointOfVertex));
  this->NumberOfSources = triangles.size();
  this->Motion = std::make_shared<LazyMotionTable>();
  // The first access to memory is the most expensive one, so two steps share this workspace.
  BulkVector<Index> room(VertexRings::RoomOfTriangle * triangles.size());
  this->orderTriangles(numbering.vertexOfPoint, triangles, room, team);
  this->makeRings(room, team, measurer);
  if (this->Triangles.size() < triangles.size())
  {
    this->forgetBareVertices(numbering.vertexOfPoint);
  }
  this->VertexOfPoint = SharedVector(std::move(numbering.vertexOfPoint));
}

void TriangleMesh::makeRings(
  std::span<Index> room, const ThreadTeam& team, const RingMeasurer* measurer)
{
  const auto numbers = measurer ? std::make_shared<RingNumbers>() : nullptr;
  if (numbers)
  {
    numbers->measurer = measurer;
  }
  this->Rings = VertexRings(this->Triangles, this->Positions, room, team, numbers.get());
  this->Numbers = numbers;
  this->measureEdges();
}

TriangleMesh::Numbering TriangleMesh::numbered(std::span<const Vector3> points,
  std::span<const std::uint8_t> used, CoincidentPoints coincident, const ThreadTeam& team)
{
  const BulkVector<Index> order = spatialOrder(points, used, team);
  const bool areSeparate = coincident == CoincidentPoints::Separate;
  const auto isFirstOfItsKind = [&](std::size_t i)
  { return areSeparate || i == 0 || !(points[order[i]] == points[order[i - 1]]); };
  std::vector<std::size_t> starts(team.numberOfRanges(order.size()));
  team.run(order.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      std::size_t count = areSeparate ? last - first : 0;
      for (std::size_t i = first; i < last && !areSeparate; ++i)
      {
        count += isFirstOfItsKind(i);
      }
      starts[range] = count;
    });
  const std::size_t vertices = startsOf(starts);
  Numbering numbering;
  numbering.vertexOfPoint.assign(points.size(), NoIndex);
  numbering.positions.resize(vertices);
  numbering.pointOfVertex.resize(vertices);
  team.run(order.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      std::size_t next = starts[range];
      for (std::size_t i = first; i < last; ++i)
      {
        if (isFirstOfItsKind(i))
        {
          numbering.positions[next] = points[order[i]];
          numbering.pointOfVertex[next] = order[i];
          ++next;
        }
        numbering.vertexOfPoint[order[i]] = static_cast<Index>(next - 1);
      }
    });
  return numbering;
}

void TriangleMesh::orderTriangles(std::span<const Index> vertexOfPoint,
  std::span<const Triangle> triangles, std::span<Index> corners, const ThreadTeam& team)
{
  // A counting sort: each thread counts and places a range of the triangles. Of equal lowest
  // corners, a thread's triangles go before those of the next thread. Counts take 4 bytes for each
  // vertex and thread, so at most 8 threads work.
  const ThreadTeam counters = team.atMost(8);
  const std::size_t vertices = this->numberOfVertices();
  std::vector<std::vector<Index>> places(counters.numberOfRanges(triangles.size()));
  counters.run(triangles.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      places[range].resize(vertices);
      Index* const counts = places[range].data();
      const Index* const vertexOf = vertexOfPoint.data();
      Index* to = corners.data() + 3 * first;
      for (const Triangle& input : triangles.subspan(first, last - first))
      {
        const Index a = vertexOf[input[0]];
        const Index b = vertexOf[input[1]];
        const Index c = vertexOf[input[2]];
        to[0] = a;
        to[1] = b;
        to[2] = c;
        if (repeatsCorner({ a, b, c }))
        {
          to[0] = NoIndex;
        }
        else
        {
          ++counts[lowestCorner({ a, b, c })];
        }
        to += 3;
      }
    });
  std::vector<std::size_t> starts(team.numberOfRanges(vertices));
  team.run(vertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      for (const std::vector<Index>& counts : places)
      {
        starts[range] =
          std::accumulate(counts.begin() + first, counts.begin() + last, starts[range]);
      }
    });
  const std::size_t total = startsOf(starts);
  OrderedTriangles all;
  all.triangles.resize(total);
  all.sources.resize(total);
  std::vector<std::vector<TriangleRange>> toSort(starts.size());
  team.run(vertices,
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      Index next = static_cast<Index>(starts[range]);
      for (std::size_t v = first; v < last; ++v)
      {
        const Index begin = next;
        for (std::vector<Index>& counts : places)
        {
          next += std::exchange(counts[v], next);
        }
        if (next - begin > MostUnsorted)
        {
          toSort[range].push_back({ begin, next });
        }
      }
    });
  counters.run(triangles.size(),
    [&](std::size_t range, std::size_t first, std::size_t last)
    {
      Index* const next = places[range].data();
      Triangle* const ordered = all.triangles.data();
      Index* const sources = all.sources.data();
      const auto cornersOf = [from = corners.data()](std::size_t t) -> Triangle {
        return { from[3 * t], from[3 * t + 1], from[3 * t + 2] };
      };
      // A triangle's place may be anywhere in memory, so it is prefetched 24 triangles ahead.
      constexpr std::size_t ahead = 24;
      std::array<Index, 32> placeOf;
      const auto put = [&](std::size_t t)
      {
        if (const Index place = placeOf[t % placeOf.size()]; place != NoIndex)
        {
          ordered[place] = cornersOf(t);
          sources[place] = static_cast<Index>(t);
        }
      };
      for (std::size_t t = first; t < last; ++t)
      {
        const Triangle ours = cornersOf(t);
        Index place = NoIndex;
        if (ours[0] != NoIndex)
        {
          place = next[lowestCorner(ours)]++;
          prefetchToWrite(&ordered[place]);
          prefetchToWrite(&sources[place]);
        }
        placeOf[t % placeOf.size()] = place;
        if (t >= first + ahead)
        {
          put(t - ahead);
        }
      }
      for (std::size_t t = std::max(first + ahead, last) - ahead; t < last; ++t)
      {
        put(t);
      }
    });
  for (const std::vector<TriangleRange>& ranges : toSort)
  {
    std::for_each(
      ranges.begin(), ranges.end(), [&](const TriangleRange& range) { all.sortByCorners(range); });
  }
  this->Triangles = SharedVector(std::move(all.triangles));
  this->SourceOfTriangle = SharedVector(std::move(all.sources));
}

void TriangleMesh::OrderedTriangles::sortByCorners(const TriangleRange& range)
{
  struct Item
  {
    Triangle sorted;
    Triangle corners;
    Index source;
    bool operator<(const Item& other) const
    {
      return std::tie(this->sorted, this->source) < std::tie(other.sorted, other.source);
    }
  };
  std::vector<Item> items;
  items.reserve(range.last - range.first);
  for (Index t = range.first; t < range.last; ++t)
  {
    items.push_back({ sortedCorners(this->triangles[t]), this->triangles[t], this->sources[t] });
  }
  std::sort(items.begin(), items.end());
  for (Index t = range.first; const Item& item : items)
  {
    this->triangles[t] = item.corners;
    this->sources[t] = item.source;
    ++t;
  }
}

void TriangleMesh::forgetBareVertices(std::span<Index> vertexOfPoint)
{
  std::vector<BarePoint> bare;
  for (Index point = 0; point < vertexOfPoint.size(); ++point)
  {
    Index& vertex = vertexOfPoint[point];
    if (vertex != NoIndex && this->ring(vertex).empty())
    {
      bare.push_back({ point, vertex });
      vertex = NoIndex;
    }
  }
  this->BarePoints = SharedVector(std::move(bare));
}

void TriangleMesh::measureEdges()
{
  const std::span<const float> longestSides = this->Rings.longestSides();
  this->MeanLongestEdge = meanOf(longestSides);
  this->SpreadOfEdges = spreadOf(longestSides);
  this->LongestEdgeLength = largestOf(longestSides);
}

}
