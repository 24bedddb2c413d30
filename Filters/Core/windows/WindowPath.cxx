// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowPath.h"

#include "mesh/Carriers.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "solve/PassableTriangles.h"
#include "windows/Junctions.h"
#include "windows/LaidTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace geodesic
{
namespace
{

/** Distances that differ by less, relatively, are equal. */
constexpr double EqualDistances = 1e-9;

bool isIn(const Carriers& carriers, const Triangle& corners)
{
  return std::all_of(carriers.begin(), carriers.end(),
    [&](Index vertex)
    { return std::find(corners.begin(), corners.end(), vertex) != corners.end(); });
}

}

WindowPath::WindowPath(const TriangleMesh& mesh, const EdgeTable& edges,
  const PassableTriangles& passable, const Junctions& junctions, const DistanceField& field,
  std::span<const SurfacePoint> seeds, std::span<const Arrival> arrivals)
  : Mesh(mesh)
  , Edges(edges)
  , Passable(passable)
  , Divided(junctions)
  , Field(field)
  , Seeds(seeds)
  , Arrivals(arrivals)
{
}

std::vector<SurfacePoint> WindowPath::from(
  const SurfacePoint& start, double distance, Index seed, const Arrival& arrival)
{
  this->Path.assign(1, start);
  this->Seed = seed;
  this->Tolerance = EqualDistances * distance;
  Arrival next = arrival;
  while (next.kind != Arrival::Kind::FromSeed)
  {
    this->Turn = next.number;
    if (next.kind == Arrival::Kind::AcrossEdge && !this->follow(next))
    {
      return {};
    }
    if (this->Turn == NoIndex)
    {
      break;
    }
    // From turn to turn the distance falls, so that the loop ends.
    const double atTurn = this->Field.distance(this->Turn);
    if (!(atTurn < distance))
    {
      return {};
    }
    distance = atTurn;
    this->Path.push_back(this->Mesh.pointAtVertex(this->Turn));
    this->Seed = this->Field.nearestSeed(this->Turn);
    next = this->Arrivals[this->Turn];
  }
  const SurfacePoint& end = this->Seeds[this->Seed];
  if (this->Mesh.positionOf(this->Path.back()) != this->Mesh.positionOf(end))
  {
    this->Path.push_back(end);
  }
  return this->Path;
}

bool WindowPath::follow(const Arrival& arrival)
{
  this->Path.push_back(pointOn(this->Mesh, arrival.number, arrival.place));
  const double along = arrival.x - arrival.place;
  const double length = std::hypot(along, arrival.y);
  this->Open.clear();
  const double perLength = length > 0.0 ? 1.0 / length : 0.0;
  this->enter(arrival.number,
    { NoIndex, arrival.place, along * perLength, arrival.y * perLength, length,
      this->Path.size() });
  // Beyond the first wrong triangles at edges of many, there is no end of trying.
  std::size_t tries = 64 + 8 * static_cast<std::size_t>(this->Mesh.numberOfTriangles());
  while (!this->Open.empty() && tries-- > 0)
  {
    const Crossing at = this->Open.back();
    this->Open.pop_back();
    // The points before it are those of the crossing that it was found from.
    this->Path.resize(at.points);
    this->Path.back() = pointOn(this->Mesh, at.halfEdge, at.place);
    if (this->endsIn(at, arrival.offset))
    {
      return true;
    }
    if (this->isPossible(at, arrival.offset) && this->hasPassed(at, arrival.offset))
    {
      this->cross(at);
    }
  }
  return false;
}

void WindowPath::enter(Index halfEdge, const Crossing& at)
{
  for (Index other = this->Edges.next(halfEdge); other != halfEdge; other = this->Edges.next(other))
  {
    if (this->Passable.contains(EdgeTable::triangleOf(other)))
    {
      this->Open.push_back(at);
      this->Open.back().halfEdge = other;
    }
  }
}

bool WindowPath::endsIn(const Crossing& at, double offset)
{
  const LaidTriangle laid(this->Mesh, at.halfEdge);
  const double endX = at.place + at.left * at.x;
  const double endY = at.left * at.y;
  const std::array<std::array<double, 2>, 3> places{ { { 0.0, 0.0 }, { laid.length, 0.0 },
    { laid.x, laid.y } } };
  const std::array<Index, 3> corners{ laid.lower, laid.higher, laid.apex };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const double off = std::hypot(endX - places[i][0], endY - places[i][1]);
    if (off <= this->Tolerance &&
      std::abs(this->Field.distance(corners[i]) - offset) <= this->Tolerance)
    {
      this->Turn = corners[i];
      return true;
    }
  }
  const SurfacePoint& seed = this->Seeds[this->Seed];
  if (!isIn(carriersOf(this->Mesh, seed), this->Mesh.triangle(laid.triangle)))
  {
    return false;
  }
  const Vector3 here = this->Mesh.positionOf(this->Path.back());
  this->Turn = NoIndex;
  return std::abs(norm(this->Mesh.positionOf(seed) - here) - at.left) <= this->Tolerance;
}

void WindowPath::cross(const Crossing& at)
{
  const LaidTriangle laid(this->Mesh, at.halfEdge);
  // How far the line passes beside the apex. Where it meets it, or goes along a side, rounding
  // would tell which side it crosses: then the other one is tried as well, if this one fails.
  const double beside = at.x * laid.y - at.y * (laid.x - at.place);
  if (std::abs(beside) <= this->Tolerance)
  {
    this->crossTo(at, laid, beside >= 0.0);
    this->Path.resize(at.points);
  }
  this->crossTo(at, laid, beside < 0.0);
}

void WindowPath::crossTo(const Crossing& at, const LaidTriangle& laid, bool isLeft)
{
  const Index corner = isLeft ? laid.lower : laid.higher;
  const Index opposite = isLeft ? laid.higher : laid.lower;
  // All is measured from the corner, towards the other one and up.
  const double apexX = isLeft ? laid.x : laid.length - laid.x;
  const double place = isLeft ? at.place : laid.length - at.place;
  const double x = isLeft ? at.x : -at.x;
  const double side = std::hypot(apexX, laid.y);
  const double turn = apexX * at.y - laid.y * x;
  const double part = turn > 0.0 ? std::clamp(place * at.y / turn, 0.0, 1.0) : 0.0;
  const double length = std::hypot(part * apexX - place, part * laid.y);
  if (!(side > 0.0) || length > at.left + this->Tolerance)
  {
    return;
  }
  const Index halfEdge = laid.halfEdgeOpposite(this->Mesh, opposite);
  const bool isTurned = laid.apex < corner;
  const double along = (x * apexX + at.y * laid.y) / side;
  const double onSide = part * side;
  const double placeOnSide = isTurned ? side - onSide : onSide;
  this->Path.push_back(pointOn(this->Mesh, halfEdge, placeOnSide));
  this->enter(halfEdge,
    { NoIndex, placeOnSide, isTurned ? -along : along, std::max(0.0, turn / side), at.left - length,
      this->Path.size() });
}

bool WindowPath::isPossible(const Crossing& at, double offset) const
{
  const LaidTriangle laid(this->Mesh, at.halfEdge);
  const double distance = offset + at.left;
  const auto agrees = [&](Index vertex, double along)
  {
    const double known = this->Field.distance(vertex);
    return known == DistanceField::Unreached ||
      std::abs(known - distance) <= along + this->Tolerance;
  };
  return agrees(laid.lower, at.place) && agrees(laid.higher, laid.length - at.place);
}

bool WindowPath::hasPassed(const Crossing& at, double offset) const
{
  const std::span<const Window> windows = this->Divided.passedAt(this->Edges.first(at.halfEdge));
  auto window = std::partition_point(windows.begin(), windows.end(),
    [&](const Window& before) { return before.last < at.place - this->Tolerance; });
  for (; window != windows.end() && window->first <= at.place + this->Tolerance; ++window)
  {
    if (std::abs(window->offset - offset) <= this->Tolerance &&
      std::abs(window->x - at.place - at.left * at.x) <= this->Tolerance &&
      std::abs(window->y - at.left * at.y) <= this->Tolerance)
    {
      return true;
    }
  }
  return windows.empty();
}

}
