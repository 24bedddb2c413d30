// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThinTriangles_h
#define geodesic_ThinTriangles_h

#include <cstddef>

namespace geodesic
{

class TriangleMesh;

/** Where so many triangles of all are thin, users of fast marching are told. */
constexpr double ManyThinTriangles = 0.01;

/**
 * The number of triangles that are thin: their height over the longest side is less than a tenth of
 * that side. There fast marching can be far from the shortest distance; Plugin/Documentation/
 * algorithm.md has its errors on flattened surfaces. Time O(n).
 */
std::size_t numberOfThinTriangles(const TriangleMesh& mesh);

}

#endif
