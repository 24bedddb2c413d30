// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/DealtSurface.h"

#include "base/SortUnique.h"
#include "mesh/TriangleMesh.h"
#include "ranks/KeyMatches.h"

#include <algorithm>
#include <array>

namespace geodesic::distributed
{
namespace
{

/**
 * The number of patches of a piece. With more the ranks' work is hardly more even, and more points
 * are shared; counts and times are in Plugin/Documentation/cluster_benchmarks.md.
 */
constexpr int PatchesOfPiece = 8;

struct SentVertex
{
  GlobalVertex vertex;
  Vector3 position;
};

struct SentDistance
{
  double distance;
  Index seed;
};

/** A vertex of a region among those that the sender dealt. */
struct SentRegionVertex
{
  Index seed;
  Index number;
};

/** Sends each rank its values. Returns those that each rank sent to this one. Collective. */
template <class T>
std::vector<std::vector<T>> exchanged(RankGroup& ranks, std::vector<std::vector<T>> toRank)
{
  const std::vector<int> others = ranks.others();
  std::vector<RankGroup::Message> messages;
  for (const int rank : others)
  {
    const char* bytes = reinterpret_cast<const char*>(toRank[rank].data());
    messages.emplace_back(bytes, bytes + toRank[rank].size() * sizeof(T));
  }
  std::vector<std::vector<T>> fromRank(ranks.size());
  fromRank[ranks.rank()] = std::move(toRank[ranks.rank()]);
  const auto received = ranks.exchange(others, messages);
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    fromRank[others[i]] = valuesIn<T>(received[i]);
  }
  return fromRank;
}

/** Returns values at some places; 0 if there are no values at all. */
template <class T>
std::vector<T> chosen(std::span<const T> values, std::span<const Index> places)
{
  std::vector<T> chosen;
  chosen.reserve(places.size());
  for (const Index place : places)
  {
    chosen.push_back(values.empty() ? T() : values[place]);
  }
  return chosen;
}

/** Whether a point of a triangle can be within the distance: one of its corners is, but for a side.
 */
bool isWithin(const TriangleMesh& mesh, const Triangle& triangle, const Dealing& dealing)
{
  if (dealing.distance == BoundingBox::infinity)
  {
    return true;
  }
  double nearest = BoundingBox::infinity;
  double longestSide = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const Vector3 corner = mesh.position(triangle[c]);
    nearest = std::min(nearest, norm(dealing.box.nearestTo(corner) - corner));
    longestSide = std::max(longestSide, norm(mesh.position(triangle[(c + 1) % 3]) - corner));
  }
  return nearest <= dealing.distance * (1.0 + 1e-9) + longestSide;
}

}

bool Dealing::operator==(const Dealing& other) const
{
  const auto areSame = [](const Vector3& a, const Vector3& b)
  { return a.x == b.x && a.y == b.y && a.z == b.z; };
  return this->isToFirst == other.isToFirst && areSame(this->box.low, other.box.low) &&
    areSame(this->box.high, other.box.high) && this->distance == other.distance;
}

DealtSurface::DealtSurface(
  RankGroup& ranks, std::shared_ptr<const DividedMesh> pieces, const Dealing& dealing)
  : Origin(std::move(pieces))
  , How(dealing)
  , ToRank(ranks.size())
{
  ranks.together([&] { this->cut(ranks); });
  this->deal(ranks);
}

void DealtSurface::cut(const RankGroup& ranks)
{
  // Triangles are in the order of a space-filling curve, so that consecutive ones are a patch.
  const TriangleMesh& piece = this->Origin->mesh();
  const std::size_t count = piece.numberOfTriangles();
  for (int patch = 0; patch < PatchesOfPiece; ++patch)
  {
    Dealt& dealt = this->ToRank[this->How.isToFirst ? 0 : (ranks.rank() + patch) % ranks.size()];
    for (std::size_t t = count * patch / PatchesOfPiece; t < count * (patch + 1) / PatchesOfPiece;
         ++t)
    {
      if (isWithin(piece, piece.triangle(static_cast<Index>(t)), this->How))
      {
        dealt.triangles.push_back(static_cast<Index>(t));
      }
    }
  }
  // Vertices whose triangles have moved to the first rank get their distances from there.
  const int ofBare = this->How.isToFirst ? 0 : ranks.rank();
  for (int rank = 0; rank < ranks.size(); ++rank)
  {
    Dealt& dealt = this->ToRank[rank];
    std::vector<bool> isUsed(piece.numberOfVertices(), false);
    for (const Index t : dealt.triangles)
    {
      for (const Index corner : piece.triangle(t))
      {
        isUsed[corner] = true;
      }
    }
    for (Index v = 0; v < piece.numberOfVertices(); ++v)
    {
      if (isUsed[v] || (rank == ofBare && piece.ring(v).empty()))
      {
        dealt.vertices.push_back(v);
      }
    }
  }
}

void DealtSurface::deal(RankGroup& ranks)
{
  const TriangleMesh& piece = this->Origin->mesh();
  std::vector<std::vector<SentVertex>> vertices(ranks.size());
  std::vector<std::vector<Triangle>> triangles(ranks.size());
  std::vector<Index> numbers(piece.numberOfVertices());
  for (int rank = 0; rank < ranks.size(); ++rank)
  {
    const Dealt& dealt = this->ToRank[rank];
    for (const Index vertex : dealt.vertices)
    {
      numbers[vertex] = static_cast<Index>(vertices[rank].size());
      vertices[rank].push_back({ this->Origin->shared().globalOf(vertex), piece.position(vertex) });
    }
    for (const Index t : dealt.triangles)
    {
      const Triangle& corners = piece.triangle(t);
      triangles[rank].push_back({ numbers[corners[0]], numbers[corners[1]], numbers[corners[2]] });
    }
  }
  vertices = exchanged(ranks, std::move(vertices));
  triangles = exchanged(ranks, std::move(triangles));

  const ThreadTeam team(ranks.threadsOfThisRank());
  std::vector<Vector3> points;
  std::vector<Triangle> corners;
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<Key> keys;
  ranks.together(
    [&]
    {
      for (int rank = 0; rank < ranks.size(); ++rank)
      {
        const auto first = static_cast<Index>(points.size());
        this->FromRank.push_back({ first, static_cast<Index>(corners.size()) });
        for (const SentVertex& sent : vertices[rank])
        {
          this->Points.emplace_back(sent.vertex, static_cast<Index>(points.size()));
          points.push_back(sent.position);
        }
        for (const auto& [a, b, c] : triangles[rank])
        {
          corners.push_back({ first + a, first + b, first + c });
        }
      }
      std::sort(this->Points.begin(), this->Points.end());
      std::vector<Index> kinds(points.size());
      std::vector<GlobalVertex> vertexOfPoint(points.size());
      Index kind = NoIndex;
      for (std::size_t i = 0; i < this->Points.size(); ++i)
      {
        const auto& [vertex, point] = this->Points[i];
        kind = i > 0 && this->Points[i - 1].first == vertex ? kind : point;
        kinds[point] = kind;
        vertexOfPoint[point] = vertex;
      }
      mesh = std::make_shared<const TriangleMesh>(points, corners, kinds, team, piece.measurer());
      std::vector<Index> vertexOfKind(points.size(), NoIndex);
      for (Index v = 0; v < mesh->numberOfVertices(); ++v)
      {
        vertexOfKind[kinds[mesh->pointOfVertex(v)]] = v;
      }
      for (const Index ofPoint : kinds)
      {
        this->VertexOfPoint.push_back(vertexOfKind[ofPoint]);
      }
      for (Index v = 0; v < mesh->numberOfVertices(); ++v)
      {
        const GlobalVertex& vertex = vertexOfPoint[mesh->pointOfVertex(v)];
        keys.push_back({ static_cast<std::uint64_t>(vertex.rank), vertex.vertex, 0, 0 });
      }
    });
  this->Divided = std::make_unique<const DividedMesh>(ranks, mesh, keys);
}

std::vector<double> DealtSurface::ofVertices(RankGroup& ranks, std::span<const double> values) const
{
  std::vector<std::vector<double>> toRank;
  for (const Dealt& dealt : this->ToRank)
  {
    toRank.push_back(chosen(values, std::span(dealt.vertices)));
  }
  std::vector<double> got(this->mesh().numberOfVertices());
  const auto fromRank = exchanged(ranks, std::move(toRank));
  for (std::size_t rank = 0; rank < fromRank.size(); ++rank)
  {
    for (std::size_t i = 0; i < fromRank[rank].size(); ++i)
    {
      if (const Index vertex = this->vertexAt(this->FromRank[rank], i); vertex != NoIndex)
      {
        got[vertex] = fromRank[rank][i];
      }
    }
  }
  return got;
}

std::vector<std::uint8_t> DealtSurface::ofVertices(
  RankGroup& ranks, std::span<const std::uint8_t> flags) const
{
  const std::vector<double> values(flags.begin(), flags.end());
  const std::vector<double> got = this->ofVertices(ranks, std::span(values));
  return { got.begin(), got.end() };
}

std::vector<std::uint8_t> DealtSurface::ofTriangles(
  RankGroup& ranks, std::span<const std::uint8_t> flags) const
{
  std::vector<std::vector<std::uint8_t>> toRank;
  for (const Dealt& dealt : this->ToRank)
  {
    toRank.push_back(chosen(flags, std::span(dealt.triangles)));
  }
  std::vector<std::uint8_t> inOrder;
  for (const std::vector<std::uint8_t>& from : exchanged(ranks, std::move(toRank)))
  {
    inOrder.insert(inOrder.end(), from.begin(), from.end());
  }
  std::vector<std::uint8_t> got;
  for (Index t = 0; t < this->mesh().numberOfTriangles(); ++t)
  {
    got.push_back(inOrder[this->mesh().sourceOfTriangle(t)]);
  }
  return got;
}

DealtSurface::Places DealtSurface::places(RankGroup& ranks, const Places& points) const
{
  // The number of the point, and rank, vertex and weight of each of three corners.
  constexpr std::size_t sent = 10;
  std::vector<double> own;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (const SurfacePoint& point : points[p])
    {
      own.push_back(static_cast<double>(p));
      for (int c = 0; c < 3; ++c)
      {
        const Index corner = this->Origin->mesh().triangle(point.triangle)[c];
        const GlobalVertex vertex = this->Origin->shared().globalOf(corner);
        own.insert(own.end(),
          { static_cast<double>(vertex.rank), static_cast<double>(vertex.vertex),
            point.weights[c] });
      }
    }
  }
  Places found(points.size());
  std::vector<bool> isKnown(points.size(), false);
  const std::vector<double> all = ranks.gather(own);
  for (std::size_t i = 0; i < all.size(); i += sent)
  {
    const auto p = static_cast<std::size_t>(all[i]);
    // All ranks take the place of the lowest rank that has one.
    if (isKnown[p])
    {
      continue;
    }
    isKnown[p] = true;
    std::vector<Carrier> carriers;
    for (std::size_t c = i + 1; c < i + sent; c += 3)
    {
      carriers.emplace_back(
        GlobalVertex{ static_cast<int>(all[c]), static_cast<Index>(all[c + 1]) }, all[c + 2]);
    }
    if (const auto place = this->placeOf(carriers))
    {
      found[p].push_back(*place);
    }
  }
  return found;
}

std::optional<SurfacePoint> DealtSurface::placeOf(std::span<const Carrier> carriers) const
{
  std::vector<Index> corners;
  std::vector<double> weights;
  for (const auto& [vertex, weight] : carriers)
  {
    if (weight > 0.0)
    {
      corners.push_back(this->find(vertex));
      weights.push_back(weight);
    }
  }
  const bool isHere = std::find(corners.begin(), corners.end(), NoIndex) == corners.end();
  const std::vector<Index> triangles =
    isHere ? this->mesh().trianglesWith(corners) : std::vector<Index>{};
  if (triangles.empty())
  {
    return std::nullopt;
  }
  SurfacePoint place{ triangles.front(), {} };
  const Triangle& triangle = this->mesh().triangle(place.triangle);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    place.weights[std::find(triangle.begin(), triangle.end(), corners[i]) - triangle.begin()] =
      weights[i];
  }
  return place;
}

std::optional<SurfacePoint> DealtSurface::placeOf(const SurfacePoint& point) const
{
  std::array<Carrier, 3> carriers;
  for (int c = 0; c < 3; ++c)
  {
    const Index corner = this->Origin->mesh().triangle(point.triangle)[c];
    carriers[c] = { this->Origin->shared().globalOf(corner), point.weights[c] };
  }
  return this->placeOf(carriers);
}

std::vector<Seed> DealtSurface::seeds(RankGroup& ranks, std::vector<Seed> seeds) const
{
  Places points;
  std::vector<std::vector<SentRegionVertex>> toRank(this->ToRank.size());
  for (Index s = 0; s < seeds.size(); ++s)
  {
    // The ranks have different points of a curve, but one point in different places.
    points.push_back(
      seeds[s].kind == Seed::Kind::Curve ? std::vector<SurfacePoint>{} : seeds[s].points);
    for (const Index vertex : seeds[s].vertices)
    {
      for (std::size_t rank = 0; rank < this->ToRank.size(); ++rank)
      {
        const std::vector<Index>& dealt = this->ToRank[rank].vertices;
        const auto place = std::lower_bound(dealt.begin(), dealt.end(), vertex);
        if (place != dealt.end() && *place == vertex)
        {
          toRank[rank].push_back({ s, static_cast<Index>(place - dealt.begin()) });
        }
      }
    }
    seeds[s].vertices.clear();
  }
  Places found = this->places(ranks, points);
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    if (seeds[s].kind != Seed::Kind::Curve)
    {
      seeds[s].points = std::move(found[s]);
      continue;
    }
    for (SurfacePoint& point : seeds[s].points)
    {
      point = this->placeOf(point).value();
    }
  }
  const auto fromRank = exchanged(ranks, std::move(toRank));
  for (std::size_t rank = 0; rank < fromRank.size(); ++rank)
  {
    for (const SentRegionVertex& sent : fromRank[rank])
    {
      if (const Index vertex = this->vertexAt(this->FromRank[rank], sent.number); vertex != NoIndex)
      {
        seeds[sent.seed].vertices.push_back(vertex);
      }
    }
  }
  for (Seed& seed : seeds)
  {
    sortUnique(seed.vertices);
  }
  return seeds;
}

void DealtSurface::takeBack(
  RankGroup& ranks, const DistanceField* dealt, StopReason reason, DistanceField& ofPiece) const
{
  std::vector<std::vector<SentDistance>> toRank(ranks.size());
  for (int rank = 0; rank < ranks.size(); ++rank)
  {
    const Index first = this->FromRank[rank].firstPoint;
    const Index last = rank + 1 < ranks.size() ? this->FromRank[rank + 1].firstPoint
                                               : static_cast<Index>(this->Points.size());
    for (Index point = first; point < last; ++point)
    {
      const Index vertex = this->VertexOfPoint[point];
      toRank[rank].push_back(vertex == NoIndex
          ? SentDistance{ DistanceField::Unreached, NoIndex }
          : SentDistance{ dealt->distance(vertex), dealt->nearestSeed(vertex) });
    }
  }
  ofPiece.reset();
  const auto fromRank = exchanged(ranks, std::move(toRank));
  for (std::size_t rank = 0; rank < fromRank.size(); ++rank)
  {
    for (std::size_t i = 0; i < fromRank[rank].size(); ++i)
    {
      const SentDistance& sent = fromRank[rank][i];
      const Index vertex = this->ToRank[rank].vertices[i];
      if (sent.distance < ofPiece.distance(vertex))
      {
        ofPiece.setDistance(vertex, sent.distance);
        ofPiece.setNearestSeed(vertex, sent.seed);
      }
    }
  }
  ofPiece.orderReached();
  ofPiece.finish(DistanceField::Unreached, reason);
}

Index DealtSurface::find(const GlobalVertex& vertex) const
{
  const auto place =
    std::lower_bound(this->Points.begin(), this->Points.end(), std::pair(vertex, Index{ 0 }));
  return place != this->Points.end() && place->first == vertex ? this->VertexOfPoint[place->second]
                                                               : NoIndex;
}

}
