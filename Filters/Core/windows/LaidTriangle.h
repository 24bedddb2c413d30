// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LaidTriangle_h
#define geodesic_LaidTriangle_h

#include "base/PlanePoint.h"
#include "mesh/EdgeTable.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

/** A point beside an edge, laid in the plane: @p lower, the lower one of the edge's two vertices,
 * in the origin, the other one on the positive x axis, and the point above the axis.
 * @param length of the edge, above 0 */
inline PlanePoint placeBeside(
  const TriangleMesh& mesh, Index lower, Index higher, double length, const Vector3& position)
{
  const Vector3& origin = mesh.position(lower);
  const Vector3 edge = mesh.position(higher) - origin;
  const Vector3 side = position - origin;
  return { dot(side, edge) / length, norm(cross(edge, side)) / length };
}

/** A triangle laid in the plane of one of its half-edges: @ref lower, the lower one of the two
 * vertices, in the origin, @ref higher on the positive x axis, and the apex above the axis. */
struct LaidTriangle
{
  LaidTriangle(const TriangleMesh& mesh, Index halfEdge)
    : triangle(EdgeTable::triangleOf(halfEdge))
  {
    const Triangle& corners = mesh.triangle(this->triangle);
    const Index k = halfEdge % 3;
    this->apex = corners[k];
    const Index a = corners[(k + 1) % 3];
    const Index b = corners[(k + 2) % 3];
    this->lower = std::min(a, b);
    this->higher = std::max(a, b);
    const Vector3& origin = mesh.position(this->lower);
    const Vector3 edge = mesh.position(this->higher) - origin;
    const Vector3 side = mesh.position(this->apex) - origin;
    this->length = norm(edge);
    this->x = this->length > 0.0 ? dot(side, edge) / this->length : 0.0;
    this->y = this->length > 0.0 ? norm(cross(edge, side)) / this->length : norm(side);
  }

  /** The half-edge of this triangle that is opposite one of its corners. */
  Index halfEdgeOpposite(const TriangleMesh& mesh, Index corner) const
  {
    const Triangle& corners = mesh.triangle(this->triangle);
    return 3 * this->triangle + (corners[0] == corner ? 0 : corners[1] == corner ? 1 : 2);
  }

  Index triangle;
  Index lower;
  Index higher;
  Index apex;
  double length;
  double x;
  double y;
};

/** The point at a place on the edge of a half-edge, from its lower vertex on. */
inline SurfacePoint pointOn(const TriangleMesh& mesh, Index halfEdge, double place)
{
  const Index t = EdgeTable::triangleOf(halfEdge);
  const Triangle& corners = mesh.triangle(t);
  const Index k = halfEdge % 3;
  Index lower = (k + 1) % 3;
  Index higher = (k + 2) % 3;
  if (corners[lower] > corners[higher])
  {
    std::swap(lower, higher);
  }
  const double length = edgeLength(mesh, corners[lower], corners[higher]);
  SurfacePoint point{ t, { 0.0, 0.0, 0.0 } };
  point.weights[higher] = length > 0.0 ? std::clamp(place / length, 0.0, 1.0) : 0.0;
  point.weights[lower] = 1.0 - point.weights[higher];
  return point;
}

}

#endif
