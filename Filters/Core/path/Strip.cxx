// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/Strip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace geodesic
{
namespace
{

/** 1 / sqrt(x). What is laid flat has its own length but for rounding, which takes no root: each
 * face waits for the one before. */
double inverseRoot(double x)
{
  const double over = x - 1.0;
  constexpr double rounding = 1e-9;
  return std::abs(over) < rounding ? 1.0 - 0.5 * over : 1.0 / std::sqrt(x);
}

/** The place of a corner opposite to the edge by which a face is entered. @param side 1 for the
 * face itself, -1 for the face before it */
PlanePoint beyond(const TriangleMesh& mesh, const StripFace& face, Index corner, double side)
{
  const Portal& flat = face.entry;
  const Vector3& left = mesh.position(face.left);
  const Vector3 edge = mesh.position(face.right) - left;
  const Vector3 toCorner = mesh.position(corner) - left;
  const PlanePoint flatEdge = flat.right - flat.left;
  const double square = dot(edge, edge);
  const double inverse = 1.0 / square;
  const double stretch = (flatEdge.x * flatEdge.x + flatEdge.y * flatEdge.y) * inverse;
  if (!(stretch > 0.0))
  {
    // Both ends are one point, through which every path goes. So any direction will do.
    return { flat.left.x, flat.left.y + side * norm(toCorner) };
  }
  const double shrink = inverseRoot(stretch);
  const double x = dot(toCorner, edge) * inverse * shrink;
  const double h = side * norm(cross(toCorner, edge)) * inverse * shrink;
  return { flat.left.x + x * flatEdge.x - h * flatEdge.y,
    flat.left.y + x * flatEdge.y + h * flatEdge.x };
}

PlanePoint place(const PathPoint& point, const StripFace& face, Index apex, const PlanePoint& flat)
{
  PlanePoint place{ 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    const PlanePoint& corner = point.corners[i] == apex ? flat
      : point.corners[i] == face.left                   ? face.entry.left
                                                        : face.entry.right;
    place.x += point.weights[i] * corner.x;
    place.y += point.weights[i] * corner.y;
  }
  return place;
}

/** A motion of the plane, which mirrors it where the two edges that it is made from are seen from
 * different sides. */
class Motion
{
public:
  /** @param from, to  one edge, entered from the same side, in two planes */
  Motion(const StripFace& from, const StripFace& to)
    : Mirrors(from.left != to.left)
  {
    const Portal portal = this->labelled(from.entry);
    this->From = portal.left;
    this->To = to.entry.left;
    const PlanePoint a = portal.right - portal.left;
    const PlanePoint b = to.entry.right - to.entry.left;
    const PlanePoint turn{ b.x * a.x + b.y * a.y, b.y * a.x - b.x * a.y };
    const double size = std::sqrt(turn.x * turn.x + turn.y * turn.y);
    if (size > 0.0)
    {
      this->Turn = { turn.x / size, turn.y / size };
    }
  }

  StripFace operator()(const StripFace& face) const
  {
    const Portal portal = this->labelled(face.entry);
    return { this->Mirrors ? face.right : face.left, this->Mirrors ? face.left : face.right,
      face.apex, { this->moved(portal.left), this->moved(portal.right) } };
  }

private:
  /** The edge, mirrored if need be. */
  Portal labelled(const Portal& portal) const
  {
    return this->Mirrors
      ? Portal{ { portal.right.x, -portal.right.y }, { portal.left.x, -portal.left.y } }
      : portal;
  }
  PlanePoint moved(const PlanePoint& point) const
  {
    const PlanePoint away = point - this->From;
    return { this->To.x + this->Turn.x * away.x - this->Turn.y * away.y,
      this->To.y + this->Turn.y * away.x + this->Turn.x * away.y };
  }

  bool Mirrors;
  PlanePoint From;
  PlanePoint To;
  PlanePoint Turn{ 1.0, 0.0 };
};

/** Appends the face that lies beyond the edge from @p a to @p b of the last one. @return whether it
 * is the last one now; else the strip has become shorter */
bool enterFace(const TriangleMesh& mesh, Strip& strip, Index a, Index b, Index apex)
{
  if (strip.size() > 1 && strip.back().isEnteredBy(a, b))
  {
    strip.pop_back();
    if (strip.back().hasCorner(apex))
    {
      return false;
    }
  }
  if (strip.size() == 1)
  {
    strip.push_back({ a, b, apex, { {}, { norm(mesh.position(b) - mesh.position(a)), 0.0 } } });
    return true;
  }
  const StripFace& last = strip.back();
  const Index side = a == last.left || a == last.right ? a : b;
  strip.push_back(faceBeyond(last, flatApex(mesh, last), side, apex));
  return true;
}

}

void appendFace(const TriangleMesh& mesh, Strip& strip, const Triangle& face)
{
  if (strip.empty())
  {
    strip.push_back({ face[0], face[1], face[2] });
    return;
  }
  const StripFace& last = strip.back();
  const auto* apex =
    std::find_if(face.begin(), face.end(), [&](Index corner) { return !last.hasCorner(corner); });
  if (apex != face.end())
  {
    const auto i = apex - face.begin();
    enterFace(mesh, strip, face[(i + 1) % 3], face[(i + 2) % 3], *apex);
  }
}

void appendStrip(const TriangleMesh& mesh, Strip& strip, const Strip& other)
{
  if (other.empty())
  {
    return;
  }
  appendFace(mesh, strip, other[0].corners());
  auto face = other.begin() + 1;
  while (face != other.end() && !enterFace(mesh, strip, face->left, face->right, face->apex))
  {
    ++face;
  }
  if (face == other.end())
  {
    return;
  }
  // From here on nothing turns back.
  const Motion motion(*face, strip.back());
  std::transform(face + 1, other.end(), std::back_inserter(strip), motion);
}

PlanePoint flatApex(const TriangleMesh& mesh, const StripFace& face)
{
  return beyond(mesh, face, face.apex, 1.0);
}

PlanePoint flatInFirst(
  const TriangleMesh& mesh, std::span<const StripFace> strip, const PathPoint& point)
{
  const StripFace& second = strip[1];
  const Triangle corners = strip[0].corners();
  const Index apex = *std::find_if(corners.begin(), corners.end(),
    [&](Index corner) { return corner != second.left && corner != second.right; });
  return place(point, second, apex, beyond(mesh, second, apex, -1.0));
}

PlanePoint flatInLast(
  const TriangleMesh& mesh, std::span<const StripFace> strip, const PathPoint& point)
{
  const StripFace& last = strip.back();
  return place(point, last, last.apex, flatApex(mesh, last));
}

}
