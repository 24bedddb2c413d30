// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PolyDataTriangles_h
#define geodesic_bridge_PolyDataTriangles_h

#include "Index.h"
#include "Vector3.h"

#include <vector>

class vtkPolyData;

namespace geodesic::bridge
{

/**
 * The coordinates of all points, whatever their type.
 * @throws std::length_error for more points than an Index can tell apart
 */
std::vector<Vector3> pointsOf(vtkPolyData* surface);

/** The triangles of a surface and the cells that they are cut from. */
struct SurfaceTriangles
{
  std::vector<Triangle> corners;
  /** One cell id of the input a triangle. */
  std::vector<Index> cells;
};

/**
 * The triangles of the surface's polygons and strips, as ids of @p points. A quadrilateral is cut
 * along its shorter inner diagonal, a larger polygon by vtkPolygon; one that has no proper inside
 * becomes a fan round its first point. Vertices and lines are no surface.
 * @throws std::invalid_argument for a cell that names a point which does not exist
 */
SurfaceTriangles trianglesOf(vtkPolyData* surface, const std::vector<Vector3>& points);

}

#endif
