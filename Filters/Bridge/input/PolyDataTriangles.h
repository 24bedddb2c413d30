// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PolyDataTriangles_h
#define geodesic_bridge_PolyDataTriangles_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"

#include <span>
#include <vector>

class vtkPolyData;

namespace geodesic
{
class TriangleMesh;
}

namespace geodesic::bridge
{

/**
 * Appends the coordinates of all points, which may have any value type.
 * @throws std::length_error if there are more points than an Index can number
 */
void appendPoints(vtkPolyData* surface, BulkVector<Vector3>& points);

/** Triangles and the cells that they are cut from. */
struct SurfaceTriangles
{
  std::vector<Triangle> corners;
  /** The cell of each triangle. */
  std::vector<Index> cells;
  /** Whether there are polygons of more than three corners, whose triangles depend on where the
   * corners are. */
  bool areCutByPositions = false;
};

/**
 * Appends the triangles of the surface's polygons and strips. A quadrilateral is cut along its
 * shorter inner diagonal, a larger polygon by vtkPolygon; a polygon that vtkPolygon can't cut
 * becomes a fan of triangles at its first point. Vertices, lines, and cells that the array
 * vtkGhostType marks as hidden are left out.
 * @param points      coordinates of all points; those of the surface begin at @p firstPoint
 * @param firstPoint  the number of the surface's point 0 in @p triangles
 * @param firstCell   the number of the surface's cell 0 in @p triangles
 * @throws std::invalid_argument if a cell uses a point that does not exist
 */
void appendTriangles(vtkPolyData* surface, std::span<const Vector3> points, Index firstPoint,
  Index firstCell, SurfaceTriangles& triangles);

/**
 * Whether the surface's cells with faces are the triangles that a mesh was made of, one for one.
 * This compares the cells where they are. False does not mean that they are others: where the
 * surface has other cells than triangles, or the mesh leaves out triangles or points or merges
 * these, appendTriangles() and TriangleMesh::isMadeOf() tell.
 */
bool areTrianglesOf(vtkPolyData* surface, const TriangleMesh& mesh, const ThreadTeam& team);

}

#endif
