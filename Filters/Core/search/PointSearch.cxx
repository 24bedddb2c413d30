// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/PointSearch.h"

#include "base/Interruption.h"
#include "base/WorkCount.h"
#include "mesh/TriangleMesh.h"
#include "search/NearestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

namespace geodesic
{
namespace
{

/** The squared distance to the nearest vertex that has a triangle. */
double squaredDistanceToVertices(const TriangleMesh& mesh, const Vector3& query)
{
  double nearest = std::numeric_limits<double>::infinity();
  const std::span<const Vector3> positions = mesh.positions();
  for (Index v = 0; v < positions.size(); ++v)
  {
    const Vector3 away = query - positions[v];
    const double squared = dot(away, away);
    if (squared < nearest && !mesh.ring(v).empty())
    {
      nearest = squared;
    }
  }
  return nearest;
}

/** The first of the triangles from number @p start on whose lowest corner is @p vertex or above. */
Index firstFrom(std::span<const Triangle> triangles, Index start, Index vertex)
{
  // Often it is near.
  constexpr Index near = 8;
  const Index end = static_cast<Index>(triangles.size());
  for (const Index last = std::min(start + near, end); start < last; ++start)
  {
    if (lowestCorner(triangles[start]) >= vertex)
    {
      return start;
    }
  }
  return static_cast<Index>(
    std::lower_bound(triangles.begin() + start, triangles.end(), vertex,
      [](const Triangle& t, Index lowest) { return lowestCorner(t) < lowest; }) -
    triangles.begin());
}

}

PointSearch::Result scannedClosestPoint(const TriangleMesh& mesh, const Vector3& query)
{
  if (mesh.numberOfTriangles() == 0)
  {
    throw std::invalid_argument("The surface has no triangle that a point could lie on.");
  }
  // A corner of the nearest triangle is farther than the nearest point by at most its longest side.
  constexpr double rounding = 1.0 + 1e-9;
  const double toVertex = std::sqrt(squaredDistanceToVertices(mesh, query));
  const double reach = rounding * toVertex + 2.0 * NearestOrder(query).blur({ toVertex, {} });
  const std::span<const Triangle> triangles = mesh.triangles();
  NearestPoint nearest(mesh, query);
  Index next = 0;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const Vector3 away = query - mesh.position(v);
    const double most = reach + rounding * mesh.longestEdgeAround(v);
    if (dot(away, away) > most * most)
    {
      continue;
    }
    Interruption::checkAt(v);
    next = firstFrom(triangles, next, v);
    for (; next < triangles.size() && lowestCorner(triangles[next]) == v; ++next)
    {
      nearest.tryTriangle(next);
    }
  }
  WorkCount::add(mesh.numberOfVertices());
  return nearest.result();
}

PointSearch::PointSearch(std::shared_ptr<const TriangleMesh> mesh)
  : Mesh(std::move(mesh))
{
}

PointSearch::Result PointSearch::closestPoint(const Vector3& query) const
{
  if (!this->ReadyTree.load(std::memory_order_acquire) &&
    this->Scans.fetch_add(1, std::memory_order_relaxed) < MostScans)
  {
    return scannedClosestPoint(*this->Mesh, query);
  }
  return this->tree().closestPoint(query);
}

const ClosestPointTree& PointSearch::tree() const
{
  std::call_once(this->IsTreeMade,
    [this]
    {
      this->Tree = std::make_unique<const ClosestPointTree>(this->Mesh);
      this->ReadyTree.store(this->Tree.get(), std::memory_order_release);
    });
  return *this->Tree;
}

}
