// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// How windows start at points and lines.
#include "windows/WindowFront.h"

#include "mesh/Carriers.h"
#include "windows/LaidTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace geodesic
{
namespace
{

/** A line from @p a to @p b in the plane of a triangle. */
struct Segment
{
  Segment(const Vector3& a, const Vector3& b)
    : a(a)
    , b(b)
    , length(norm(b - a))
    , along((1.0 / this->length) * (b - a))
  {
  }

  double distanceTo(const Vector3& p) const
  {
    const double place = dot(p - this->a, this->along);
    return place <= 0.0       ? norm(p - this->a)
      : place >= this->length ? norm(p - this->b)
                              : std::min(norm(cross(p - this->a, this->along)),
                                  std::min(norm(p - this->a), norm(p - this->b)));
  }

  Vector3 a;
  Vector3 b;
  double length;
  Vector3 along;
};

}

void WindowFront::startAt(const SurfacePoint& point, double value, Index number)
{
  const Carriers carriers = carriersOf(this->Mesh, point);
  if (carriers.size() == 1)
  {
    this->reach(carriers[0], value, number, Arrival::fromSeed(number));
    if (this->Field.distance(carriers[0]) == value && !this->Work.isToSend[carriers[0]])
    {
      this->queueVertex(carriers[0]);
    }
    return;
  }
  const Vector3 position = this->Mesh.positionOf(point);
  for (const Index t : this->Mesh.trianglesWith({ carriers.begin(), carriers.end() }))
  {
    if (this->Passable.isClosed(t))
    {
      continue;
    }
    const Triangle& corners = this->Mesh.triangle(t);
    for (const Index corner : corners)
    {
      this->reach(corner, value + norm(this->Mesh.position(corner) - position), number,
        Arrival::fromSeed(number));
    }
    this->Work.starts.visitIn(t,
      [&](PathStarts::Start& start)
      {
        PathStarts::reach(
          start, value + norm(start.position - position), number, Arrival::fromSeed(number));
      });
    for (Index k = 0; k < 3 && this->Passable.contains(t) && !this->Edges.isRepeated(t); ++k)
    {
      // Only the edge that has the point is no way out of the triangle.
      if (carriers.contains(corners[k]))
      {
        this->sendThrough(3 * t + k, position, value, number);
      }
    }
    this->Crossed += 3;
  }
}

void WindowFront::startAlong(
  Index triangle, const SurfacePoint& from, const SurfacePoint& to, double value, Index number)
{
  const Vector3 a = this->Mesh.positionOf(from);
  const Vector3 b = this->Mesh.positionOf(to);
  if (this->Passable.isClosed(triangle) || a == b)
  {
    return;
  }
  const Segment segment(a, b);
  const Triangle& corners = this->Mesh.triangle(triangle);
  for (const Index corner : corners)
  {
    this->reach(corner, value + segment.distanceTo(this->Mesh.position(corner)), number, {});
  }
  this->Work.starts.visitIn(triangle,
    [&](PathStarts::Start& start)
    { PathStarts::reach(start, value + segment.distanceTo(start.position), number, {}); });
  this->Crossed += 3;
  if (!this->Passable.contains(triangle) || this->Edges.isRepeated(triangle))
  {
    return;
  }
  const Carriers fromCarriers = carriersOf(this->Mesh, from);
  const Carriers toCarriers = carriersOf(this->Mesh, to);
  for (Index k = 0; k < 3; ++k)
  {
    // A side that has the line is no way out of the triangle.
    if (fromCarriers.contains(corners[k]) || toCarriers.contains(corners[k]))
    {
      this->sendStraight(3 * triangle + k, a, b, value, number);
    }
  }
}

void WindowFront::sendStraight(
  Index halfEdge, const Vector3& a, const Vector3& b, double value, Index seed)
{
  if (!this->leadsOn(halfEdge))
  {
    return;
  }
  const LaidTriangle laid(this->Mesh, halfEdge);
  if (!(laid.length > 0.0))
  {
    return;
  }
  // In the plane of the half-edge, with the triangle above the edge.
  const PlanePoint from = placeBeside(this->Mesh, laid.lower, laid.higher, laid.length, a);
  const PlanePoint to = placeBeside(this->Mesh, laid.lower, laid.higher, laid.length, b);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double alongX = (to.x - from.x) / length;
  const double alongY = (to.y - from.y) / length;
  if (alongX == 0.0)
  {
    return;
  }
  // The front leaves the line at a right angle: down, through the edge.
  const double x = std::copysign(alongY, alongX * alongY);
  const double y = std::abs(alongX);
  const double below = from.x + from.y * (alongY / alongX);
  const double belowEnd = to.x + to.y * (alongY / alongX);
  const double first = std::max(0.0, std::min(below, belowEnd));
  const double last = std::min(laid.length, std::max(below, belowEnd));
  if (first < last)
  {
    const double offset = value + y * from.y - x * from.x;
    this->Offered.push_back({ first, last, x, y, offset, seed, true });
    this->cutOffered(this->targetOf(halfEdge, laid.lower, laid.higher, laid.length));
    this->letOfferedWait(halfEdge);
  }
}

void WindowFront::sendThrough(Index halfEdge, const Vector3& from, double distance, Index seed,
  float excess, const TurnSector::Part& part)
{
  if (!this->leadsOn(halfEdge))
  {
    return;
  }
  const LaidTriangle laid(this->Mesh, halfEdge);
  if (!(laid.length > 0.0))
  {
    return;
  }
  const PlanePoint source = placeBeside(this->Mesh, laid.lower, laid.higher, laid.length, from);
  const auto [first, last] = part.litOf(laid, source);
  if (first < last)
  {
    this->Offered.push_back({ first, last, source.x, source.y, distance, seed, false, excess });
    this->cutOffered(this->targetOf(halfEdge, laid.lower, laid.higher, laid.length));
  }
  this->letOfferedWait(halfEdge);
}

}
