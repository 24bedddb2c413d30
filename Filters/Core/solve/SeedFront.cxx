// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/SeedFront.h"

#include "base/Platform.h"
#include "base/SortUnique.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/JoinedCurves.h"
#include "solve/Partition.h"
#include "solve/RegionFront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace geodesic
{
namespace
{

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

double distanceToSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 side = b - a;
  const double length2 = dot(side, side);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, side) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + t * side));
}

/** Adds the labels and starts of one seed after the other, as far as this piece has it. */
class FrontBuilder
{
public:
  FrontBuilder(const TriangleMesh& mesh, const ClosedTriangles& closed, SeedFront& front)
    : Mesh(mesh)
    , Closed(closed)
    , Front(front)
  {
  }

  /** Takes curves that are added in place of the seeds that they are joined from. */
  void setJoined(std::vector<JoinedCurve> curves)
  {
    this->Joined = std::move(curves);
    this->NextJoined = this->Joined->begin();
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
        this->Joined ? this->addJoined() : this->addCurve(seed.points);
        break;
      case Seed::Kind::Region:
        // All regions together: see frontOfRegions().
        break;
    }
  }

private:
  /** A curve with more bends gets no round labels there. */
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

  /** Adds the joined curve at the seed, if there is one. */
  void addJoined()
  {
    if (this->NextJoined == this->Joined->end() || this->NextJoined->seed != this->Number)
    {
      return;
    }
    const std::vector<SurfacePoint>& points = this->NextJoined->points;
    if (this->NextJoined->numberOfSeeds == 1)
    {
      this->addCurve(points);
    }
    else
    {
      this->addPoint(points.front());
      this->addPoint(points.back());
      this->addStraightPiece(points, 0, points.size() - 1, true);
    }
    ++this->NextJoined;
  }

  /** @param points all of the curve's, on one of the pieces; none on the others */
  void addCurve(const std::vector<SurfacePoint>& points)
  {
    if (points.empty())
    {
      return;
    }
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
    const Carriers carriers = carriersOf(this->Mesh, a, b);
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

  const TriangleMesh& Mesh;
  const ClosedTriangles& Closed;
  SeedFront& Front;
  Index Number = 0;
  double Value = 0.0;
  std::optional<std::vector<JoinedCurve>> Joined;
  std::vector<JoinedCurve>::const_iterator NextJoined;
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

bool isAnyOf(std::span<const Seed> seeds, Seed::Kind kind)
{
  return std::any_of(
    seeds.begin(), seeds.end(), [&](const Seed& seed) { return seed.kind == kind; });
}

/** The labels of those curves that another piece has, by increasing number of the seed. Collective.
 */
SeedFront curvesOfOthers(
  std::span<const Seed> seeds, const SeedFront& ownFront, Partition& partition)
{
  std::vector<double> own;
  for (const Label& label : ownFront.labels)
  {
    if (seeds[label.seed].kind == Seed::Kind::Curve)
    {
      own.insert(own.end(),
        { static_cast<double>(label.seed), label.shape == FrontShape::Round ? 1.0 : 0.0,
          label.position.x, label.position.y, label.position.z, label.length });
    }
  }
  const std::vector<double> all = partition.gather(own);
  SeedFront others;
  for (std::size_t i = 0; i < all.size(); i += 6)
  {
    const auto seed = static_cast<Index>(all[i]);
    if (seeds[seed].points.empty())
    {
      const FrontShape shape = all[i + 1] == 1.0 ? FrontShape::Round : FrontShape::Straight;
      others.labels.push_back(
        { seed, shape, seeds[seed].value, {}, { all[i + 2], all[i + 3], all[i + 4] }, all[i + 5] });
    }
  }
  std::stable_sort(others.labels.begin(), others.labels.end(),
    [](const Label& a, const Label& b) { return a.seed < b.seed; });
  return others;
}

/** Adds the labels and starts of other seeds. Labels of both are by increasing number of the seed;
 * so are they afterwards. */
void merge(SeedFront& front, const SeedFront& others)
{
  if (others.labels.empty())
  {
    return;
  }
  SeedFront merged;
  merged.labels.reserve(front.labels.size() + others.labels.size());
  std::vector<Index> places;
  std::vector<Index> placesOfOthers;
  auto other = others.labels.begin();
  const auto takeOthersBefore = [&](std::size_t seed)
  {
    for (; other != others.labels.end() && other->seed < seed; ++other)
    {
      placesOfOthers.push_back(static_cast<Index>(merged.labels.size()));
      merged.labels.push_back(*other);
    }
  };
  for (const Label& label : front.labels)
  {
    takeOthersBefore(label.seed);
    places.push_back(static_cast<Index>(merged.labels.size()));
    merged.labels.push_back(label);
  }
  takeOthersBefore(NoIndex);
  const auto relabelled = [](std::vector<FrontStart> starts, const std::vector<Index>& labels)
  {
    for (FrontStart& start : starts)
    {
      start.label = labels[start.label];
    }
    return starts;
  };
  const std::vector<FrontStart> own = relabelled(std::move(front.starts), places);
  const std::vector<FrontStart> added = relabelled(others.starts, placesOfOthers);
  merged.starts.reserve(own.size() + added.size());
  std::merge(own.begin(), own.end(), added.begin(), added.end(), std::back_inserter(merged.starts),
    [](const FrontStart& a, const FrontStart& b) { return a.label < b.label; });
  front = std::move(merged);
}

}

void makeSeedFront(const TriangleMesh& mesh, const ClosedTriangles& closed,
  std::span<const Seed> seeds, bool joinsCurves, const std::function<bool()>& goesOn,
  Partition& partition, SeedFront& front)
{
  front.labels.clear();
  front.starts.clear();
  const bool hasCurves = isAnyOf(seeds, Seed::Kind::Curve);
  FrontBuilder builder(mesh, closed, front);
  if (joinsCurves && hasCurves)
  {
    builder.setJoined(joinedCurves(mesh, seeds, goesOn));
  }
  std::size_t points = 0;
  for (Index s = 0; s < seeds.size(); ++s)
  {
    prefetchLater(mesh, seeds, s);
    builder.add(seeds[s], s);
    points += seeds[s].points.size();
    if (points >= PointsOfFrontReport && !goesOn())
    {
      break;
    }
    points %= PointsOfFrontReport;
  }
  if (partition.isDivided() && hasCurves)
  {
    merge(front, curvesOfOthers(seeds, front, partition));
  }
  if (isAnyOf(seeds, Seed::Kind::Region))
  {
    merge(front, frontOfRegions(mesh, seeds, goesOn, partition));
  }
}

}
