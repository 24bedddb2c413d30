// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/SeedFront.h"

#include "base/NumberText.h"
#include "base/Platform.h"
#include "base/SortUnique.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

namespace geodesic
{
namespace
{

/** How messages call a seed. */
std::string nameOf(std::size_t number)
{
  return "Seed " + std::to_string(number);
}

/** @param seed  its number */
void checkPoint(const TriangleMesh& mesh, const SurfacePoint& point, std::size_t seed)
{
  const auto& weights = point.weights;
  const double sum = weights[0] + weights[1] + weights[2];
  const bool inside =
    std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0.0; });
  if (point.triangle >= mesh.numberOfTriangles())
  {
    throw std::invalid_argument(nameOf(seed) + " lies in triangle " +
      std::to_string(point.triangle) + ", but the mesh has " +
      std::to_string(mesh.numberOfTriangles()) + " triangles.");
  }
  if (!inside || !(std::abs(sum - 1.0) < 1e-6))
  {
    throw std::invalid_argument(nameOf(seed) + " has barycentric weights " + textOf(weights[0]) +
      ", " + textOf(weights[1]) + ", " + textOf(weights[2]) +
      "; each must be at least 0 and their sum 1.");
  }
}

Carriers carriersOfSegment(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  Carriers carriers = carriersOf(mesh, a);
  for (const Index carrier : carriersOf(mesh, b))
  {
    carriers.add(carrier);
  }
  return carriers;
}

void checkCurve(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points, std::size_t seed)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Carriers carriers = carriersOfSegment(mesh, points[i], points[i + 1]);
    if (carriers.size() > 3 || !mesh.hasTriangleWith({ carriers.begin(), carriers.end() }))
    {
      throw std::invalid_argument(nameOf(seed) + " is a curve whose segment " + std::to_string(i) +
        " lies neither in one face nor along one edge of the surface. Give it a point on each edge "
        "that it crosses.");
    }
  }
}

void checkSeed(const TriangleMesh& mesh, const Seed& seed, std::size_t number, bool mayBeElsewhere)
{
  if (seed.points.empty() && seed.vertices.empty() && !mayBeElsewhere)
  {
    throw std::invalid_argument(nameOf(number) + " has no point.");
  }
  if (!(seed.value >= 0.0 && std::isfinite(seed.value)))
  {
    throw std::invalid_argument(nameOf(number) + " has the value " + textOf(seed.value) +
      "; it must be finite and at least 0.");
  }
  for (const SurfacePoint& point : seed.points)
  {
    checkPoint(mesh, point, number);
  }
  for (Index vertex : seed.vertices)
  {
    if (vertex >= mesh.numberOfVertices())
    {
      throw std::invalid_argument(nameOf(number) + " has vertex " + std::to_string(vertex) +
        ", but the mesh has " + std::to_string(mesh.numberOfVertices()) + " vertices.");
    }
  }
  if (seed.kind == Seed::Kind::Curve)
  {
    checkCurve(mesh, seed.points, number);
  }
}

/** The corners of every open triangle that has all of @p carriers (one, two or three) as corners.
 */
std::vector<Index> cornersRound(
  const TriangleMesh& mesh, const ClosedTriangles& closed, const Carriers& carriers)
{
  if (carriers.size() == 3 && closed.isEmpty())
  {
    std::vector<Index> corners(carriers.begin(), carriers.end());
    std::sort(corners.begin(), corners.end());
    return corners;
  }
  std::vector<Index> corners;
  mesh.visitTrianglesWith({ carriers.begin(), carriers.end() },
    [&](Index centre, std::size_t place, const Triangle& triangle)
    {
      if (closed.isOpen(centre, place))
      {
        corners.insert(corners.end(), triangle.begin(), triangle.end());
      }
    });
  sortUnique(corners);
  return corners;
}

/** How often makeSeedFront() calls goesOn(). */
constexpr std::size_t PointsOfReport = 4096;

double distanceToSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 side = b - a;
  const double length2 = dot(side, side);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, side) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + t * side));
}

/** Gathers the labels and starts of one seed after the other. */
class FrontBuilder
{
public:
  FrontBuilder(
    const TriangleMesh& mesh, const ClosedTriangles& closed, Partition& partition, SeedFront& front)
    : Mesh(mesh)
    , Closed(closed)
    , Pieces(partition)
    , Front(front)
  {
  }

  void add(const Seed& seed, Index number)
  {
    this->Number = number;
    this->Value = seed.value;
    switch (seed.kind)
    {
      case Seed::Kind::Point:
        this->addSeedPoint(seed);
        break;
      case Seed::Kind::Curve:
        this->addCurve(seed.points);
        break;
      case Seed::Kind::Region:
        this->addRegion(seed.vertices);
        break;
    }
  }

private:
  /** A curve with more bends, or a region with more border vertices, gets no round labels there. */
  static constexpr std::size_t MostRoundLabels = 256;
  /** A curve bends where the cosine of the angle between its segments is less. */
  static constexpr double StraightCosine = 0.985;

  Index addLabel(FrontShape shape, const SurfacePoint& origin = {}, const Vector3& position = {})
  {
    this->Front.labels.push_back({ this->Number, shape, this->Value, origin, position });
    return static_cast<Index>(this->Front.labels.size() - 1);
  }

  void addSeedPoint(const Seed& seed)
  {
    if (seed.points.empty())
    {
      this->addLabel(FrontShape::Round, {}, *seed.position);
      return;
    }
    this->addPoint(
      seed.points[0], seed.position ? *seed.position : this->Mesh.positionOf(seed.points[0]));
  }

  void addPoint(const SurfacePoint& point) { this->addPoint(point, this->Mesh.positionOf(point)); }

  void addPoint(const SurfacePoint& point, const Vector3& position)
  {
    const Index label = this->addLabel(FrontShape::Round, point, position);
    const Carriers carriers = carriersOf(this->Mesh, point);
    if (carriers.size() == 1)
    {
      this->Front.starts.push_back({ carriers[0], label, 0.0 });
      return;
    }
    for (Index vertex : cornersRound(this->Mesh, this->Closed, carriers))
    {
      const double length = this->Mesh.isIntrinsic() ? this->lengthOnSurface(vertex, point)
                                                     : norm(this->Mesh.position(vertex) - position);
      this->Front.starts.push_back({ vertex, label, length });
    }
  }

  /** The length from a point to a corner of its triangle or, if it is on an edge, of another one
   * there, in the plane of that triangle. */
  double lengthOnSurface(Index corner, const SurfacePoint& point) const
  {
    // The triangle of the corner and all that carry the point.
    Triangle triangle = this->Mesh.triangle(point.triangle);
    std::array<double, 3> weights = point.weights;
    if (std::find(triangle.begin(), triangle.end(), corner) == triangle.end())
    {
      const std::size_t without = weights[0] > 0.0 ? weights[1] > 0.0 ? 2 : 1 : 0;
      triangle[without] = corner;
      weights[without] = 0.0;
    }
    // Rings of very many triangles are not looked through where there is a shorter one.
    const auto sizeOf = [&](Index vertex) { return this->Mesh.ring(vertex).size(); };
    const Index centre = *std::min_element(
      triangle.begin(), triangle.end(), [&](Index a, Index b) { return sizeOf(a) < sizeOf(b); });
    const std::span<const RingEntry> ring = this->Mesh.ring(centre);
    const auto has = [&](Index vertex)
    { return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end(); };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (!ring[i].opensTriangle() || !has(ring[i].neighbour()) || !has(ring[i + 1].neighbour()))
      {
        continue;
      }
      Vector3 toPoint;
      for (std::size_t k = 0; k < 3; ++k)
      {
        // The centre itself is at the origin.
        const Vector3 place = triangle[k] == centre
          ? Vector3{}
          : this->Mesh.toNeighbour(centre, triangle[k] == ring[i].neighbour() ? i : i + 1);
        toPoint = toPoint + (weights[k] - (triangle[k] == corner ? 1.0 : 0.0)) * place;
      }
      least = std::min(least, norm(toPoint));
    }
    return least;
  }

  /** @param points all of the curve's, on one of the pieces; none on the others */
  void addCurve(const std::vector<SurfacePoint>& points)
  {
    const std::size_t first = this->Front.labels.size();
    if (!points.empty())
    {
      this->addWholeCurve(points);
    }
    if (this->Pieces.isDivided())
    {
      this->addLabelsOfOthers(first);
    }
  }

  /** Copies the labels from @p first on of the piece that has them to the pieces that have none. */
  void addLabelsOfOthers(std::size_t first)
  {
    const bool hasOwn = this->Front.labels.size() > first;
    std::vector<double> own;
    for (std::size_t i = first; i < this->Front.labels.size(); ++i)
    {
      const Label& label = this->Front.labels[i];
      own.insert(own.end(),
        { label.shape == FrontShape::Round ? 1.0 : 0.0, label.position.x, label.position.y,
          label.position.z, label.length });
    }
    const std::vector<double> all = this->Pieces.gather(own);
    for (std::size_t i = 0; i < all.size() && !hasOwn; i += 5)
    {
      const Index label = this->addLabel(all[i] == 1.0 ? FrontShape::Round : FrontShape::Straight,
        {}, { all[i + 1], all[i + 2], all[i + 3] });
      this->Front.labels[label].length = all[i + 4];
    }
  }

  void addWholeCurve(const std::vector<SurfacePoint>& points)
  {
    std::vector<std::size_t> bends = this->bendsOf(points);
    const bool hasRoundEnds = bends.size() <= MostRoundLabels;
    if (!hasRoundEnds)
    {
      bends.clear();
    }
    for (std::size_t bend : bends)
    {
      this->addPoint(points[bend]);
    }
    // Each straight piece marches by itself: on the inner side of a bend two fronts meet.
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      if (i + 1 == points.size() || std::binary_search(bends.begin(), bends.end(), i))
      {
        this->addStraightPiece(points, first, i, hasRoundEnds);
        first = i;
      }
    }
  }

  /** The segments of a curve from its point @p first to its point @p last.
   * @param hasRoundEnds whether round fronts start at these two points */
  void addStraightPiece(
    const std::vector<SurfacePoint>& points, std::size_t first, std::size_t last, bool hasRoundEnds)
  {
    const Index label = this->addLabel(FrontShape::Straight);
    std::map<Index, double> lengths;
    double lengthOfLine = 0.0;
    for (std::size_t i = first; i < last; ++i)
    {
      const Vector3 a = this->Mesh.positionOf(points[i]);
      const Vector3 b = this->Mesh.positionOf(points[i + 1]);
      lengthOfLine += norm(b - a);
      for (Index vertex : this->cornersRoundSegment(points[i], points[i + 1]))
      {
        const double length = distanceToSegment(this->Mesh.position(vertex), a, b);
        const auto [place, isNew] = lengths.emplace(vertex, length);
        place->second = std::min(place->second, length);
      }
    }
    for (const auto& [vertex, length] : lengths)
    {
      this->Front.starts.push_back({ vertex, label, length });
    }
    if (hasRoundEnds)
    {
      this->Front.labels[label].length = lengthOfLine;
    }
  }

  /** None if all faces of the segment are closed. */
  std::vector<Index> cornersRoundSegment(const SurfacePoint& a, const SurfacePoint& b) const
  {
    const Carriers carriers = carriersOfSegment(this->Mesh, a, b);
    return cornersRound(this->Mesh, this->Closed, carriers);
  }

  /** The numbers of the points where the curve bends, and of its two ends. */
  std::vector<std::size_t> bendsOf(const std::vector<SurfacePoint>& points) const
  {
    std::vector<Vector3> positions;
    positions.reserve(points.size());
    for (const SurfacePoint& point : points)
    {
      positions.push_back(this->Mesh.positionOf(point));
    }
    std::vector<std::size_t> bends{ 0 };
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      const Vector3 in = positions[i] - positions[i - 1];
      const Vector3 out = positions[i + 1] - positions[i];
      if (!(dot(in, out) >= StraightCosine * norm(in) * norm(out)))
      {
        bends.push_back(i);
      }
    }
    bends.push_back(points.size() - 1);
    return bends;
  }

  void addRegion(std::vector<Index> vertices)
  {
    vertices = this->withThoseOfOthers(std::move(vertices));
    const auto isInside = [&](Index vertex)
    { return std::binary_search(vertices.begin(), vertices.end(), vertex); };
    std::vector<Index> besideInside;
    std::vector<Index> besideOutside;
    for (Index vertex : vertices)
    {
      bool hasInside = false;
      bool hasOutside = false;
      for (const RingEntry& entry : this->Mesh.ring(vertex))
      {
        (isInside(entry.neighbour()) ? hasInside : hasOutside) = true;
      }
      if (hasInside)
      {
        besideInside.push_back(vertex);
      }
      if (hasOutside)
      {
        besideOutside.push_back(vertex);
      }
    }
    const std::vector<Index> joined = this->withThoseOfOthers(std::move(besideInside));
    besideOutside = this->withThoseOfOthers(std::move(besideOutside));
    std::vector<Index> isolated;
    std::set_difference(
      vertices.begin(), vertices.end(), joined.begin(), joined.end(), std::back_inserter(isolated));
    std::vector<Index> border;
    std::set_intersection(joined.begin(), joined.end(), besideOutside.begin(), besideOutside.end(),
      std::back_inserter(border));

    this->addVertices(isolated);
    if (this->isAnywhere(joined))
    {
      const Index label = this->addLabel(FrontShape::Straight);
      for (Index vertex : joined)
      {
        this->Front.starts.push_back({ vertex, label, 0.0 });
      }
    }
    if (this->countOf(border) <= static_cast<double>(MostRoundLabels))
    {
      this->addVertices(border);
    }
  }

  /** Adds to a set of vertices the shared ones in the sets of other pieces; returns it sorted. */
  std::vector<Index> withThoseOfOthers(std::vector<Index> vertices)
  {
    std::vector<StartValue> own;
    own.reserve(vertices.size());
    for (Index vertex : vertices)
    {
      own.push_back({ vertex, 0, 0.0, false });
    }
    for (const StartValue& other : this->Pieces.exchange(own))
    {
      vertices.push_back(other.vertex);
    }
    sortUnique(vertices);
    return vertices;
  }

  /** The number of different vertices in the sets of all pieces. */
  double countOf(const std::vector<Index>& vertices)
  {
    const auto owned = static_cast<double>(std::count_if(
      vertices.begin(), vertices.end(), [&](Index vertex) { return this->Pieces.owns(vertex); }));
    const std::vector<double> counts = this->Pieces.gather({ &owned, 1 });
    return std::accumulate(counts.begin(), counts.end(), 0.0);
  }

  bool isAnywhere(const std::vector<Index>& vertices) { return this->countOf(vertices) > 0.0; }

  /** Adds a round label at each vertex in the sets of all pieces, in the same order on each. */
  void addVertices(const std::vector<Index>& vertices)
  {
    if (!this->Pieces.isDivided())
    {
      for (Index vertex : vertices)
      {
        this->addPoint(this->Mesh.pointAtVertex(vertex));
      }
      return;
    }
    std::vector<double> own;
    std::map<std::array<double, 3>, Index> vertexAt;
    for (Index vertex : vertices)
    {
      const Vector3& p = this->Mesh.position(vertex);
      // Adding 0 turns -0 into 0, so that equal places have the same bits on all pieces.
      const std::array place{ p.x + 0.0, p.y + 0.0, p.z + 0.0 };
      // The triangles of a vertex can all be on other pieces, one of which then has its origin.
      if (!this->Mesh.ring(vertex).empty())
      {
        vertexAt.emplace(place, vertex);
      }
      own.insert(own.end(), place.begin(), place.end());
    }
    const std::vector<double> all = this->Pieces.gather(own);
    std::set<std::array<double, 3>> places;
    for (std::size_t i = 0; i < all.size(); i += 3)
    {
      places.insert({ all[i], all[i + 1], all[i + 2] });
    }
    for (const std::array<double, 3>& place : places)
    {
      const Vector3 position{ place[0], place[1], place[2] };
      if (const auto here = vertexAt.find(place); here != vertexAt.end())
      {
        this->addPoint(this->Mesh.pointAtVertex(here->second), position);
      }
      else
      {
        this->addLabel(FrontShape::Round, {}, position);
      }
    }
  }

  const TriangleMesh& Mesh;
  const ClosedTriangles& Closed;
  Partition& Pieces;
  SeedFront& Front;
  Index Number = 0;
  double Value = 0.0;
};

/** Asks the processor to fetch what the front needs of points that come soon: seeds lie anywhere.
 */
GEODESIC_INLINED void prefetchLater(
  const TriangleMesh& mesh, std::span<const Seed> seeds, std::size_t seed)
{
  constexpr std::size_t soon = 8;
  if (seed + 2 * soon >= seeds.size())
  {
    return;
  }
  if (const auto& later = seeds[seed + 2 * soon].points; !later.empty())
  {
    prefetchToRead(&mesh.triangle(later[0].triangle));
  }
  if (const auto& next = seeds[seed + soon].points; !next.empty())
  {
    for (const Index corner : mesh.triangle(next[0].triangle))
    {
      prefetchToRead(&mesh.position(corner));
    }
  }
}

}

void checkSeeds(const TriangleMesh& mesh, std::span<const Seed> seeds, const Partition& partition)
{
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    checkSeed(mesh, seeds[s], s, partition.isDivided());
  }
}

void makeSeedFront(const TriangleMesh& mesh, const ClosedTriangles& closed,
  std::span<const Seed> seeds, const std::function<bool()>& goesOn, Partition& partition,
  SeedFront& front)
{
  front.labels.clear();
  front.starts.clear();
  FrontBuilder builder(mesh, closed, partition, front);
  std::size_t points = 0;
  for (Index s = 0; s < seeds.size(); ++s)
  {
    prefetchLater(mesh, seeds, s);
    builder.add(seeds[s], s);
    points += seeds[s].points.size() + seeds[s].vertices.size();
    // The others wait for this piece's part of curves and regions.
    if (points >= PointsOfReport && !goesOn() && !partition.isDivided())
    {
      return;
    }
    points %= PointsOfReport;
  }
}

}
