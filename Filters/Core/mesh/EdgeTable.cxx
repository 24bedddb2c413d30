// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/EdgeTable.h"

#include "base/Interruption.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace geodesic
{
namespace
{

/** A side of a triangle, seen from its lower end. */
struct Side
{
  Index higher;
  Index apex;
  Index halfEdge;

  friend bool operator<(const Side& a, const Side& b)
  {
    return std::tie(a.higher, a.apex, a.halfEdge) < std::tie(b.higher, b.apex, b.halfEdge);
  }
};

/** Whether the triangles round a vertex are one fan. */
bool isOneFan(std::span<const RingEntry> ring)
{
  const auto fans = std::count_if(
    ring.begin(), ring.end(), [](const RingEntry& entry) { return !entry.opensTriangle(); });
  return fans == 1;
}

double angleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/** The least height of the triangle between two of its sides, in parts of its longest side. */
double narrowness(const Vector3& a, const Vector3& b)
{
  const Vector3 third = b - a;
  return norm(cross(a, b)) / std::max({ dot(a, a), dot(b, b), dot(third, third) });
}

}

EdgeTable::EdgeTable(const TriangleMesh& mesh)
  : Starts(mesh.numberOfVertices() + 1, 0)
  , Around(3 * static_cast<std::size_t>(mesh.numberOfTriangles()))
  , Next(3 * static_cast<std::size_t>(mesh.numberOfTriangles()))
  , Repeated(mesh.numberOfTriangles(), false)
  , Turning(mesh.numberOfVertices(), 0)
{
  this->collectTriangles(mesh);
  this->linkEdges(mesh);
  this->findTurns(mesh);
}

void EdgeTable::collectTriangles(const TriangleMesh& mesh)
{
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    Interruption::checkAt(t);
    for (const Index corner : mesh.triangle(t))
    {
      ++this->Starts[corner + 1];
    }
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  std::vector<Index> place(this->Starts.begin(), this->Starts.end() - 1);
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    Interruption::checkAt(t);
    for (const Index corner : mesh.triangle(t))
    {
      this->Around[place[corner]++] = t;
    }
    std::iota(this->Next.begin() + 3 * static_cast<std::ptrdiff_t>(t),
      this->Next.begin() + 3 * static_cast<std::ptrdiff_t>(t) + 3, 3 * t);
  }
}

void EdgeTable::linkEdges(const TriangleMesh& mesh)
{
  std::vector<Side> sides;
  for (Index lower = 0; lower < mesh.numberOfVertices(); ++lower)
  {
    Interruption::checkAt(lower);
    sides.clear();
    for (const Index t : this->trianglesAt(lower))
    {
      const Triangle& corners = mesh.triangle(t);
      for (Index k = 0; k < 3; ++k)
      {
        const Index a = corners[(k + 1) % 3];
        const Index b = corners[(k + 2) % 3];
        if (std::min(a, b) == lower)
        {
          sides.push_back({ std::max(a, b), corners[k], 3 * t + k });
        }
      }
    }
    std::sort(sides.begin(), sides.end());
    std::size_t first = 0;
    std::size_t firstWithApex = 0;
    for (std::size_t i = 1; i < sides.size(); ++i)
    {
      if (sides[i].higher != sides[first].higher)
      {
        this->noteFirst(sides[first].halfEdge);
        first = i;
        firstWithApex = i;
      }
      else if (sides[i].apex == sides[firstWithApex].apex)
      {
        this->addRepetition(
          triangleOf(sides[i].halfEdge), triangleOf(sides[firstWithApex].halfEdge));
      }
      else
      {
        firstWithApex = i;
        std::swap(this->Next[sides[first].halfEdge], this->Next[sides[i].halfEdge]);
      }
    }
    if (!sides.empty())
    {
      this->noteFirst(sides[first].halfEdge);
    }
  }
}

void EdgeTable::noteFirst(Index halfEdge)
{
  if (this->next(this->next(halfEdge)) == halfEdge)
  {
    return;
  }
  std::vector<Index> circle{ halfEdge };
  for (Index other = this->next(halfEdge); other != halfEdge; other = this->next(other))
  {
    circle.push_back(other);
  }
  const Index least = *std::min_element(circle.begin(), circle.end());
  for (const Index other : circle)
  {
    this->FirstOfMany.emplace(other, least);
  }
}

void EdgeTable::addRepetition(Index triangle, Index first)
{
  // Each of its three edges finds it.
  if (!this->Repeated[triangle])
  {
    this->Repeated[triangle] = true;
    this->Repetitions.emplace_back(triangle, first);
  }
}

void EdgeTable::findTurns(const TriangleMesh& mesh)
{
  // Where the sum is a full turn, it comes out as more or less by rounding. To turn at such a
  // vertex would be right as well, but cost time. On the border a half turn must count: there the
  // edges themselves are the shortest path. Between needles, a vertex with an excess that is
  // nothing for common triangles can hide others.
  constexpr double rounding = 1e-9;
  constexpr double ofNeedles = 1e-8;
  constexpr double ofAngle = 1e-15;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    Interruption::checkAt(v);
    const std::span<const RingEntry> ring = mesh.ring(v);
    // An edge without length hides an angle.
    bool canTurn = ring.empty() || !isOneFan(ring);
    double sum = 0.0;
    double narrowest = 1.0;
    for (std::size_t i = 0; i + 1 < ring.size() && !canTurn; ++i)
    {
      const Vector3 side = mesh.position(ring[i].neighbour()) - mesh.position(v);
      const Vector3 next = mesh.position(ring[i + 1].neighbour()) - mesh.position(v);
      canTurn = !(norm(side) > 0.0 && norm(next) > 0.0);
      sum += angleBetween(side, next);
      narrowest = std::min(narrowest, narrowness(side, next));
    }
    const bool isInside = !ring.empty() && ring.front().neighbour() == ring.back().neighbour();
    const double spare = std::min(
      rounding, std::max(ofNeedles * narrowest, ofAngle * static_cast<double>(ring.size())));
    const double straight = isInside ? 2.0 * std::numbers::pi + spare : std::numbers::pi - rounding;
    this->Turning[v] = canTurn || sum > straight ? 1 : 0;
  }
}

}
