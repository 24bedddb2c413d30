// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathPoint_h
#define geodesic_PathPoint_h

#include "base/Index.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace geodesic
{

/**
 * A point of a path: weights (each in [0, 1], sum 1) of up to three vertices that share a face.
 * Weights of exactly 0 put it on an edge or at a vertex; such a point belongs to all faces there.
 */
struct PathPoint
{
  Triangle corners{};
  std::array<double, 3> weights{};

  friend constexpr bool operator==(const PathPoint&, const PathPoint&) = default;

  static constexpr PathPoint atVertex(Index vertex)
  {
    return { { vertex, vertex, vertex }, { 1.0, 0.0, 0.0 } };
  }
  /** @param fraction of the edge from a to the point */
  static constexpr PathPoint onEdge(Index a, Index b, double fraction)
  {
    return { { a, b, b }, { 1.0 - fraction, fraction, 0.0 } };
  }
  static PathPoint at(const TriangleMesh& mesh, const SurfacePoint& point)
  {
    return { mesh.triangle(point.triangle), point.weights };
  }

  /** The vertices with a weight above 0, which are different ones. */
  constexpr Carriers carriers() const
  {
    Carriers carriers;
    for (int i = 0; i < 3; ++i)
    {
      if (this->weights[i] > 0.0)
      {
        carriers.addNew(this->corners[i]);
      }
    }
    return carriers;
  }

  Vector3 position(const TriangleMesh& mesh) const
  {
    return this->weights[0] * mesh.position(this->corners[0]) +
      this->weights[1] * mesh.position(this->corners[1]) +
      this->weights[2] * mesh.position(this->corners[2]);
  }
};

/** Whether all vertices that carry the point are corners of the face. */
inline bool liesIn(const PathPoint& point, const Triangle& face)
{
  const auto isCorner = [&](Index vertex)
  { return vertex == face[0] || vertex == face[1] || vertex == face[2]; };
  for (int i = 0; i < 3; ++i)
  {
    if (point.weights[i] > 0.0 && !isCorner(point.corners[i]))
    {
      return false;
    }
  }
  return true;
}

/** The vertex at which the point is; NoIndex if it is at none. */
constexpr Index vertexOf(const PathPoint& point)
{
  Index vertex = NoIndex;
  int carriers = 0;
  for (int i = 0; i < 3; ++i)
  {
    vertex = point.weights[i] > 0.0 ? point.corners[i] : vertex;
    carriers += point.weights[i] > 0.0 ? 1 : 0;
  }
  return carriers == 1 ? vertex : NoIndex;
}

/** Whether the point is a vertex. */
constexpr bool isVertex(const PathPoint& point)
{
  return vertexOf(point) != NoIndex;
}

/** Whether both points are the same vertex. */
constexpr bool isSameVertex(const PathPoint& a, const PathPoint& b)
{
  return isVertex(a) && vertexOf(a) == vertexOf(b);
}

/** All vertices that carry one of two points, which may share no face. */
Carriers unionOf(const PathPoint& a, const PathPoint& b);

/** The weight of a vertex in a point; 0 if the vertex does not carry it. */
double weightOf(const PathPoint& point, Index vertex);

/** The point as a point of one of the triangles in which it lies. */
SurfacePoint surfacePointOf(const TriangleMesh& mesh, const PathPoint& point);

/** A face in which two consecutive points of a path lie, with its corners in any order. */
Triangle faceOf(const TriangleMesh& mesh, const PathPoint& a, const PathPoint& b);

/** A polyline on the surface: consecutive points lie in one face, or on one edge. */
using SurfacePath = std::vector<PathPoint>;

/** The length of a path in mesh length units. */
double lengthOf(const TriangleMesh& mesh, const SurfacePath& path);

/**
 * The beginning of a path, up to a length or a number of points, whichever comes first.
 * @param cutsEdges whether the result ends with a new point at exactly @p maximumLength; else it
 * ends at the path's last point before that
 */
SurfacePath beginningOf(const TriangleMesh& mesh, const SurfacePath& path, double maximumLength,
  std::size_t maximumPoints, bool cutsEdges);

}

#endif
