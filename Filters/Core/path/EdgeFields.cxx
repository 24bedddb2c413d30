// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/EdgeFields.h"

#include "base/Interruption.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace geodesic
{
namespace
{

/** Where a function is 0 between two places. By rounding it may be on the same side of 0 at both:
 * it is then so near one of them. */
double rootBetween(
  const std::function<double(double)>& function, bool isNegativeAtLow, double low, double high)
{
  constexpr int steps = 60;
  for (int i = 0; i < steps; ++i)
  {
    const double middle = 0.5 * (low + high);
    ((function(middle) < 0.0) == isNegativeAtLow ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/** The place from 0 to 1 where a function with one minimum is least. */
double leastPlace(const std::function<double(double)>& function)
{
  double low = 0.0;
  double high = 1.0;
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i)
  {
    const double first = low + (high - low) / 3.0;
    const double second = high - (high - low) / 3.0;
    (function(first) < function(second) ? high : low) =
      function(first) < function(second) ? second : first;
  }
  return 0.5 * (low + high);
}

std::vector<double> linearPlaces(double first, double second, double level)
{
  return (first < level) != (second < level)
    ? std::vector{ std::clamp((level - first) / (second - first), 0.0, 1.0) }
    : std::vector<double>{};
}

struct EndOfEdge
{
  double distance;
  bool isBelow;
};

/** Of the distance from a line of seeds between the ends: it falls to 0 and rises again. */
std::vector<double> placesBesideLine(const EndOfEdge& a, const EndOfEdge& b, double level)
{
  std::vector<double> places;
  const double sum = a.distance + b.distance;
  if (!a.isBelow && level > 0.0)
  {
    places.push_back((a.distance - level) / sum);
  }
  if (!b.isBelow && level > 0.0)
  {
    places.push_back((a.distance + level) / sum);
  }
  return places;
}

/** Of the distance from a point at cost 1.
 * @param error by how much the faces' values differ from that */
std::vector<double> roundPlaces(
  const EndOfEdge& a, const EndOfEdge& b, double length, double level, double error)
{
  if (a.isBelow && b.isBelow)
  {
    return {};
  }
  const double first = a.distance;
  const double second = b.distance;
  const bool differ = a.isBelow != b.isBelow;
  if (std::abs(second - first) >= length)
  {
    // So a front goes along the edge.
    return differ && first != second
      ? std::vector{ std::clamp((level - first) / (second - first), 0.0, 1.0) }
      : std::vector<double>{};
  }
  // The square of the distance is a parabola: least * at * its middle.
  const double middle = 0.5 * (1.0 - (second - first) * (second + first) / (length * length));
  const double least = (first - middle * length) * (first + middle * length);
  const double squared = (level * level - least) / (length * length);
  const double half = std::sqrt(std::max(squared, 0.0));
  if (differ)
  {
    return { std::clamp(a.isBelow ? middle + half : middle - half, 0.0, 1.0) };
  }
  if (!(level > 0.0 && squared > 0.0 && middle - half > 0.0 && middle + half < 1.0))
  {
    return {};
  }
  // Where fronts meet, or the cost jumps, there seems to be a source that does not exist.
  constexpr double trusted = 0.1;
  const double depth = std::min(first, second) - std::sqrt(std::max(least, 0.0));
  return least > 0.0 && error > trusted * depth ? std::vector<double>{}
                                                : std::vector{ middle - half, middle + half };
}

}

EdgeFields::EdgeFields(const SurfaceField& field, std::span<const Index> faces)
  : Field(field)
{
  this->choose(faces);
}

void EdgeFields::choose(std::span<const Index> faces)
{
  const Index halfEdges = 3 * this->Field.mesh.numberOfTriangles();
  const double size = this->Field.mesh.longestEdgeLength();
  const bool hasCost = !this->Field.cost.empty();
  constexpr double none = std::numeric_limits<double>::infinity();
  const bool varies = hasCost && this->costVaries();
  std::vector<double> preference(halfEdges, 0.0);
  std::vector<std::uint8_t> lines(halfEdges, 0);
  std::vector<std::uint8_t> facesOf(halfEdges, 0);
  std::vector<bool> isOfSeed(halfEdges, false);
  this->Error.assign(halfEdges, 0.0F);
  std::vector<std::uint8_t> sources(hasCost ? halfEdges : 0, 0);
  std::vector<double> costOfSource(hasCost ? halfEdges : 0, none);
  std::vector<double> cheapest(hasCost ? halfEdges : 0, none);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    Interruption::checkAt(i);
    const Index face = faces[i];
    const FlatFace flat = this->Field.flat(face);
    const FaceField field = this->Field.inFace(face, flat);
    const bool isOfOneSign = this->Field.signOfFace(face) != 0;
    const double round = isOfOneSign ? std::min(field.roundError(), size) : size;
    for (int corner = 0; corner < 3; ++corner)
    {
      const Index edge = this->Field.edgeOf(3 * face + corner);
      preference[edge] += std::min(field.straightError(), size) - round;
      this->Error[edge] = std::max(this->Error[edge], static_cast<float>(round));
      isOfSeed[edge] = isOfSeed[edge] || (isOfOneSign && field.hasSource());
      facesOf[edge] = static_cast<std::uint8_t>(std::min(facesOf[edge] + 1, 2));
      if (isOfOneSign && field.hasLineAcross(corner))
      {
        lines[edge] = static_cast<std::uint8_t>(std::min(lines[edge] + 1, 2));
      }
      if (!hasCost)
      {
        continue;
      }
      cheapest[edge] = std::min(cheapest[edge], field.cost());
      if (isOfOneSign && field.flowsOut(corner))
      {
        sources[edge] = static_cast<std::uint8_t>(std::min(sources[edge] + 1, 2));
        costOfSource[edge] = field.cost();
      }
      if (isOfOneSign && field.isSeedOfVaryingCost())
      {
        this->addSeed(3 * face + corner, flat, field);
      }
    }
  }
  for (Index h = 0; h < halfEdges; ++h)
  {
    this->Error[h] = isOfSeed[h] ? 0.0F : this->Error[h];
  }
  this->IsRound.assign(halfEdges, false);
  this->HasLine.assign(halfEdges, false);
  this->Cost.assign(hasCost ? halfEdges : 0, 1.0);
  for (Index h = 0; h < halfEdges; ++h)
  {
    Interruption::checkAt(h);
    const Index edge = this->Field.edgeOf(h);
    this->IsRound[h] = preference[edge] >= 0.0;
    // Under costs that vary one face may look so by chance.
    this->HasLine[h] = lines[edge] > 0 && (!varies || lines[edge] == facesOf[edge]);
    if (hasCost && cheapest[edge] < none)
    {
      this->Cost[h] = sources[edge] == 1 ? costOfSource[edge] : cheapest[edge];
      this->IsRound[h] = this->IsRound[h] && !(varies && this->isBehindJump(h));
    }
  }
}

bool EdgeFields::costVaries() const
{
  const auto [least, most] = std::ranges::minmax(this->Field.cost);
  constexpr double same = 1e-12;
  return most - least > same * most;
}

void EdgeFields::addSeed(Index halfEdge, const FlatFace& flat, const FaceField& field)
{
  const Triangle& t = this->Field.mesh.triangle(EdgeTable::triangleOf(halfEdge));
  const Index corner = halfEdge % 3;
  PlanePoint a = flat.corners[(corner + 1) % 3];
  PlanePoint b = flat.corners[(corner + 2) % 3];
  if (t[(corner + 1) % 3] > t[(corner + 2) % 3])
  {
    std::swap(a, b);
  }
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const PlanePoint& source = field.source();
  const double along = ((source.x - a.x) * (b.x - a.x) + (source.y - a.y) * (b.y - a.y)) / length;
  this->Seeds.emplace(this->Field.edgeOf(halfEdge),
    SeedBeside{ along, orientation(a, b, source) / length, field.costAtSource() });
}

std::vector<double> EdgeFields::places(Index halfEdge, double level) const
{
  const auto [a, b] = this->Field.endsOf(halfEdge);
  const double first = this->Field.values[a];
  const double second = this->Field.values[b];
  const int sign = SurfaceField::signOf({ first, second });
  // What is below the level on the minus side is not below it by its distance, and the other way
  // round.
  const double above = std::nextafter(-level, std::numeric_limits<double>::infinity());
  const double distance = sign < 0 ? above : level;
  if (const auto seed = this->Seeds.empty() || sign == 0
        ? this->Seeds.end()
        : this->Seeds.find(this->Field.edgeOf(halfEdge));
      seed != this->Seeds.end())
  {
    return this->placesBesideSeed(
      halfEdge, seed->second, std::abs(first) < distance, std::abs(second) < distance, distance);
  }
  const double length = norm(this->Field.mesh.position(a) - this->Field.mesh.position(b));
  if (sign != 0 && this->HasLine[halfEdge])
  {
    return placesBesideLine({ std::abs(first), std::abs(first) < distance },
      { std::abs(second), std::abs(second) < distance }, distance);
  }
  if (sign == 0 || !this->IsRound[halfEdge])
  {
    return linearPlaces(first, second, level);
  }
  // As lengths they may be equal by rounding, so what is below the level is known before.
  const double cost = this->cost(halfEdge);
  return roundPlaces({ std::abs(first) / cost, std::abs(first) < distance },
    { std::abs(second) / cost, std::abs(second) < distance }, length, distance / cost,
    this->Error[this->Field.edgeOf(halfEdge)]);
}

bool EdgeFields::hasSource(Index halfEdge) const
{
  const auto [a, b] = this->Field.endsOf(halfEdge);
  const double length = norm(this->Field.mesh.position(a) - this->Field.mesh.position(b));
  // The source of a seed has its place to about this part of the edge.
  constexpr double exact = 1e-6;
  if (const auto seed = this->Seeds.find(this->Field.edgeOf(halfEdge)); seed != this->Seeds.end())
  {
    return std::abs(seed->second.away) <= exact * length;
  }
  const double sum = std::abs(this->Field.values[a]) + std::abs(this->Field.values[b]);
  return this->HasLine[halfEdge] ||
    (this->IsRound[halfEdge] && sum <= (1.0 + exact * exact) * length * this->cost(halfEdge));
}

bool EdgeFields::isBehindJump(Index halfEdge) const
{
  const auto [a, b] = this->Field.endsOf(halfEdge);
  const double length = norm(this->Field.mesh.position(a) - this->Field.mesh.position(b));
  const double sum = std::abs(this->Field.values[a]) + std::abs(this->Field.values[b]);
  constexpr double exact = 1e-6;
  return sum<this->Cost[halfEdge] * length&& this->Error[this->Field.edgeOf(halfEdge)]> exact *
    length;
}

std::vector<double> EdgeFields::placesBesideSeed(
  Index halfEdge, const SeedBeside& seed, bool firstIsBelow, bool secondIsBelow, double level) const
{
  const auto [a, b] = this->Field.endsOf(halfEdge);
  const double length = norm(this->Field.mesh.position(a) - this->Field.mesh.position(b));
  const double first = this->Field.cost[a];
  const double second = this->Field.cost[b];
  const auto above = [&](double place)
  {
    const double cost = first + place * (second - first);
    return 0.5 * (seed.costAtSeed + cost) * std::hypot(place * length - seed.along, seed.away) -
      level;
  };
  if (firstIsBelow != secondIsBelow)
  {
    return { rootBetween(above, firstIsBelow, 0.0, 1.0) };
  }
  const double least = leastPlace(above);
  if (firstIsBelow || !(above(least) < 0.0) || !(above(0.0) >= 0.0) || !(above(1.0) >= 0.0))
  {
    return {};
  }
  return { rootBetween(above, false, 0.0, least), rootBetween(above, true, least, 1.0) };
}

}
