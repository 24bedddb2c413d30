// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/FaceTriangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace geodesic
{
namespace
{

/** Two places are one if they are nearer to each other than this part of the longest side. */
constexpr double RelativeTolerance = 1e-10;

double distance(const PlanePoint& a, const PlanePoint& b)
{
  return std::hypot(b.x - a.x, b.y - a.y);
}

/** Height of @p c over the line from @p a to @p b, positive on its left. */
double height(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  return orientation(a, b, c) / std::max(distance(a, b), std::numeric_limits<double>::min());
}

}

FaceTriangulation::FaceTriangulation(const std::array<PlanePoint, 3>& corners)
  : Points(corners.begin(), corners.end())
  , Pieces{ { { 0, 1, 2 }, { NoIndex, NoIndex, NoIndex } } }
  , Tolerance(RelativeTolerance *
      std::max({ distance(corners[0], corners[1]), distance(corners[1], corners[2]),
        distance(corners[2], corners[0]) }))
{
}

Index FaceTriangulation::addOnBorder(Index before, Index after, const PlanePoint& point)
{
  const auto number = static_cast<Index>(this->Points.size());
  this->Points.push_back(point);
  for (Index piece : this->piecesRound(before))
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index a = this->Pieces[piece].corners[(c + 1) % 3];
      const Index b = this->Pieces[piece].corners[(c + 2) % 3];
      const bool isBorder = this->Pieces[piece].neighbours[c] == NoIndex;
      if (isBorder && ((a == before && b == after) || (a == after && b == before)))
      {
        this->splitSide(piece, c, number);
        return number;
      }
    }
  }
  throw std::logic_error("A point was to be put between two that are no neighbours on a border.");
}

std::pair<double, int> FaceTriangulation::depthIn(Index piece, const PlanePoint& place) const
{
  std::array<double, 3> heights{};
  for (int c = 0; c < 3; ++c)
  {
    const Triangle& corners = this->Pieces[piece].corners;
    heights[c] =
      height(this->Points[corners[(c + 1) % 3]], this->Points[corners[(c + 2) % 3]], place);
  }
  const auto least = std::min_element(heights.begin(), heights.end());
  return { *least, static_cast<int>(least - heights.begin()) };
}

Index FaceTriangulation::deepestAt(const PlanePoint& place) const
{
  // A walk from piece to piece, over the side beyond which the place is.
  Index piece = this->LastPiece;
  for (std::size_t step = 0; step < this->Pieces.size() && piece != NoIndex; ++step)
  {
    const auto [depth, corner] = this->depthIn(piece, place);
    if (depth >= 0.0)
    {
      return piece;
    }
    piece = this->Pieces[piece].neighbours[corner];
  }
  Index deepest = 0;
  double depth = -std::numeric_limits<double>::infinity();
  for (Index other = 0; other < this->Pieces.size(); ++other)
  {
    const double here = this->depthIn(other, place).first;
    if (here > depth)
    {
      deepest = other;
      depth = here;
    }
  }
  return deepest;
}

Index FaceTriangulation::addInside(const PlanePoint& point)
{
  const Index deepest = this->deepestAt(point);
  for (Index corner : this->Pieces[deepest].corners)
  {
    if (distance(this->Points[corner], point) <= this->Tolerance)
    {
      return corner;
    }
  }
  const auto [depth, nearest] = this->depthIn(deepest, point);
  const auto number = static_cast<Index>(this->Points.size());
  this->Points.push_back(point);
  if (depth <= this->Tolerance && this->Pieces[deepest].neighbours[nearest] != NoIndex)
  {
    this->splitSide(deepest, nearest, number);
  }
  else
  {
    this->splitPiece(deepest, number);
  }
  this->LastPiece = this->PieceAt[number];
  return number;
}

std::vector<Index> FaceTriangulation::piecesRound(Index point) const
{
  const Index first = this->PieceAt[point];
  std::vector<Index> pieces;
  for (int direction : { 1, 2 })
  {
    // The second direction is for a point on the border, and begins beside the first piece.
    Index piece = first;
    if (direction == 2)
    {
      piece = this->Pieces[first].neighbours[(this->cornerAt(first, point) + 2) % 3];
    }
    while (piece != NoIndex && (pieces.empty() || piece != first))
    {
      pieces.push_back(piece);
      piece = this->Pieces[piece].neighbours[(this->cornerAt(piece, point) + direction) % 3];
    }
    if (piece == first)
    {
      break;
    }
  }
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

void FaceTriangulation::note(std::initializer_list<Index> pieces)
{
  this->PieceAt.resize(this->Points.size(), NoIndex);
  for (Index piece : pieces)
  {
    for (Index corner : this->Pieces[piece].corners)
    {
      this->PieceAt[corner] = piece;
    }
  }
}

std::vector<Index> FaceTriangulation::addSegment(Index from, Index to)
{
  std::vector<Index> passed{ from };
  const auto goTo = [&](Index point)
  {
    this->Fixed.insert(std::minmax(passed.back(), point));
    passed.push_back(point);
  };
  while (passed.back() != to)
  {
    const Index here = passed.back();
    const PlanePoint target = this->Points[to];
    const double left = distance(this->Points[here], target);
    Index next = NoIndex;
    Index crossed = NoIndex;
    double inside = -std::numeric_limits<double>::infinity();
    for (Index piece : this->piecesRound(here))
    {
      if (next == to)
      {
        break;
      }
      const int c = this->cornerAt(piece, here);
      const Index a = this->Pieces[piece].corners[(c + 1) % 3];
      const Index b = this->Pieces[piece].corners[(c + 2) % 3];
      for (Index end : { a, b })
      {
        const PlanePoint& point = this->Points[end];
        const bool isAhead = distance(point, target) < left &&
          std::abs(height(this->Points[here], target, point)) <= this->Tolerance;
        next = end == to || (isAhead && next != to) ? end : next;
      }
      // How far inside the angle of the piece the target lies; negative outside.
      const double between = std::min(height(this->Points[here], this->Points[a], target),
        height(this->Points[b], this->Points[here], target));
      if (between > inside)
      {
        inside = between;
        crossed = piece;
      }
    }
    if (next == NoIndex)
    {
      const int c = this->cornerAt(crossed, here);
      const Index a = this->Pieces[crossed].corners[(c + 1) % 3];
      const Index b = this->Pieces[crossed].corners[(c + 2) % 3];
      const double fromA = std::abs(orientation(this->Points[here], target, this->Points[a]));
      const double fromB = std::abs(orientation(this->Points[here], target, this->Points[b]));
      const double t = fromA / (fromA + fromB);
      next = static_cast<Index>(this->Points.size());
      this->Points.push_back({ (1.0 - t) * this->Points[a].x + t * this->Points[b].x,
        (1.0 - t) * this->Points[a].y + t * this->Points[b].y });
      this->splitSide(crossed, c, next);
    }
    if (!(next == to || distance(this->Points[next], target) < left))
    {
      throw std::logic_error("A segment inside a face does not come nearer to its end.");
    }
    goTo(next);
  }
  return passed;
}

std::vector<Triangle> FaceTriangulation::triangles() const
{
  std::vector<Triangle> triangles;
  triangles.reserve(this->Pieces.size());
  for (const Piece& piece : this->Pieces)
  {
    triangles.push_back(piece.corners);
  }
  return triangles;
}

bool FaceTriangulation::isFixed(Index a, Index b) const
{
  return this->Fixed.count(std::minmax(a, b)) > 0;
}

int FaceTriangulation::cornerOpposite(Index piece, Index neighbour) const
{
  const auto& neighbours = this->Pieces[piece].neighbours;
  return static_cast<int>(
    std::find(neighbours.begin(), neighbours.end(), neighbour) - neighbours.begin());
}

int FaceTriangulation::cornerAt(Index piece, Index point) const
{
  const Triangle& corners = this->Pieces[piece].corners;
  return static_cast<int>(std::find(corners.begin(), corners.end(), point) - corners.begin());
}

void FaceTriangulation::relink(Index piece, Index from, Index to)
{
  if (piece != NoIndex)
  {
    this->Pieces[piece].neighbours[this->cornerOpposite(piece, from)] = to;
  }
}

void FaceTriangulation::splitPiece(Index piece, Index point)
{
  const Piece old = this->Pieces[piece];
  const auto second = static_cast<Index>(this->Pieces.size());
  const Index third = second + 1;
  const auto [a, b, c] = old.corners;
  this->Pieces[piece] = { { a, b, point }, { second, third, old.neighbours[2] } };
  this->Pieces.push_back({ { b, c, point }, { third, piece, old.neighbours[0] } });
  this->Pieces.push_back({ { c, a, point }, { piece, second, old.neighbours[1] } });
  this->relink(old.neighbours[0], piece, second);
  this->relink(old.neighbours[1], piece, third);
  this->note({ piece, second, third });
  this->legalize({ piece, second, third }, point);
}

void FaceTriangulation::splitSide(Index piece, int corner, Index point)
{
  // The side runs from a to b in the order of the piece's corners, from b to a in that of the piece
  // across.
  const Piece old = this->Pieces[piece];
  const Index apex = old.corners[corner];
  const Index a = old.corners[(corner + 1) % 3];
  const Index b = old.corners[(corner + 2) % 3];
  const Index across = old.neighbours[corner];
  const auto half = static_cast<Index>(this->Pieces.size());
  const Index beyondB = old.neighbours[(corner + 1) % 3];
  const Index beyondA = old.neighbours[(corner + 2) % 3];
  std::vector<Index> touched{ piece, half };
  // Pieces (apex, a, point) and (apex, point, b).
  this->Pieces[piece] = { { apex, a, point }, { NoIndex, half, beyondA } };
  this->Pieces.push_back({ { apex, point, b }, { NoIndex, beyondB, piece } });
  this->relink(beyondB, piece, half);
  this->note({ piece, half });
  if (across != NoIndex)
  {
    const Piece oldAcross = this->Pieces[across];
    const int opposite = this->cornerOpposite(across, piece);
    const Index apexAcross = oldAcross.corners[opposite];
    const Index halfAcross = half + 1;
    const Index acrossBeyondA = oldAcross.neighbours[(opposite + 1) % 3];
    const Index acrossBeyondB = oldAcross.neighbours[(opposite + 2) % 3];
    // Pieces (apexAcross, b, point) and (apexAcross, point, a).
    this->Pieces[across] = { { apexAcross, b, point }, { half, halfAcross, acrossBeyondB } };
    this->Pieces.push_back({ { apexAcross, point, a }, { piece, acrossBeyondA, across } });
    this->relink(acrossBeyondA, across, halfAcross);
    this->Pieces[piece].neighbours[0] = halfAcross;
    this->Pieces[half].neighbours[0] = across;
    this->note({ across, halfAcross });
    touched.insert(touched.end(), { across, halfAcross });
  }
  if (this->isFixed(a, b))
  {
    this->Fixed.erase(std::minmax(a, b));
    this->Fixed.insert(std::minmax(a, point));
    this->Fixed.insert(std::minmax(point, b));
  }
  this->legalize(touched, point);
}

void FaceTriangulation::legalize(std::vector<Index> pieces, Index point)
{
  while (!pieces.empty())
  {
    const Index piece = pieces.back();
    pieces.pop_back();
    const int corner = this->cornerAt(piece, point);
    if (corner < 3 && this->flipImproves(piece, corner))
    {
      const Index across = this->Pieces[piece].neighbours[corner];
      this->flip(piece, corner);
      pieces.insert(pieces.end(), { piece, across });
    }
  }
}

bool FaceTriangulation::flipImproves(Index piece, int corner) const
{
  const Index across = this->Pieces[piece].neighbours[corner];
  const Index a = this->Pieces[piece].corners[(corner + 1) % 3];
  const Index b = this->Pieces[piece].corners[(corner + 2) % 3];
  if (across == NoIndex || this->isFixed(a, b))
  {
    return false;
  }
  const PlanePoint& p = this->Points[this->Pieces[piece].corners[corner]];
  const PlanePoint& q =
    this->Points[this->Pieces[across].corners[this->cornerOpposite(across, piece)]];
  const PlanePoint& first = this->Points[a];
  const PlanePoint& second = this->Points[b];
  const bool isConvex =
    height(p, first, q) > this->Tolerance && height(q, second, p) > this->Tolerance;
  if (!isConvex)
  {
    return false;
  }
  const auto angle = [](const PlanePoint& apex, const PlanePoint& u, const PlanePoint& v)
  {
    return std::atan2(std::abs(orientation(apex, u, v)),
      (u.x - apex.x) * (v.x - apex.x) + (u.y - apex.y) * (v.y - apex.y));
  };
  // An edge is Delaunay if the two angles opposite to it sum to at most 180 degrees.
  return angle(p, first, second) + angle(q, first, second) > std::numbers::pi + 1e-9;
}

void FaceTriangulation::flip(Index piece, int corner)
{
  const Piece old = this->Pieces[piece];
  const Index across = old.neighbours[corner];
  const Piece oldAcross = this->Pieces[across];
  const int opposite = this->cornerOpposite(across, piece);
  const Index p = old.corners[corner];
  const Index a = old.corners[(corner + 1) % 3];
  const Index b = old.corners[(corner + 2) % 3];
  const Index q = oldAcross.corners[opposite];
  const Index beyondA = old.neighbours[(corner + 2) % 3];
  const Index beyondB = old.neighbours[(corner + 1) % 3];
  // In the piece across, the side runs from b to a.
  const Index acrossBeyondA = oldAcross.neighbours[(opposite + 1) % 3];
  const Index acrossBeyondB = oldAcross.neighbours[(opposite + 2) % 3];
  this->Pieces[piece] = { { p, a, q }, { acrossBeyondA, across, beyondA } };
  this->Pieces[across] = { { p, q, b }, { acrossBeyondB, beyondB, piece } };
  this->relink(acrossBeyondA, across, piece);
  this->relink(beyondB, piece, across);
  this->note({ piece, across });
}

}
