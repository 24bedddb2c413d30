// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PolyDataTriangles_h
#define geodesic_bridge_PolyDataTriangles_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <vector>

class vtkPolyData;

namespace geodesic::bridge
{

/**
 * Appends the coordinates of all points, whatever their type.
 * @throws std::length_error for more points than an Index can tell apart
 */
void appendPoints(vtkPolyData* surface, std::vector<Vector3>& points);

/** Triangles and the cells that they are cut from. */
struct SurfaceTriangles
{
  std::vector<Triangle> corners;
  /** The number of a cell a triangle. */
  std::vector<Index> cells;
};

/**
 * Appends the triangles of the surface's polygons and strips. A quadrilateral is cut along its
 * shorter inner diagonal, a larger polygon by vtkPolygon; one that has no proper inside becomes a
 * fan round its first point. Vertices and lines are no surface, and neither are cells that the
 * array vtkGhostType marks as hidden.
 * @param points      the surface's, from @p firstPoint on
 * @param firstPoint  the number of its point 0 in @p triangles
 * @param firstCell   the number of its cell 0 in @p triangles
 * @throws std::invalid_argument for a cell that names a point which does not exist
 */
void appendTriangles(vtkPolyData* surface, const std::vector<Vector3>& points, Index firstPoint,
  Index firstCell, SurfaceTriangles& triangles);

}

#endif
