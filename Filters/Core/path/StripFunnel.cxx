// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/StripFunnel.h"

#include "path/ChordWalk.h"

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

double dot(const PlanePoint& a, const PlanePoint& b)
{
  return a.x * b.x + a.y * b.y;
}

/** A point of an edge counts as the edge's end if it is nearer to it than this fraction. */
constexpr double CornerFraction = 1e-12;

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
  // A funnel finds more bends than a few sooner.
  constexpr std::size_t looksAtAll = 8;
  surface.countSteps(this->Faces.size());
  if (this->Faces.size() > 1)
  {
    this->FlatStart = flatInFirst(surface.mesh(), this->Faces, start);
    this->FlatEnd = flatInLast(surface.mesh(), this->Faces, end);
    std::size_t looks = looksAtAll * this->Faces.size();
    this->findBends({ this->FlatStart, this->FlatEnd, 1, this->Faces.size() }, looks);
  }
}

void StripFunnel::findBends(const Range& range, std::size_t& looks)
{
  const auto& [from, to, first, last] = range;
  if (looks < last - first)
  {
    this->findBendsByFunnel(range);
    return;
  }
  looks -= last - first;
  double most = -1.0;
  std::size_t face = first;
  bool isLeft = false;
  for (std::size_t i = first; i < last; ++i)
  {
    const Portal& entry = this->Faces[i].entry;
    const double left = orientation(from, to, entry.left);
    const double right = orientation(from, to, entry.right);
    if (left > 0.0 && right < 0.0)
    {
      continue;
    }
    if (!(left > right))
    {
      // Seen from behind: the end that the line misses most may be no bend.
      this->findBendsByFunnel(range);
      return;
    }
    if (std::max(-left, right) > most)
    {
      most = std::max(-left, right);
      face = i;
      isLeft = -left > right;
    }
  }
  if (most < 0.0)
  {
    return;
  }
  const auto endOf = [&](std::size_t i)
  { return isLeft ? this->Faces[i].left : this->Faces[i].right; };
  const Index vertex = endOf(face);
  const Portal& entry = this->Faces[face].entry;
  const PlanePoint flat = isLeft ? entry.left : entry.right;
  std::size_t firstAtVertex = face;
  while (firstAtVertex > first && endOf(firstAtVertex - 1) == vertex)
  {
    --firstAtVertex;
  }
  std::size_t lastAtVertex = face + 1;
  while (lastAtVertex < last && endOf(lastAtVertex) == vertex)
  {
    ++lastAtVertex;
  }
  this->findBends({ from, flat, first, firstAtVertex }, looks);
  this->Bends.push_back({ vertex, flat, firstAtVertex });
  this->findBends({ flat, to, lastAtVertex, last }, looks);
}

void StripFunnel::findBendsByFunnel(const Range& range)
{
  Funnel funnel(range.from, range.last - range.first);
  for (std::size_t i = range.first; i < range.last; ++i)
  {
    const StripFace& face = this->Faces[i];
    const bool isFirst = i == range.first;
    if (isFirst || face.left != this->Faces[i - 1].left)
    {
      funnel.add(Funnel::Left, { face.left, face.entry.left, i });
    }
    if (isFirst || face.right != this->Faces[i - 1].right)
    {
      funnel.add(Funnel::Right, { face.right, face.entry.right, i });
    }
  }
  const std::vector<Bend> bends = funnel.bendsTo(range.to);
  this->Bends.insert(this->Bends.end(), bends.begin(), bends.end());
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

template <class StripOf>
std::vector<StraightPiece> StripFunnel::piecesWith(const StripOf& stripOf) const
{
  std::vector<StraightPiece> pieces;
  this->visitParts(
    [&](const Part& part)
    {
      const bool isAlongEdge = part.strip.size() == 1 && unionOf(part.from, part.to).size() <= 2;
      const double length = this->lengthOf(part);
      pieces.push_back({ part.from, part.to, isAlongEdge ? Strip{} : stripOf(part), length,
        part.flatFrom, part.flatTo });
    });
  return pieces;
}

std::vector<StraightPiece> StripFunnel::pieces() const
{
  return this->piecesWith(
    [](const Part& part) { return Strip(part.strip.begin(), part.strip.end()); });
}

std::vector<StraightPiece> StripFunnel::takePieces(Strip&& strip) const
{
  // What has room for the rest of a path of many pieces would keep it in each of them.
  if (!this->Bends.empty() || strip.capacity() > 2 * strip.size())
  {
    return this->pieces();
  }
  return this->piecesWith(
    [&](const Part& part)
    {
      const std::size_t first = part.strip.data() - strip.data();
      strip.resize(first + part.strip.size());
      strip.erase(strip.begin(), strip.begin() + static_cast<std::ptrdiff_t>(first));
      return std::move(strip);
    });
}

std::optional<Strip> StripFunnel::stripAlongChord() const
{
  if (this->Bends.empty())
  {
    return std::nullopt;
  }
  return geodesic::stripAlongChord(
    this->Surface, { this->Faces, this->FlatStart, this->FlatEnd, this->End });
}

PathPoint StraightPiece::crossing(const StripFace& face) const
{
  const double left = orientation(this->flatStart, this->flatEnd, face.entry.left);
  const double right = orientation(this->flatStart, this->flatEnd, face.entry.right);
  const double fraction = left == right ? 0.0 : std::clamp(left / (left - right), 0.0, 1.0);
  if (fraction < CornerFraction)
  {
    return PathPoint::atVertex(face.left);
  }
  if (fraction > 1.0 - CornerFraction)
  {
    return PathPoint::atVertex(face.right);
  }
  return PathPoint::onEdge(face.left, face.right, fraction);
}

PathPoint StraightPiece::second() const
{
  if (!this->through.empty())
  {
    return PathPoint::atVertex(this->through.front());
  }
  return this->strip.size() < 2 ? this->end : this->crossing(this->strip[1]);
}

PathPoint StraightPiece::lastButOne() const
{
  if (!this->through.empty())
  {
    return PathPoint::atVertex(this->through.back());
  }
  return this->strip.size() < 2 ? this->start : this->crossing(this->strip.back());
}

}
