// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveSides_h
#define geodesic_CurveSides_h

#include "path/PathPoint.h"
#include "split/RegionMesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace geodesic
{

/**
 * On which side of curves each vertex of a surface is, for signed distances: -1 inside of closed
 * curves and to the right of open ones, 1 on their other side, as regionSigns() decides. The left
 * is that of somebody who walks along the curve on the side of the surface that the normals point
 * to; there the corners of each face are in counterclockwise order. On a curve the sign is 1. It is
 * 0 where one comes to no curve over the surface.
 *
 * Surfaces go on over edges with any number of faces and, beside curves, through single points.
 *
 * @param curves paths on the surface; those with a common end follow on each other
 * @param name   what the curves are, for messages
 * @return one sign for each vertex
 * @throws std::invalid_argument as regionSigns(), and for a curve along an edge with three or more
 *         faces
 * Time O(n) for the mesh, with small constants, and O(k log k) for k points of curves.
 */
std::vector<std::int8_t> curveSides(const std::shared_ptr<const RegionMesh>& mesh,
  std::span<const SurfacePath> curves, const std::string& name);

}

#endif
