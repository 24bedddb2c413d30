// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/MeshSplitter.h"

#include "base/Interruption.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

namespace geodesic
{
namespace
{

/** Two places are one if their weights in an edge or a face differ by no more than this. */
constexpr double Tolerance = 1e-9;

/** Of two weights: the golden ratio, so that points on a regular grid have different sums. */
constexpr double SumOfWeights = 0.6180339887498949;

/** A point whose weights below the tolerance are set to 0. */
PathPoint snappedPoint(const PathPoint& point)
{
  const SurfacePoint snappedWeights = snapped({ 0, point.weights }, Tolerance);
  return { point.corners, snappedWeights.weights };
}

/** A triangle whose height is below this part of its longest side is laid flat in another shape. */
constexpr double ThinHeight = 1e-6;

/**
 * The corners of a mesh's triangle in the plane. A triangle with almost no height becomes an
 * equilateral one: straight lines stay straight, and different points stay different.
 */
std::array<PlanePoint, 3> laidFlat(const TriangleMesh& mesh, const Triangle& corners)
{
  const Vector3 side = mesh.position(corners[1]) - mesh.position(corners[0]);
  const Vector3 other = mesh.position(corners[2]) - mesh.position(corners[0]);
  const double length = norm(side);
  const double longest = std::max({ length, norm(other), norm(other - side) });
  const double doubleArea = norm(cross(side, other));
  if (!(doubleArea > ThinHeight * longest * longest))
  {
    return { { {}, { 1.0, 0.0 }, { 0.5, 0.5 * std::numbers::sqrt3 } } };
  }
  return { { {}, { length, 0.0 }, { dot(other, side) / length, doubleArea / length } } };
}

/** The place in the plane of a point on a triangle that was laid flat. */
PlanePoint placed(
  const PathPoint& point, const Triangle& corners, const std::array<PlanePoint, 3>& flat)
{
  PlanePoint place;
  for (int i = 0; i < 3; ++i)
  {
    const double weight = weightOf(point, corners[i]);
    place.x += weight * flat[i].x;
    place.y += weight * flat[i].y;
  }
  return place;
}

/** The inverse of placed(): the point of the triangle at a place in the plane. */
PathPoint originOf(
  const PlanePoint& place, const Triangle& corners, const std::array<PlanePoint, 3>& flat)
{
  const double second = std::clamp(place.y / flat[2].y, 0.0, 1.0);
  const double first = std::clamp((place.x - second * flat[2].x) / flat[1].x, 0.0, 1.0);
  return { corners, { std::max(0.0, 1.0 - first - second), first, second } };
}

std::pair<Index, Index> edgeOf(Index a, Index b)
{
  return std::minmax(a, b);
}

}

MeshSplitter::MeshSplitter(const TriangleMesh& base)
  : Base(base)
{
}

std::size_t MeshSplitter::add(const SurfacePath& curve)
{
  std::vector<Index> points;
  for (const PathPoint& place : curve)
  {
    const Index point = this->pointAt(place);
    if (points.empty() || point != points.back())
    {
      points.push_back(point);
    }
  }
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Carriers corners = unionOf(this->origin(points[i - 1]), this->origin(points[i]));
    const std::vector<Index> faces = corners.size() > 3
      ? std::vector<Index>{}
      : this->Base.trianglesWith({ corners.begin(), corners.end() });
    if (faces.empty())
    {
      throw std::invalid_argument("Points " + std::to_string(i - 1) + " and " + std::to_string(i) +
        " of a curve share no face of the surface; join them over it.");
    }
    if (corners.size() == 3)
    {
      this->FaceSegments[faces.front()].push_back(edgeOf(points[i - 1], points[i]));
    }
  }
  this->Curves.push_back(std::move(points));
  return this->Curves.size() - 1;
}

Index MeshSplitter::addPoint(const PathPoint& origin)
{
  this->NewOrigins.push_back(origin);
  return this->numberOfPoints() - 1;
}

Index MeshSplitter::pointAt(const PathPoint& place)
{
  const PathPoint point = snappedPoint(place);
  const Carriers carriers = point.carriers();
  if (carriers.size() == 1)
  {
    return carriers[0];
  }
  if (carriers.size() == 2)
  {
    const Edge edge = edgeOf(carriers[0], carriers[1]);
    // From the larger weight, of which 1 minus it is exact, and to the nearest point: another piece
    // of the surface has the same edge with its ends the other way round, and must get the same.
    const double first = weightOf(point, edge.first);
    const double second = weightOf(point, edge.second);
    const double fraction = first > second ? 1.0 - first : second;
    auto& points = this->EdgePoints[edge];
    const auto above = points.lower_bound(fraction);
    const bool isAbove = above != points.end() && above->first <= fraction + Tolerance;
    const bool isBelow = above != points.begin() && std::prev(above)->first >= fraction - Tolerance;
    if (isAbove && !(isBelow && fraction - std::prev(above)->first < above->first - fraction))
    {
      return above->second;
    }
    if (isBelow)
    {
      return std::prev(above)->second;
    }
    const Index added = this->addPoint(PathPoint::onEdge(edge.first, edge.second, fraction));
    points.emplace(fraction, added);
    return added;
  }
  const Index face = this->Base.firstTriangleWith({ carriers.begin(), carriers.end() });
  auto& places = this->FacePlaces[face];
  const Triangle& corners = this->Base.triangle(face);
  const double sum = weightOf(point, corners[0]) + SumOfWeights * weightOf(point, corners[1]);
  const double range = (1.0 + SumOfWeights) * Tolerance;
  const auto last = places.upper_bound(sum + range);
  for (auto near = places.lower_bound(sum - range); near != last; ++near)
  {
    const Index known = near->second;
    const bool isSame = std::all_of(carriers.begin(), carriers.end(),
      [&](Index vertex) {
        return std::abs(weightOf(point, vertex) - weightOf(this->origin(known), vertex)) <=
          Tolerance;
      });
    if (isSame)
    {
      return known;
    }
  }
  const Index added = this->addPoint(point);
  this->FacePoints[face].push_back(added);
  places.emplace(sum, added);
  return added;
}

void MeshSplitter::split()
{
  for (const auto& [edge, points] : this->EdgePoints)
  {
    const std::array<Index, 2> ends{ edge.first, edge.second };
    const std::vector<Index> faces = this->Base.trianglesWith(ends);
    this->SplitTriangles.insert(faces.begin(), faces.end());
  }
  for (const auto& [face, points] : this->FacePoints)
  {
    this->SplitTriangles.insert(face);
  }
  for (const auto& [face, segments] : this->FaceSegments)
  {
    this->SplitTriangles.insert(face);
  }
  std::size_t count = 0;
  for (Index triangle : this->SplitTriangles)
  {
    Interruption::checkAt(count++);
    this->splitTriangle(triangle);
  }
}

void MeshSplitter::splitTriangle(Index triangle)
{
  const Triangle& corners = this->Base.triangle(triangle);
  const std::array<PlanePoint, 3> flat = laidFlat(this->Base, corners);
  FaceTriangulation pieces(flat);
  std::vector<Index> points(corners.begin(), corners.end());
  std::map<Index, Index> numbers{ { corners[0], 0 }, { corners[1], 1 }, { corners[2], 2 } };
  const auto place = [&](Index point) { return placed(this->origin(point), corners, flat); };
  const auto note = [&](Index point, Index number)
  {
    numbers[point] = number;
    if (number == points.size())
    {
      points.push_back(point);
    }
  };
  for (Index c = 0; c < 3; ++c)
  {
    const Index a = corners[c];
    const Index b = corners[(c + 1) % 3];
    const auto onEdge = this->EdgePoints.find(edgeOf(a, b));
    if (onEdge == this->EdgePoints.end())
    {
      continue;
    }
    // The points are sorted by their fraction of the edge from its smaller vertex.
    Index before = numbers[onEdge->first.first];
    const Index end = numbers[onEdge->first.second];
    for (const auto& [fraction, point] : onEdge->second)
    {
      note(point, pieces.addOnBorder(before, end, place(point)));
      before = numbers[point];
    }
  }
  const auto inside = this->FacePoints.find(triangle);
  if (inside != this->FacePoints.end())
  {
    for (Index point : inside->second)
    {
      note(point, pieces.addInside(place(point)));
    }
  }
  const auto segments = this->FaceSegments.find(triangle);
  if (segments != this->FaceSegments.end())
  {
    for (const auto& [a, b] : segments->second)
    {
      pieces.addSegment(numbers[a], numbers[b]);
    }
    while (points.size() < pieces.points().size())
    {
      points.push_back(this->addPoint(originOf(pieces.points()[points.size()], corners, flat)));
    }
    for (const Edge& segment : segments->second)
    {
      std::vector<Index>& along = this->PiecesOfSegment[segment];
      along.clear();
      for (Index number : pieces.addSegment(numbers[segment.first], numbers[segment.second]))
      {
        along.push_back(points[number]);
      }
    }
  }
  for (const Triangle& piece : pieces.triangles())
  {
    this->Pieces.push_back({ points[piece[0]], points[piece[1]], points[piece[2]] });
    this->BaseTriangles.push_back(triangle);
  }
}

std::vector<Index> MeshSplitter::alongEdge(Index a, Index b) const
{
  const Carriers ends = unionOf(this->origin(a), this->origin(b));
  std::vector<Index> points{ a };
  const auto onEdge =
    ends.size() == 2 ? this->EdgePoints.find(edgeOf(ends[0], ends[1])) : this->EdgePoints.end();
  if (onEdge != this->EdgePoints.end())
  {
    const Index last = onEdge->first.second;
    const double from = weightOf(this->origin(a), last);
    const double to = weightOf(this->origin(b), last);
    for (const auto& [fraction, point] : onEdge->second)
    {
      if (fraction > std::min(from, to) && fraction < std::max(from, to))
      {
        points.push_back(point);
      }
    }
    if (from > to)
    {
      std::reverse(points.begin() + 1, points.end());
    }
  }
  points.push_back(b);
  return points;
}

std::vector<Index> MeshSplitter::curve(std::size_t number) const
{
  const std::vector<Index>& points = this->Curves[number];
  std::vector<Index> all(points.begin(), points.begin() + (points.empty() ? 0 : 1));
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Edge segment = edgeOf(points[i - 1], points[i]);
    const auto inFace = this->PiecesOfSegment.find(segment);
    std::vector<Index> along = inFace == this->PiecesOfSegment.end()
      ? this->alongEdge(points[i - 1], points[i])
      : inFace->second;
    if (inFace != this->PiecesOfSegment.end() && points[i - 1] != segment.first)
    {
      std::reverse(along.begin(), along.end());
    }
    all.insert(all.end(), along.begin() + 1, along.end());
  }
  return all;
}

void MeshSplitter::cutAlong(std::span<const std::size_t> curves)
{
  for (std::size_t number : curves)
  {
    const std::vector<Index> points = this->curve(number);
    this->OnCut.insert(points.begin(), points.end());
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      this->CutEdges.insert(edgeOf(points[i - 1], points[i]));
    }
  }
  std::map<Index, std::vector<Index>> piecesAt;
  for (std::size_t p = 0; p < this->Pieces.size(); ++p)
  {
    Interruption::checkAt(p);
    for (Index point : this->Pieces[p])
    {
      if (point >= this->Base.numberOfVertices() && this->isOnCut(point))
      {
        piecesAt[point].push_back(static_cast<Index>(p));
      }
    }
  }
  const std::vector<Triangle> uncut = this->Pieces;
  for (const auto& [point, pieces] : piecesAt)
  {
    this->openAt(point, pieces, uncut);
  }
  const std::set<Edge> uncutEdges = this->CutEdges;
  for (std::size_t p = 0; p < this->Pieces.size(); ++p)
  {
    for (int c = 0; c < 3; ++c)
    {
      const int next = (c + 1) % 3;
      if (uncutEdges.count(edgeOf(uncut[p][c], uncut[p][next])) > 0)
      {
        this->CutEdges.insert(edgeOf(this->Pieces[p][c], this->Pieces[p][next]));
      }
    }
  }
}

void MeshSplitter::openAt(
  Index point, const std::vector<Index>& pieces, const std::vector<Triangle>& uncut)
{
  // A side of the cuts consists of pieces round the point that are connected over edges which
  // are no cuts.
  std::map<Index, std::vector<Index>> atEdgeTo;
  for (const Index piece : pieces)
  {
    for (const Index corner : uncut[piece])
    {
      if (corner != point && this->CutEdges.count(edgeOf(corner, point)) == 0)
      {
        atEdgeTo[corner].push_back(piece);
      }
    }
  }
  std::set<Index> done;
  bool isFirst = true;
  for (auto first = pieces.rbegin(); first != pieces.rend(); ++first)
  {
    if (!done.insert(*first).second)
    {
      continue;
    }
    std::vector<Index> side{ *first };
    for (std::size_t i = 0; i < side.size(); ++i)
    {
      for (const Index corner : uncut[side[i]])
      {
        const auto beside = atEdgeTo.extract(corner);
        for (const Index other : beside ? beside.mapped() : std::vector<Index>{})
        {
          if (done.insert(other).second)
          {
            side.push_back(other);
          }
        }
      }
    }
    if (!isFirst)
    {
      const Index twin = this->addPoint(this->origin(point));
      this->OnCut.insert(twin);
      for (const Index piece : side)
      {
        std::replace(this->Pieces[piece].begin(), this->Pieces[piece].end(), point, twin);
      }
    }
    isFirst = false;
  }
}

}
