// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/IntrinsicTriangles.h"

#include "base/Interruption.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "mesh/TriangleShape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

/** The places of vertices in the order of their positions: the same whatever the order of the
 * input. */
std::vector<Index> ranksOf(std::span<const Vector3> positions)
{
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b)
    {
      const Vector3& p = positions[a];
      const Vector3& q = positions[b];
      return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    });
  std::vector<Index> ranks(positions.size());
  for (Index rank = 0; rank < order.size(); ++rank)
  {
    ranks[order[rank]] = rank;
  }
  return ranks;
}

/** A triangle with its corners in order. */
struct RankedTriangle
{
  Triangle ranks;
  Triangle corners;
  Index onMesh;
};

/** Whether the angles opposite to an edge sum to more than a half turn.
 * @param sides, others  the other two sides of the triangle on either side */
bool isBad(double length, const std::array<double, 2>& sides, const std::array<double, 2>& others)
{
  // Rounding must not tell: on a regular grid all angles sum to a half turn.
  constexpr double rounding = 1e-9;
  const double area = fourAreas(sides[0], sides[1], length);
  const double otherArea = fourAreas(others[0], others[1], length);
  // The sum of the cotangents, times both areas.
  return twiceDot(sides[0], sides[1], length) * otherArea +
    twiceDot(others[0], others[1], length) * area <
    -rounding * length * length * (area + otherArea);
}

}

IntrinsicTriangles::IntrinsicTriangles(const TriangleMesh& mesh, const std::vector<bool>& isFixed)
  : Mesh(mesh)
{
  this->makeDelaunay(isFixed);
  if (!this->refine())
  {
    this->makeDelaunay(isFixed);
  }
}

void IntrinsicTriangles::makeDelaunay(const std::vector<bool>& isFixed)
{
  this->takeTriangles();
  const std::size_t triangles = this->Corners.size();
  this->Lengths.resize(3 * triangles);
  this->Twins.assign(3 * triangles, Fixed);
  this->Changed = {};
  this->LeastEdges.assign(this->Mesh.numberOfVertices(), std::numeric_limits<double>::infinity());
  this->Steps.clear();
  this->FirstStep.assign(triangles, NoStep);
  this->LastStep.assign(triangles, NoStep);
  for (HalfEdge h = 0; h < this->Lengths.size(); ++h)
  {
    Interruption::checkAt(h);
    const Index a = this->cornerOf(following(h));
    const Index b = this->cornerOf(preceding(h));
    const double length = edgeLength(this->Mesh, a, b);
    this->Lengths[h] = length;
    const double counted = length > 0.0 ? length : std::numeric_limits<double>::infinity();
    this->LeastEdges[a] = std::min(this->LeastEdges[a], counted);
    this->LeastEdges[b] = std::min(this->LeastEdges[b], counted);
  }
  this->linkTwins(isFixed);
  for (HalfEdge h = 0; h < this->Twins.size(); ++h)
  {
    this->Waiting.push_back(h);
    this->flipWaiting();
  }
}

void IntrinsicTriangles::takeTriangles()
{
  const std::vector<Index> ranks = ranksOf(this->Mesh.positions());
  std::vector<RankedTriangle> ranked(this->Mesh.numberOfTriangles());
  for (Index t = 0; t < ranked.size(); ++t)
  {
    Triangle corners = this->Mesh.triangle(t);
    std::sort(
      corners.begin(), corners.end(), [&](Index a, Index b) { return ranks[a] < ranks[b]; });
    ranked[t] = { { ranks[corners[0]], ranks[corners[1]], ranks[corners[2]] }, corners, t };
  }
  Interruption::check();
  std::sort(ranked.begin(), ranked.end(),
    [](const RankedTriangle& s, const RankedTriangle& t) { return s.ranks < t.ranks; });
  this->Numbers.resize(ranked.size());
  this->Corners.clear();
  for (const RankedTriangle& triangle : ranked)
  {
    if (&triangle == ranked.data() || triangle.ranks != (&triangle - 1)->ranks)
    {
      this->Corners.push_back(triangle.corners);
    }
    this->Numbers[triangle.onMesh] = static_cast<Index>(this->Corners.size() - 1);
  }
}

void IntrinsicTriangles::linkTwins(const std::vector<bool>& isFixed)
{
  const EdgeTable edges(this->Mesh);
  std::vector<bool> stays(isFixed);
  stays.resize(this->Mesh.numberOfTriangles());
  for (const auto& [triangle, first] : edges.repetitions())
  {
    stays[first] = stays[first] || stays[triangle];
  }
  for (Index vertex = 0; vertex < this->Mesh.numberOfVertices(); ++vertex)
  {
    const auto round = edges.trianglesAt(vertex);
    const auto isRepeated = [&](Index triangle) { return edges.isRepeated(triangle); };
    if (round.size() > MostRoundVertex &&
      round.size() - std::count_if(round.begin(), round.end(), isRepeated) > MostRoundVertex)
    {
      std::for_each(round.begin(), round.end(), [&](Index triangle) { stays[triangle] = true; });
    }
  }
  const auto isFree = [&](Index triangle) { return !stays[triangle]; };
  // A half-edge of the mesh is that opposite to the same corner.
  const auto numberOf = [&](Index ofMesh) -> HalfEdge
  {
    const Index apex = this->Mesh.triangle(ofMesh / 3)[ofMesh % 3];
    const Index number = this->Numbers[ofMesh / 3];
    const Triangle& corners = this->Corners[number];
    return 3 * number + (corners[0] == apex ? 0 : corners[1] == apex ? 1 : 2);
  };
  // Of triangles with the same corners only the first is in the table, and has its edges.
  for (Index h = 0; h < 3 * this->Mesh.numberOfTriangles(); ++h)
  {
    Interruption::checkAt(h);
    const Index twin = edges.next(h);
    if (!edges.isRepeated(h / 3) && !edges.isOfMany(h) && isFree(h / 3) && isFree(twin / 3))
    {
      this->Twins[numberOf(h)] = twin != h ? numberOf(twin) : Border;
    }
  }
}

void IntrinsicTriangles::flipWaiting()
{
  while (!this->Waiting.empty())
  {
    const HalfEdge h = this->Waiting.back();
    this->Waiting.pop_back();
    const HalfEdge twin = this->Twins[h];
    if (this->hasTwin(h) && this->isToBeFlipped(h) && this->flip(h))
    {
      Interruption::checkAt(this->Steps.size());
      this->Touched.insert(this->Touched.end(), { h / 3, twin / 3 });
      const HalfEdge first = 3 * (h / 3);
      const HalfEdge second = 3 * (twin / 3);
      this->Waiting.insert(this->Waiting.end(), { first, first + 2, second, second + 2 });
    }
  }
}

bool IntrinsicTriangles::isToBeFlipped(HalfEdge h) const
{
  const HalfEdge twin = this->Twins[h];
  return isBad(this->Lengths[h], { this->Lengths[following(h)], this->Lengths[preceding(h)] },
    { this->Lengths[following(twin)], this->Lengths[preceding(twin)] });
}

PlanePoint IntrinsicTriangles::apexOf(HalfEdge h) const
{
  const double length = this->Lengths[h];
  const double fromEnd = this->Lengths[following(h)];
  const double fromBeginning = this->Lengths[preceding(h)];
  return { 0.5 * twiceDot(fromBeginning, length, fromEnd) / length,
    0.5 * fourAreas(length, fromBeginning, fromEnd) / length };
}

bool IntrinsicTriangles::flip(HalfEdge h)
{
  HalfEdge twin = this->Twins[h];
  const Index a = this->cornerOf(following(h));
  const Index b = this->cornerOf(preceding(h));
  const Index c = this->cornerOf(h);
  const Index d = this->cornerOf(twin);
  const double length = this->Lengths[h];
  if (c == d || !(length > 0.0) || this->isEdge(c, d) ||
    this->Steps.size() >= MostStepsOfTriangle * this->Corners.size())
  {
    return false;
  }
  if (this->cornerOf(following(twin)) == a)
  {
    this->reverse(twin / 3);
    twin = this->Twins[h];
  }
  const PlanePoint above = this->apexOf(h);
  const PlanePoint fromB = this->apexOf(twin);
  const PlanePoint below{ length - fromB.x, -fromB.y };
  const double newLength = std::hypot(above.x - below.x, above.y - below.y);

  // Where rounding makes both diagonals bad, they would take turns for ever.
  if (isBad(newLength, { this->Lengths[preceding(h)], this->Lengths[following(twin)] },
        { this->Lengths[preceding(twin)], this->Lengths[following(h)] }))
  {
    return false;
  }

  // The sides of the quadrangle, before they get other places.
  const std::array sides{ following(h), preceding(h), following(twin), preceding(twin) };
  std::array<double, 4> lengths;
  std::array<HalfEdge, 4> twins;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    lengths[i] = this->Lengths[sides[i]];
    twins[i] = this->Twins[sides[i]];
  }
  const HalfEdge first = 3 * (h / 3);
  const HalfEdge second = 3 * (twin / 3);
  this->Corners[h / 3] = { c, a, d };
  this->Corners[twin / 3] = { d, b, c };
  this->join(first, twins[2], lengths[2]);
  this->join(first + 2, twins[1], lengths[1]);
  this->join(second, twins[0], lengths[0]);
  this->join(second + 2, twins[3], lengths[3]);
  this->join(first + 1, second + 1, newLength);
  this->Lengths[second + 1] = newLength;
  this->Changed.set(a, b, Removed);
  this->Changed.set(c, d, newLength);
  this->note({ { a, b, c, d }, length, above, below, { h / 3, twin / 3 } });
  return true;
}

void IntrinsicTriangles::join(HalfEdge h, HalfEdge twin, double length)
{
  this->Lengths[h] = length;
  this->Twins[h] = twin;
  if (twin < Border)
  {
    this->Twins[twin] = h;
  }
}

void IntrinsicTriangles::reverse(Index triangle)
{
  const HalfEdge second = 3 * triangle + 1;
  const HalfEdge third = second + 1;
  std::swap(this->Corners[triangle][1], this->Corners[triangle][2]);
  std::swap(this->Lengths[second], this->Lengths[third]);
  std::swap(this->Twins[second], this->Twins[third]);
  this->join(second, this->Twins[second], this->Lengths[second]);
  this->join(third, this->Twins[third], this->Lengths[third]);
}

bool IntrinsicTriangles::isEdge(Index a, Index b) const
{
  if (const double* const changed = this->Changed.find(a, b))
  {
    return *changed != Removed;
  }
  if (std::max(a, b) >= this->Mesh.numberOfVertices())
  {
    return false;
  }
  return this->isMeshEdge(a, b);
}

bool IntrinsicTriangles::isMeshEdge(Index a, Index b) const
{
  if (this->Mesh.ring(b).size() < this->Mesh.ring(a).size())
  {
    std::swap(a, b);
  }
  const std::span<const RingEntry> ring = this->Mesh.ring(a);
  return std::any_of(
    ring.begin(), ring.end(), [&](const RingEntry& entry) { return entry.neighbour() == b; });
}

void IntrinsicTriangles::note(const Step& step)
{
  const auto number = static_cast<std::uint32_t>(this->Steps.size());
  this->Steps.push_back(step);
  for (const Index triangle : step.triangles)
  {
    const std::uint32_t last = std::exchange(this->LastStep[triangle], number);
    if (last == NoStep)
    {
      this->FirstStep[triangle] = number;
    }
    else
    {
      Step& before = this->Steps[last];
      before.next[before.triangles[0] == triangle ? 0 : 1] = number;
    }
  }
}

double IntrinsicTriangles::length(Index a, Index b) const
{
  const double* const changed = this->Changed.find(a, b);
  return changed ? *changed : edgeLength(this->Mesh, a, b);
}

std::vector<std::array<Index, 2>> IntrinsicTriangles::removedEdges() const
{
  std::vector<std::array<Index, 2>> edges;
  this->Changed.visit(
    [&](Index lower, Index higher, double length)
    {
      // The mesh's edge is also gone where a longer line has taken its name.
      constexpr double rounding = 1.0 + 1e-12;
      const bool isOfMesh = higher < this->Mesh.numberOfVertices();
      if (isOfMesh &&
        (length == Removed || length > rounding * edgeLength(this->Mesh, lower, higher)) &&
        this->isMeshEdge(lower, higher))
      {
        edges.push_back({ lower, higher });
      }
    });
  std::sort(edges.begin(), edges.end());
  return edges;
}

SurfacePoint IntrinsicTriangles::pointOf(const SurfacePoint& onMesh) const
{
  // Weights by vertex, as a triangle's corners change their order.
  Triangle corners = this->Mesh.triangle(onMesh.triangle);
  std::array<double, 3> weights = onMesh.weights;
  Index triangle = this->Numbers[onMesh.triangle];
  const auto weightOf = [&](Index vertex)
  {
    double weight = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      weight += corners[k] == vertex ? weights[k] : 0.0;
    }
    return weight;
  };
  for (std::uint32_t number = this->FirstStep[triangle]; number != NoStep;)
  {
    const Step& step = this->Steps[number];
    const auto& [a, b, c, d] = step.corners;
    const double ofC = weightOf(c);
    const double ofD = weightOf(d);
    const PlanePoint place{ weightOf(b) * step.x + ofC * step.c.x + ofD * step.d.x,
      ofC * step.c.y + ofD * step.d.y };
    // A point without weight at a or b is on the other's side, whatever rounding says.
    const bool hasA = weightOf(a) > 0.0;
    const bool hasB = weightOf(b) > 0.0;
    const bool isAtA = hasA == hasB ? orientation(step.d, step.c, place) >= 0.0 : hasA;
    const PlanePoint third = isAtA ? PlanePoint{} : PlanePoint{ step.x, 0.0 };
    const double whole = orientation(third, step.d, step.c);
    corners = { isAtA ? a : b, c, d };
    if (whole != 0.0)
    {
      weights[1] = std::clamp(orientation(third, step.d, place) / whole, 0.0, 1.0);
      weights[2] = std::clamp(orientation(third, place, step.c) / whole, 0.0, 1.0 - weights[1]);
    }
    else
    {
      const PlanePoint line = step.c - step.d;
      const PlanePoint along = place - step.d;
      const double square = line.x * line.x + line.y * line.y;
      weights[1] =
        square > 0.0 ? std::clamp((along.x * line.x + along.y * line.y) / square, 0.0, 1.0) : 1.0;
      weights[2] = 1.0 - weights[1];
    }
    weights[0] = 1.0 - weights[1] - weights[2];
    const std::size_t side = isAtA ? 0 : 1;
    triangle = step.triangles[side];
    number = step.next[side];
  }
  SurfacePoint point{ triangle, {} };
  for (std::size_t k = 0; k < 3; ++k)
  {
    point.weights[k] = weightOf(this->Corners[triangle][k]);
  }
  return snapped(point);
}

}
