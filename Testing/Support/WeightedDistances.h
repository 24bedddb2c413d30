// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_WeightedDistances_h
#define geodesic_testing_WeightedDistances_h

#include "mesh/TriangleMesh.h"

#include <span>
#include <vector>

namespace geodesic::testing
{

/**
 * Distances from a vertex under costs, the truth on small meshes: Dijkstra's algorithm on a graph
 * of the vertices and of points on all edges, in which all points of a triangle are neighbours, at
 * the triangle's cost. Distances are not below the true ones, and above them by less than a
 * hundredth with 24 points on an edge. L. Aleksandrov, A. Maheshwari, J.-R. Sack, Determining
 * approximate shortest paths on weighted polyhedral surfaces, J. ACM 52 (2005).
 * @param cost  of each vertex; a triangle has the mean of its corners' costs
 * @return one for each vertex
 */
std::vector<double> weightedDistances(
  const TriangleMesh& mesh, std::span<const double> cost, Index source, int pointsOnEdge = 24);

}

#endif
