// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StraightLines_h
#define geodesic_StraightLines_h

#include "base/Vector3.h"

#include <span>

namespace geodesic
{

class TriangleMesh;

/**
 * Finds for each vertex of a mesh the square of its straight line to the nearest of some places.
 *
 * Vertices with near numbers are near each other in space, so blocks of them are within small
 * boxes. A place is left out for a block, and for all blocks in it, where another one is nearer to
 * all of its box. Time O(n) for some hundred vertices a place, and no more than O(n k) for k
 * places.
 * @param places   at least one
 * @param squares  gets one number for each vertex
 */
void squareLeastLines(
  const TriangleMesh& mesh, std::span<const Vector3> places, std::span<double> squares);

}

#endif
