// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/StripFunnel.h"

#include "base/PlanePoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace geodesic
{
namespace
{

PlanePoint operator-(const PlanePoint& a, const PlanePoint& b)
{
  return { a.x - b.x, a.y - b.y };
}

double dot(const PlanePoint& a, const PlanePoint& b)
{
  return a.x * b.x + a.y * b.y;
}

/** Lays a strip of at least two faces flat, face by face. */
class Unfolding
{
public:
  Unfolding(const WeightedMesh& surface, std::span<const StripFace> strip)
    : Mesh(surface.mesh())
    , Faces(strip)
  {
    surface.countSteps(strip.size());
    this->Portals.reserve(strip.size() - 1);
    const auto& [left, right, apex, crossing] = strip[1];
    const double length = norm(this->Mesh.position(right) - this->Mesh.position(left));
    this->Portals.push_back({ { 0.0, 0.0 }, { length, 0.0 } });
    for (const Index corner : strip[0].corners())
    {
      this->FirstApex = strip[1].isEnteredBy(corner, left) || strip[1].isEnteredBy(corner, right)
        ? this->FirstApex
        : corner;
    }
    this->First = this->beyond(strip[1], this->FirstApex, -1.0);
    for (std::size_t i = 2; i < strip.size(); ++i)
    {
      // One end of the edge stays, the other one becomes the corner of the last face.
      const PlanePoint corner = this->beyond(strip[i - 1], strip[i - 1].apex, 1.0);
      const Portal& last = this->Portals.back();
      this->Portals.push_back(strip[i].left == strip[i - 1].left ? Portal{ last.left, corner }
                                                                 : Portal{ corner, last.right });
    }
    this->Last = this->beyond(strip.back(), strip.back().apex, 1.0);
  }

  PlanePoint start(const PathPoint& point) const
  {
    return place(point, this->Faces[1], this->Portals.front(), this->FirstApex, this->First);
  }
  PlanePoint end(const PathPoint& point) const
  {
    const StripFace& face = this->Faces.back();
    return place(point, face, this->Portals.back(), face.apex, this->Last);
  }
  /** The edges by which the second and all later faces are entered. */
  std::vector<Portal> takePortals() { return std::move(this->Portals); }

private:
  /** The place of a corner opposite to the last edge laid flat. @param side 1 for the face beyond
   * the edge, -1 for the face before it */
  PlanePoint beyond(const StripFace& face, Index corner, double side) const
  {
    const Portal& flat = this->Portals.back();
    const Vector3& left = this->Mesh.position(face.left);
    const Vector3 edge = this->Mesh.position(face.right) - left;
    const Vector3 toCorner = this->Mesh.position(corner) - left;
    const PlanePoint flatEdge = flat.right - flat.left;
    const double square = dot(edge, edge);
    const double inverse = 1.0 / square;
    const double stretch = geodesic::dot(flatEdge, flatEdge) * inverse;
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

  /** 1 / sqrt(x). What is laid flat has its own length but for rounding, which takes no root: each
   * face waits for the one before. */
  static double inverseRoot(double x)
  {
    const double over = x - 1.0;
    constexpr double rounding = 1e-9;
    return std::abs(over) < rounding ? 1.0 - 0.5 * over : 1.0 / std::sqrt(x);
  }

  static PlanePoint place(const PathPoint& point, const StripFace& face, const Portal& portal,
    Index apex, const PlanePoint& flatApex)
  {
    PlanePoint flat{ 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      const PlanePoint& corner = point.corners[i] == apex ? flatApex
        : point.corners[i] == face.left                   ? portal.left
                                                          : portal.right;
      flat.x += point.weights[i] * corner.x;
      flat.y += point.weights[i] * corner.y;
    }
    return flat;
  }

  const TriangleMesh& Mesh;
  std::span<const StripFace> Faces;
  std::vector<Portal> Portals;
  Index FirstApex = NoIndex;
  PlanePoint First{};
  PlanePoint Last{};
};

/** Whether a point lies on the edge by which a face is entered. */
bool liesOnEntry(const PathPoint& point, const StripFace& face)
{
  for (const Index vertex : point.carriers())
  {
    if (vertex != face.left && vertex != face.right)
    {
      return false;
    }
  }
  return true;
}

/** The part of a strip without faces at its ends in which a path has no length: those that it only
 * touches at @p start or @p end. */
std::span<const StripFace> trimmed(
  std::span<const StripFace> strip, const PathPoint& start, const PathPoint& end)
{
  while (strip.size() > 1 && liesOnEntry(start, strip[1]))
  {
    strip = strip.subspan(1);
  }
  while (strip.size() > 1 && liesOnEntry(end, strip.back()))
  {
    strip = strip.first(strip.size() - 1);
  }
  return strip;
}

double crossingOf(const Portal& portal, const PlanePoint& start, const PlanePoint& end)
{
  const double left = orientation(start, end, portal.left);
  const double right = orientation(start, end, portal.right);
  return left == right ? 0.0 : std::clamp(left / (left - right), 0.0, 1.0);
}

double distanceBetween(const PlanePoint& a, const PlanePoint& b)
{
  return std::sqrt(dot(b - a, b - a));
}

}

/**
 * The shortest paths from the last certain bend to both ends of an edge: they turn to the outside
 * at each vertex of their chain. A vertex that a path only touches counts as a bend, because the
 * path may be shorter on the vertex's other side.
 */
class StripFunnel::Funnel
{
public:
  enum Side : std::size_t
  {
    Left,
    Right
  };

  /** @param faces at most so many will have an end added */
  Funnel(const PlanePoint& start, std::size_t faces)
    : Apex(start)
  {
    this->Chains[Left].points.reserve(faces);
    this->Chains[Right].points.reserve(faces);
  }

  /** Adds the next end of an edge on a side. Amortised time O(1). */
  void add(Side side, const Bend& end)
  {
    Chain& own = this->Chains[side];
    const double toLeft = side == Right ? 1.0 : -1.0;
    while (!own.isEmpty() && isCutOff(own.beforeLast(this->Apex), own.last(), end.flat, toLeft))
    {
      own.points.pop_back();
    }
    if (own.isEmpty())
    {
      Chain& other = this->Chains[1 - side];
      while (!other.isEmpty() && isPassed(this->Apex, other.first(), end.flat, toLeft))
      {
        this->Bends.push_back(other.points[other.begin++]);
        this->Apex = this->Bends.back().flat;
      }
    }
    own.points.push_back(end);
  }

  /** All bends of the path to a point of the last face. */
  std::vector<Bend> bendsTo(const PlanePoint& end)
  {
    this->add(Right, { NoIndex, end, 0 });
    const Chain& chain = this->Chains[Right];
    this->Bends.insert(this->Bends.end(),
      chain.points.begin() + static_cast<std::ptrdiff_t>(chain.begin), chain.points.end() - 1);
    return std::move(this->Bends);
  }

private:
  struct Chain
  {
    std::vector<Bend> points;
    std::size_t begin = 0;

    bool isEmpty() const { return this->begin == this->points.size(); }
    const PlanePoint& first() const { return this->points[this->begin].flat; }
    const PlanePoint& last() const { return this->points.back().flat; }
    const PlanePoint& beforeLast(const PlanePoint& apex) const
    {
      const std::size_t size = this->points.size();
      return size - this->begin > 1 ? this->points[size - 2].flat : apex;
    }
  };

  /** Whether a path from @p a to @p next leaves @p b outside, where it comes after @p a.
   * @param toLeft 1 if the inside is on the left, -1 if on the right */
  static bool isCutOff(
    const PlanePoint& a, const PlanePoint& b, const PlanePoint& next, double toLeft)
  {
    const double turn = toLeft * orientation(a, b, next);
    return turn > 0.0 || (turn == 0.0 && dot(b - a, next - b) < 0.0);
  }
  /** Whether a path from @p a to @p next has to go round @p b on the other side, or touches it. */
  static bool isPassed(
    const PlanePoint& a, const PlanePoint& b, const PlanePoint& next, double toLeft)
  {
    const double turn = toLeft * orientation(a, b, next);
    return turn > 0.0 || (turn == 0.0 && dot(b - a, next - b) >= 0.0);
  }

  PlanePoint Apex;
  std::array<Chain, 2> Chains;
  std::vector<Bend> Bends;
};

StripFunnel::StripFunnel(
  const WeightedMesh& surface, const PathPoint& start, const PathPoint& end, const Strip& strip)
  : Surface(surface)
  , Start(start)
  , End(end)
  , Faces(trimmed(strip, start, end))
{
  if (this->Faces.size() > 1)
  {
    Unfolding unfolding(surface, this->Faces);
    this->FlatStart = unfolding.start(start);
    this->FlatEnd = unfolding.end(end);
    this->Portals = unfolding.takePortals();
    this->findBends();
  }
}

void StripFunnel::findBends()
{
  Funnel funnel(this->FlatStart, this->Faces.size());
  for (std::size_t i = 1; i < this->Faces.size(); ++i)
  {
    const StripFace& face = this->Faces[i];
    const bool isFirst = i == 1;
    if (isFirst || face.left != this->Faces[i - 1].left)
    {
      funnel.add(Funnel::Left, { face.left, this->Portals[i - 1].left, i });
    }
    if (isFirst || face.right != this->Faces[i - 1].right)
    {
      funnel.add(Funnel::Right, { face.right, this->Portals[i - 1].right, i });
    }
  }
  this->Bends = funnel.bendsTo(this->FlatEnd);
}

template <class Visit>
void StripFunnel::visitParts(const Visit& visit) const
{
  Part part{ this->Start, this->Start, this->FlatStart, this->FlatStart, {} };
  std::size_t firstFace = 0;
  const auto visitTo = [&](const PathPoint& to, const PlanePoint& flatTo, std::size_t lastFace)
  {
    part.to = to;
    part.flatTo = flatTo;
    if (!isSameVertex(part.from, to))
    {
      // Without faces between them both are ends of the edge by which the next face is entered.
      const std::size_t count = std::max<std::size_t>(lastFace - firstFace, 1);
      part.strip = trimmed(this->Faces.subspan(firstFace, count), part.from, to);
      visit(part);
    }
    part.from = to;
    part.flatFrom = flatTo;
    firstFace = lastFace;
  };
  for (const Bend& bend : this->Bends)
  {
    visitTo(PathPoint::atVertex(bend.vertex), bend.flat, std::max(bend.face, firstFace));
  }
  visitTo(this->End, this->FlatEnd, this->Faces.size());
}

double StripFunnel::lengthOf(const Part& part) const
{
  const TriangleMesh& mesh = this->Surface.mesh();
  return part.strip.size() == 1 ? norm(part.to.position(mesh) - part.from.position(mesh))
                                : distanceBetween(part.flatFrom, part.flatTo);
}

double StripFunnel::length() const
{
  double length = 0.0;
  this->visitParts([&](const Part& part) { length += this->lengthOf(part); });
  return length;
}

std::vector<StraightPiece> StripFunnel::pieces() const
{
  std::vector<StraightPiece> pieces;
  this->visitParts(
    [&](const Part& part)
    {
      const auto& [from, to, flatFrom, flatTo, strip] = part;
      const bool isAlongEdge = strip.size() == 1 && unionOf(from, to).size() <= 2;
      pieces.push_back({ from, to, isAlongEdge ? Strip{} : Strip(strip.begin(), strip.end()),
        this->lengthOf(part) });
      Strip& crossed = pieces.back().strip;
      const std::size_t first = strip.data() - this->Faces.data();
      for (std::size_t i = 1; i < crossed.size(); ++i)
      {
        crossed[i].crossing = crossingOf(this->Portals[first + i - 1], flatFrom, flatTo);
      }
    });
  return pieces;
}

}
