// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/StripFunnel.h"

#include "base/PlanePoint.h"

#include <cmath>
#include <span>

namespace geodesic
{
namespace
{

bool isSame(const PlanePoint& a, const PlanePoint& b)
{
  return a.x == b.x && a.y == b.y;
}

bool hasCorner(const Triangle& face, Index vertex)
{
  return face[0] == vertex || face[1] == vertex || face[2] == vertex;
}

/** The edge between two faces of the strip. Left and right are as seen on a walk along the strip.
 */
struct Portal
{
  Index left;
  Index right;
  PlanePoint flatLeft;
  PlanePoint flatRight;
};

/** The two corners that consecutive faces share, and the other corner of each. */
struct SharedEdge
{
  Index first;
  Index second;
  Index before;
  Index after;
};

SharedEdge sharedEdge(const Triangle& face, const Triangle& next)
{
  SharedEdge edge{ NoIndex, NoIndex, NoIndex, NoIndex };
  for (Index corner : face)
  {
    if (!hasCorner(next, corner))
    {
      edge.before = corner;
    }
    else
    {
      (edge.first == NoIndex ? edge.first : edge.second) = corner;
    }
  }
  for (Index corner : next)
  {
    edge.after = hasCorner(face, corner) ? edge.after : corner;
  }
  return edge;
}

/** Lays a strip flat, face by face. */
class Unfolding
{
public:
  Unfolding(const WeightedMesh& surface, std::span<const Triangle> faces)
    : Mesh(surface.mesh())
  {
    this->Portals.reserve(faces.size());
    for (std::size_t i = 0; i + 1 < faces.size(); ++i)
    {
      surface.countSteps(1);
      const SharedEdge edge = sharedEdge(faces[i], faces[i + 1]);
      if (i == 0)
      {
        const double length =
          norm(this->Mesh.position(edge.second) - this->Mesh.position(edge.first));
        this->Portals.push_back({ edge.first, edge.second, { 0.0, 0.0 }, { length, 0.0 } });
        this->First = this->apex(this->Portals[0], edge.before, -1.0);
        this->FirstApex = edge.before;
      }
      else
      {
        // One end of the portal stays, the other one becomes the new corner of the last face.
        Portal portal = this->Portals.back();
        const bool leftStays = portal.left == edge.first || portal.left == edge.second;
        (leftStays ? portal.right : portal.left) = this->LastApex;
        (leftStays ? portal.flatRight : portal.flatLeft) = this->Last;
        this->Portals.push_back(portal);
      }
      this->LastApex = edge.after;
      this->Last = this->apex(this->Portals.back(), edge.after, 1.0);
    }
  }

  std::span<const Portal> portals() const { return this->Portals; }
  PlanePoint start(const PathPoint& point) const
  {
    return this->place(point, this->Portals.front(), this->FirstApex, this->First);
  }
  PlanePoint end(const PathPoint& point) const
  {
    return this->place(point, this->Portals.back(), this->LastApex, this->Last);
  }

private:
  /** The place of a face's corner opposite to a portal. @param side 1 for the face beyond the
   * portal, -1 for the face before it */
  PlanePoint apex(const Portal& portal, Index corner, double side) const
  {
    const Vector3 edge = this->Mesh.position(portal.right) - this->Mesh.position(portal.left);
    const Vector3 toCorner = this->Mesh.position(corner) - this->Mesh.position(portal.left);
    const double length = norm(edge);
    const PlanePoint flatEdge{ portal.flatRight.x - portal.flatLeft.x,
      portal.flatRight.y - portal.flatLeft.y };
    const double flatLength = std::sqrt(flatEdge.x * flatEdge.x + flatEdge.y * flatEdge.y);
    if (!(length > 0.0 && flatLength > 0.0))
    {
      // Both ends are one point, through which every path goes. So any direction will do.
      return { portal.flatLeft.x, portal.flatLeft.y + side * norm(toCorner) };
    }
    const PlanePoint along{ flatEdge.x / flatLength, flatEdge.y / flatLength };
    const double x = dot(toCorner, edge) / length;
    const double h = side * norm(cross(toCorner, edge)) / length;
    return { portal.flatLeft.x + x * along.x - h * along.y,
      portal.flatLeft.y + x * along.y + h * along.x };
  }

  static PlanePoint place(
    const PathPoint& point, const Portal& portal, Index apex, const PlanePoint& flatApex)
  {
    PlanePoint flat{ 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      const PlanePoint& corner = point.corners[i] == apex ? flatApex
        : point.corners[i] == portal.left                 ? portal.flatLeft
                                                          : portal.flatRight;
      flat.x += point.weights[i] * corner.x;
      flat.y += point.weights[i] * corner.y;
    }
    return flat;
  }

  const TriangleMesh& Mesh;
  std::vector<Portal> Portals;
  Index FirstApex = NoIndex;
  Index LastApex = NoIndex;
  PlanePoint First{};
  PlanePoint Last{};
};

/** A vertex at which the shortest path bends. */
struct Bend
{
  Index vertex;
  PlanePoint flat;
  /** The number of a portal with this vertex as an end. */
  std::size_t portal;
};

/**
 * The bends of the shortest path through the portals. A vertex that the path only touches counts as
 * a bend, because the path may be shorter on the vertex's other side.
 */
std::vector<Bend> bendsThrough(const WeightedMesh& surface, std::span<const Portal> portals,
  const PlanePoint& start, const PlanePoint& end)
{
  std::vector<Bend> bends;
  PlanePoint apex = start;
  Bend left{ NoIndex, start, 0 };
  Bend right = left;
  for (std::size_t i = 0; i <= portals.size(); ++i)
  {
    surface.countSteps(1);
    const bool isEnd = i == portals.size();
    const Bend newLeft{ isEnd ? NoIndex : portals[i].left, isEnd ? end : portals[i].flatLeft, i };
    const Bend newRight{ isEnd ? NoIndex : portals[i].right, isEnd ? end : portals[i].flatRight,
      i };
    const bool isOpen = !isSame(apex, left.flat) && !isSame(apex, right.flat);
    const bool narrowsLeft = orientation(apex, left.flat, newLeft.flat) <= 0.0;
    const bool narrowsRight = orientation(apex, right.flat, newRight.flat) >= 0.0;
    const bool passesLeft = isOpen && narrowsRight && newRight.vertex != right.vertex &&
      orientation(apex, left.flat, newRight.flat) >= 0.0;
    const bool passesRight = isOpen && narrowsLeft && newLeft.vertex != left.vertex &&
      orientation(apex, right.flat, newLeft.flat) <= 0.0;
    if (passesLeft || passesRight)
    {
      const Bend bend = passesLeft ? left : right;
      bends.push_back(bend);
      apex = bend.flat;
      left = right = bend;
      i = bend.portal;
      continue;
    }
    left = narrowsLeft ? newLeft : left;
    right = narrowsRight ? newRight : right;
  }
  return bends;
}

/** The part of a strip that a piece crosses: faces first to last - 1. */
struct Range
{
  std::size_t first;
  std::size_t last;
};

bool liesOnEdge(const PathPoint& point, const Triangle& face, const Triangle& next)
{
  return liesIn(point, face) && liesIn(point, next);
}

/** The range without faces at its ends in which the path has no length: those that it only touches
 * at
 * @p start or @p end. */
Range trimmed(
  std::span<const Triangle> faces, Range range, const PathPoint& start, const PathPoint& end)
{
  while (
    range.last - range.first > 1 && liesOnEdge(start, faces[range.first], faces[range.first + 1]))
  {
    ++range.first;
  }
  while (
    range.last - range.first > 1 && liesOnEdge(end, faces[range.last - 2], faces[range.last - 1]))
  {
    --range.last;
  }
  return range;
}

/** A point of an edge counts as the edge's end if it is nearer to it than this fraction. */
constexpr double VertexFraction = 1e-12;

PathPoint crossingOf(const Portal& portal, const PlanePoint& start, const PlanePoint& end)
{
  const double left = orientation(start, end, portal.flatLeft);
  const double right = orientation(start, end, portal.flatRight);
  const double fraction = left == right ? 0.0 : std::clamp(left / (left - right), 0.0, 1.0);
  if (fraction < VertexFraction)
  {
    return PathPoint::atVertex(portal.left);
  }
  if (fraction > 1.0 - VertexFraction)
  {
    return PathPoint::atVertex(portal.right);
  }
  return PathPoint::onEdge(portal.left, portal.right, fraction);
}

}

void appendFace(std::vector<Triangle>& faces, const Triangle& face)
{
  const auto isFace = [&](const Triangle& other)
  { return hasCorner(other, face[0]) && hasCorner(other, face[1]) && hasCorner(other, face[2]); };
  if (!faces.empty() && isFace(faces.back()))
  {
    return;
  }
  if (faces.size() > 1 && isFace(faces[faces.size() - 2]))
  {
    faces.pop_back();
    return;
  }
  faces.push_back(face);
}

std::vector<StraightPiece> shortestInStrip(const WeightedMesh& surface, const PathPoint& start,
  const PathPoint& end, const std::vector<Triangle>& faces)
{
  const TriangleMesh& mesh = surface.mesh();
  const Range whole = trimmed(faces, { 0, faces.size() }, start, end);
  const std::span<const Triangle> strip(faces.data() + whole.first, whole.last - whole.first);
  if (strip.size() == 1)
  {
    if (isSameVertex(start, end))
    {
      return {};
    }
    return { { start, end, { strip[0] }, {}, norm(end.position(mesh) - start.position(mesh)) } };
  }
  const Unfolding unfolding(surface, strip);
  const std::span<const Portal> portals = unfolding.portals();
  const PlanePoint flatStart = unfolding.start(start);
  const PlanePoint flatEnd = unfolding.end(end);

  std::vector<StraightPiece> pieces;
  PathPoint from = start;
  PlanePoint flatFrom = flatStart;
  std::size_t firstFace = 0;
  const auto addPiece = [&](const PathPoint& to, const PlanePoint& flatTo, std::size_t lastFace)
  {
    if (isSameVertex(from, to))
    {
      return;
    }
    const Range range = trimmed(strip, { firstFace, lastFace }, from, to);
    StraightPiece piece{ from, to,
      { strip.begin() + static_cast<std::ptrdiff_t>(range.first),
        strip.begin() + static_cast<std::ptrdiff_t>(range.last) },
      {}, std::hypot(flatTo.x - flatFrom.x, flatTo.y - flatFrom.y) };
    piece.crossings.reserve(range.last - range.first - 1);
    for (std::size_t i = range.first; i + 1 < range.last; ++i)
    {
      surface.countSteps(1);
      piece.crossings.push_back(crossingOf(portals[i], flatFrom, flatTo));
    }
    pieces.push_back(std::move(piece));
    from = to;
    flatFrom = flatTo;
    firstFace = lastFace;
  };
  for (const Bend& bend : bendsThrough(surface, portals, flatStart, flatEnd))
  {
    addPiece(PathPoint::atVertex(bend.vertex), bend.flat, bend.portal + 1);
  }
  addPiece(end, flatEnd, strip.size());
  return pieces;
}

}
