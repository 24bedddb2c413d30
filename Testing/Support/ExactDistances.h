// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_ExactDistances_h
#define geodesic_testing_ExactDistances_h

#include "Surfaces.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic::testing
{

/**
 * Exact polyhedral distances from some points to all points of a surface, by CGAL's
 * Surface_mesh_shortest_path: an independent oracle. -1 for points that no triangle uses or that
 * can't be reached. The surface must be manifold.
 */
std::vector<double> exactDistances(const Surface& surface, const std::vector<Index>& sources);
/** The same from the points of the surface that are nearest to some positions. */
std::vector<double> exactDistancesFromPositions(
  const Surface& surface, const std::vector<Vector3>& positions);

/** The same from one point in a triangle of the surface. */
std::vector<double> exactDistancesFrom(const Surface& surface, const SurfacePoint& source);

/** Distance from a point in space to a triangle, by CGAL. */
double distanceToTriangle(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& query);

/**
 * Delaunay triangulation of random points of the unit square, its corners and border included.
 * A @p grading above 1 crowds the points towards x = 0, by x^grading.
 */
Surface delaunayPlane(Index points, unsigned seed, double grading = 1.0);

}

#endif
