// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/FirstMarchDistances.h"

#include "base/SortUnique.h"
#include "base/WorkCount.h"
#include "march/LabelBounds.h"
#include "march/StraightLines.h"
#include "march/TakenStart.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** Whether a way to a vertex is shorter than another one, or as long and from a seed of a smaller
 * number: rounding must not decide, nor the order of neighbours. */
bool isBefore(const StartValue& way, const StartValue& other)
{
  constexpr double rounding = 1.0 + 1e-10;
  return way.value * rounding < other.value ||
    (way.value <= other.value * rounding && way.label < other.label);
}

/** The seed of the neighbour through which a vertex is nearest, with the length through it; without
 * a seed if no neighbour has one. */
StartValue seedOfNeighbour(const TriangleMesh& mesh, Index vertex, const DistanceField& field)
{
  StartValue nearest{ vertex, NoIndex, DistanceField::Unreached, false };
  const std::span<const RingEntry> ring = mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Index neighbour = ring[i].neighbour();
    const double length = field.distance(neighbour) + norm(mesh.toNeighbour(vertex, i));
    const StartValue way{ vertex, field.nearestSeed(neighbour), length, false };
    if (way.label != NoIndex && isBefore(way, nearest))
    {
      nearest = way;
    }
  }
  return nearest;
}

/** Keeps the nearest one of each vertex. */
void keepNearest(std::vector<StartValue>& ways)
{
  std::sort(ways.begin(), ways.end(),
    [](const StartValue& x, const StartValue& y) { return x.vertex < y.vertex; });
  std::size_t kept = 0;
  for (const StartValue& way : ways)
  {
    if (kept == 0 || ways[kept - 1].vertex != way.vertex)
    {
      ways[kept++] = way;
    }
    else if (isBefore(way, ways[kept - 1]))
    {
      ways[kept - 1] = way;
    }
  }
  ways.resize(kept);
}

/** The neighbours of some vertices that have a distance and no seed, in ascending order. */
std::vector<Index> gapsBeside(
  const TriangleMesh& mesh, std::span<const StartValue> vertices, const DistanceField& field)
{
  std::vector<Index> gaps;
  for (const StartValue& start : vertices)
  {
    for (const RingEntry& entry : mesh.ring(start.vertex))
    {
      const Index neighbour = entry.neighbour();
      if (field.isReached(neighbour) && field.nearestSeed(neighbour) == NoIndex)
      {
        gaps.push_back(neighbour);
      }
    }
  }
  sortUnique(gaps);
  return gaps;
}

/**
 * Gives vertices seeds of their neighbours, round by round, so that neither the order of the
 * vertices nor the pieces decide. Collective. Time linear in the vertices, but for sorting them.
 * @param gaps  vertices of this piece that have a distance and no seed
 */
void takeSeedsOfNeighbours(
  const TriangleMesh& mesh, std::vector<Index> gaps, Partition& partition, DistanceField& field)
{
  const auto vertices = partition.sharedVertices();
  const std::unordered_set<Index> areShared(vertices.begin(), vertices.end());
  std::size_t left = gaps.size();
  while (true)
  {
    WorkCount::add(gaps.size());
    std::vector<StartValue> found;
    for (const Index vertex : gaps)
    {
      if (const StartValue nearest = seedOfNeighbour(mesh, vertex, field); nearest.label != NoIndex)
      {
        found.push_back(nearest);
      }
    }
    const double count = static_cast<double>(found.size());
    const std::vector<double> counts = partition.gather({ &count, 1 });
    if (*std::max_element(counts.begin(), counts.end()) == 0.0)
    {
      return;
    }
    std::vector<StartValue> shared;
    std::copy_if(found.begin(), found.end(), std::back_inserter(shared),
      [&](const StartValue& nearest) { return areShared.contains(nearest.vertex); });
    if (const auto others = partition.exchange(shared); !others.empty())
    {
      found.insert(found.end(), others.begin(), others.end());
      keepNearest(found);
    }
    for (const StartValue& nearest : found)
    {
      if (field.isReached(nearest.vertex) && field.nearestSeed(nearest.vertex) == NoIndex)
      {
        field.setNearestSeed(nearest.vertex, nearest.label);
        --left;
      }
    }
    // In the first round all were looked at: others can only have become possible by these.
    gaps = left > 0 ? gapsBeside(mesh, found, field) : std::vector<Index>();
  }
}

/** Where a front starts, if that is a point. */
struct StartPoint
{
  /** How far a place is at least. */
  double straightTo(const Vector3& place) const
  {
    return this->value + norm(place - this->position);
  }
  bool isKnown() const { return this->value > -DistanceField::Unreached; }

  Vector3 position{};
  /** The value of the seed; -infinity for a line or a region, from which nothing is known. */
  double value = -DistanceField::Unreached;
};

/** For each seed the point that it is. */
std::vector<StartPoint> pointsOfSeeds(std::span<const Label> labels)
{
  std::vector<StartPoint> points;
  points.reserve(labels.size());
  for (const Label& label : labels)
  {
    const bool isFirst = label.seed >= points.size();
    if (isFirst)
    {
      points.resize(label.seed + 1);
    }
    points[label.seed] = isFirst && label.shape == FrontShape::Round
      ? StartPoint{ label.position, label.value }
      : StartPoint();
  }
  return points;
}

/** Whether a vertex takes its distance in the first march. From a point, a label is exact but for
 * what the bounds took away, and stays if it is not more by a part of what they leave. */
bool isTaken(Index vertex, const LabelBounds& bounds, Taking taking,
  std::span<const StartPoint> points, const DistanceField& field)
{
  if (!field.isReached(vertex))
  {
    return true;
  }
  const double first = bounds.first(vertex);
  if (taking == Taking::WhereNone || !(first < field.distance(vertex)))
  {
    return false;
  }
  const bool isOfPoint = !points.empty() && points[field.nearestSeed(vertex)].isKnown();
  const double part = isOfPoint ? (bounds.ofVertex(vertex) - first) / 3.0 : 0.0;
  return first + part < field.distance(vertex);
}

/** Gives vertices the distances of labels that start there, also of those that ended at once. */
void takeStartsOfEnded(std::span<const StartValue> starts, std::span<const Label> labels,
  LabelBounds& bounds, DistanceField& field)
{
  for (const StartValue& start : starts)
  {
    if ((field.isReached(start.vertex) || bounds.isReached(start.vertex)) &&
      takeStart(start, labels, field))
    {
      bounds.noteAtEnd(start.vertex);
    }
  }
}

/** A vertex that takes its distance in the first march, and between what that should be. */
struct TakenVertex
{
  Index vertex;
  /** The least in a straight line from seeds that it may come from. */
  double straight;
  /** The least that is known of a way to the vertex. */
  double most;
};

/** The place of a vertex among those that are taken, or their number. */
std::size_t placeOf(std::span<const TakenVertex> taken, Index vertex)
{
  const auto place = std::lower_bound(taken.begin(), taken.end(), vertex,
    [](const TakenVertex& one, Index number) { return one.vertex < number; });
  return place != taken.end() && place->vertex == vertex ? place - taken.begin() : taken.size();
}

/** Considers the neighbours on this piece of the surface, and their nearest seeds. */
void considerNeighbours(const TriangleMesh& mesh, std::span<const StartPoint> points,
  const DistanceField& field, TakenVertex& taken)
{
  const Vector3 position = mesh.position(taken.vertex);
  const std::span<const RingEntry> ring = mesh.ring(taken.vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Index neighbour = ring[i].neighbour();
    const Index seed = field.nearestSeed(neighbour);
    // A vertex that an intrinsic mesh added has no position: then this is none either.
    const double straight =
      seed == NoIndex ? -DistanceField::Unreached : points[seed].straightTo(position);
    taken.straight = std::min(taken.straight, straight);
    taken.most =
      std::min(taken.most, field.distance(neighbour) + norm(mesh.toNeighbour(taken.vertex, i)));
  }
}

/** Takes over what other pieces of the surface know of vertices. Collective. */
void considerOtherPieces(std::span<TakenVertex> taken, Partition& partition)
{
  constexpr Index straight = 0;
  constexpr Index most = 1;
  std::vector<StartValue> ofShared;
  for (const Index vertex : partition.sharedVertices())
  {
    if (const std::size_t place = placeOf(taken, vertex); place < taken.size())
    {
      ofShared.push_back({ vertex, straight, taken[place].straight, false });
      ofShared.push_back({ vertex, most, taken[place].most, false });
    }
  }
  for (const StartValue& other : partition.exchange(ofShared))
  {
    if (const std::size_t place = placeOf(taken, other.vertex); place < taken.size())
    {
      double& least = other.label == straight ? taken[place].straight : taken[place].most;
      least = std::min(least, other.value);
    }
  }
}

/** Raises a distance of the first march by what is known of it; nothing if that is not enough, and
 * the distance may be too short. */
std::optional<double> raised(double first, const TakenVertex& taken)
{
  constexpr double rounding = 1.0 + 1e-9;
  if (taken.straight == -DistanceField::Unreached || taken.straight > taken.most * rounding)
  {
    return std::nullopt;
  }
  return std::max(first, std::min(taken.straight, taken.most));
}

/** The same where that is not enough. Beside vertices without a seed nothing is known. Else the
 * nearest seed is another one than those of neighbours: how far it is lies between the two. */
double raisedBetween(double first, const TakenVertex& taken)
{
  return taken.straight == -DistanceField::Unreached ? first
                                                     : std::max(first, 0.5 * (first + taken.most));
}

/**
 * Raises distances to the straight line to the nearest of all seeds, if these are points: what
 * neighbours have may be too short as well.
 * @param vertices  those whose distances may be too short
 */
void raiseToLines(const TriangleMesh& mesh, std::span<const StartPoint> points,
  std::span<const Index> vertices, DistanceField& field)
{
  double leastValue = DistanceField::Unreached;
  std::vector<Vector3> places;
  for (const StartPoint& point : points)
  {
    if (!point.isKnown())
    {
      return;
    }
    leastValue = std::min(leastValue, point.value);
    places.push_back(point.position);
  }
  std::vector<Index> shorter;
  std::vector<Vector3> positions;
  double longest = 0.0;
  for (const Index vertex : vertices)
  {
    const Index seed = field.nearestSeed(vertex);
    const Vector3& position = mesh.position(vertex);
    // Else there is a seed as near as that.
    if (seed != NoIndex && points[seed].straightTo(position) > field.distance(vertex))
    {
      shorter.push_back(vertex);
      positions.push_back(position);
      longest = std::max(longest, norm(position - points[seed].position));
    }
  }
  constexpr double rounding = 1.0 + 1e-9;
  StraightLines(positions).measure(places, rounding * longest,
    [&](Index first, std::span<const double> squares)
    {
      WorkCount::add(squares.size());
      for (std::size_t i = 0; i < squares.size(); ++i)
      {
        const Index vertex = shorter[first + i];
        field.setDistance(
          vertex, std::max(field.distance(vertex), leastValue + std::sqrt(squares[i])));
      }
    });
}

}

void takeFirstMarch(const TriangleMesh& mesh, std::span<const Label> labels,
  std::span<const StartValue> starts, Taking taking, LabelBounds& bounds, Partition& partition,
  DistanceField& field)
{
  std::vector<StartPoint> points;
  if (taking == Taking::WhereLessRaised)
  {
    points = pointsOfSeeds(labels);
    takeStartsOfEnded(starts, labels, bounds, field);
  }
  std::vector<TakenVertex> taken;
  for (const Index vertex : bounds.reached())
  {
    if (isTaken(vertex, bounds, taking, points, field))
    {
      taken.push_back({ vertex, DistanceField::Unreached, field.distance(vertex) });
    }
  }
  std::vector<Index> gaps;
  for (const TakenVertex& one : taken)
  {
    if (!field.isReached(one.vertex))
    {
      gaps.push_back(one.vertex);
    }
    field.setDistance(one.vertex, bounds.first(one.vertex));
  }
  takeSeedsOfNeighbours(mesh, std::move(gaps), partition, field);
  if (taking != Taking::WhereLessRaised)
  {
    return;
  }
  std::sort(taken.begin(), taken.end(),
    [](const TakenVertex& one, const TakenVertex& other) { return one.vertex < other.vertex; });
  for (TakenVertex& one : taken)
  {
    considerNeighbours(mesh, points, field, one);
  }
  considerOtherPieces(taken, partition);
  std::vector<Index> doubtful;
  for (const TakenVertex& one : taken)
  {
    const double first = bounds.first(one.vertex);
    const std::optional<double> distance = raised(first, one);
    if (!distance)
    {
      doubtful.push_back(one.vertex);
    }
    field.setDistance(one.vertex, distance ? *distance : raisedBetween(first, one));
    bounds.noteAtEnd(one.vertex);
  }
  raiseToLines(mesh, points, doubtful, field);
}

}
