// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/TurnSector.h"

#include "base/PlanePoint.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "windows/Arrival.h"
#include "windows/LaidTriangle.h"
#include "windows/WindowLine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace geodesic
{
namespace
{

/** By how many radians the sector is wider than need be. It is to be above all rounding, and costs
 * nothing to speak of. */
constexpr double LeastSpare = 1e-4;
/** Rounding of a place on an edge, in parts of the distance there. */
constexpr double PlaceRounding = 1e-10;
/** With more to spare than that, paths may go anywhere. */
constexpr double MostSpare = 0.1;

double cornerAngle(const Vector3& a, const Vector3& b)
{
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/** From where a path arrives, as seen from a vertex: between the sides to two vertices of a
 * triangle, or along the side to one. */
struct Direction
{
  Index triangle = NoIndex;
  std::array<Index, 2> sides;
  std::array<double, 2> angles{ 0.0, 0.0 };
  /** By how many radians it may be wrong. */
  double spare = 0.0;
};

Direction directionAcross(
  const TriangleMesh& mesh, Index vertex, const Arrival& arrival, double distance)
{
  const Index triangle = EdgeTable::triangleOf(arrival.number);
  const Triangle& corners = mesh.triangle(triangle);
  const Index k = arrival.number % 3;
  const auto [lower, higher] = std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]);
  const Vector3& origin = mesh.position(vertex);
  const Vector3 toLower = mesh.position(lower) - origin;
  const Vector3 toHigher = mesh.position(higher) - origin;
  const double length = edgeLength(mesh, lower, higher);
  const Vector3 toPlace = toLower + (arrival.place / length) * (toHigher - toLower);
  return { triangle, { lower, higher },
    { cornerAngle(toLower, toPlace), cornerAngle(toHigher, toPlace) },
    LeastSpare + (LineMiss * length + PlaceRounding * distance) / norm(toPlace) };
}

Direction directionAlong(const TriangleMesh& mesh, const EdgeTable& edges, Index vertex,
  const Arrival& arrival, double distance)
{
  Direction found;
  for (const Index t : edges.trianglesAt(vertex))
  {
    const Triangle& corners = mesh.triangle(t);
    if (std::find(corners.begin(), corners.end(), arrival.number) != corners.end())
    {
      found.triangle = t;
      break;
    }
  }
  found.sides = { arrival.number, arrival.number };
  found.spare = LeastSpare + PlaceRounding * distance / edgeLength(mesh, vertex, arrival.number);
  return found;
}

/** The half-edge of a triangle's side between two of its corners. */
Index halfEdgeBetween(const TriangleMesh& mesh, Index triangle, Index a, Index b)
{
  const Triangle& corners = mesh.triangle(triangle);
  const Index k = corners[0] != a && corners[0] != b ? 0
    : corners[1] != a && corners[1] != b             ? 1
                                                     : 2;
  return 3 * triangle + k;
}

}

TurnSector::Part::Lit TurnSector::Part::litOf(
  const LaidTriangle& laid, const PlanePoint& source) const
{
  const bool isTurned = this->side != laid.lower;
  const double x = isTurned ? laid.length - source.x : source.x;
  // Too flat a triangle says nothing of angles.
  constexpr double flat = 1e-9;
  if (this->side == NoIndex || !(source.y > flat * (laid.length + std::abs(x))))
  {
    return { 0.0, laid.length };
  }
  // Counted from the perpendicular to the edge.
  const double toSide = std::atan2(-x, source.y);
  const auto placeOf = [&](double angle)
  {
    return toSide + angle < 0.5 * std::numbers::pi
      ? std::clamp(x + source.y * std::tan(toSide + angle), 0.0, laid.length)
      : laid.length;
  };
  const double from = this->first > 0.0 ? placeOf(this->first) : 0.0;
  const double to = placeOf(this->last);
  return { isTurned ? laid.length - to : from, isTurned ? laid.length - from : to };
}

bool TurnSector::find(const TriangleMesh& mesh, const EdgeTable& edges, Index vertex,
  const Arrival& arrival, double distance)
{
  this->Parts.clear();
  if (arrival.kind == Arrival::Kind::FromSeed)
  {
    return false;
  }
  const bool isAcross = arrival.kind == Arrival::Kind::AcrossEdge;
  const Direction from = isAcross ? directionAcross(mesh, vertex, arrival, distance)
                                  : directionAlong(mesh, edges, vertex, arrival, distance);
  const double half = std::numbers::pi - from.spare;
  if (from.triangle == NoIndex || !(from.spare < MostSpare) || from.angles[0] > half ||
    from.angles[1] > half)
  {
    return false;
  }
  // The triangle that the path comes through has no part; beside an edge it is one of the others.
  std::size_t visited = isAcross ? 1 : 0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Index side = from.sides[i];
    const Index inside = halfEdgeBetween(mesh, from.triangle, vertex, side);
    const Index outside = edges.next(inside);
    const bool isFirstAlong = !isAcross && i == 0;
    if (edges.isOfMany(inside))
    {
      return false;
    }
    if (!isFirstAlong && outside == inside)
    {
      continue;
    }
    const Index next = isFirstAlong ? from.triangle : EdgeTable::triangleOf(outside);
    const std::size_t begin = this->Parts.size();
    const End end = this->goRound(mesh, edges, vertex, next, side, from.angles[i], from.triangle);
    visited += this->Visited;
    if (end == End::Unknown)
    {
      return false;
    }
    if (end == End::FullTurn)
    {
      this->cut(begin, half, this->Angle + from.angles[1 - i] - half);
      break;
    }
    this->cut(begin, half, this->Angle);
  }
  return visited == edges.trianglesAt(vertex).size();
}

TurnSector::End TurnSector::goRound(const TriangleMesh& mesh, const EdgeTable& edges, Index vertex,
  Index triangle, Index side, double angle, Index end)
{
  const Vector3& origin = mesh.position(vertex);
  this->Angle = angle;
  this->Visited = 0;
  while (true)
  {
    const Triangle& corners = mesh.triangle(triangle);
    const Index k = corners[0] == side ? 0 : corners[1] == side ? 1 : 2;
    const Index next = corners[0] + corners[1] + corners[2] - side - vertex;
    const Vector3 toSide = mesh.position(side) - origin;
    const Vector3 toNext = mesh.position(next) - origin;
    if (!(dot(toSide, toSide) > 0.0 && dot(toNext, toNext) > 0.0))
    {
      return End::Unknown;
    }
    const double from = this->Angle;
    this->Angle += cornerAngle(toSide, toNext);
    this->Parts.push_back({ triangle, side, from, this->Angle });
    ++this->Visited;
    const Index out = 3 * triangle + k;
    const Index other = edges.next(out);
    if (edges.isOfMany(out) || other == out)
    {
      return edges.isOfMany(out) ? End::Unknown : End::Border;
    }
    triangle = EdgeTable::triangleOf(other);
    side = next;
    if (triangle == end)
    {
      return End::FullTurn;
    }
  }
}

void TurnSector::cut(std::size_t begin, double first, double last)
{
  std::size_t kept = begin;
  for (std::size_t i = begin; i < this->Parts.size(); ++i)
  {
    Part part = this->Parts[i];
    if (part.last >= first && part.first <= last)
    {
      const double from = part.first;
      part.first = std::max(0.0, first - from);
      part.last = part.last > last ? last - from : std::numbers::pi;
      this->Parts[kept++] = part;
    }
  }
  this->Parts.resize(kept);
}

}
