// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThinTriangles_h
#define geodesic_ThinTriangles_h

#include "base/Index.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

class TriangleMesh;

/** Where so many triangles of all are thin, users of fast marching are told. */
constexpr double ManyThinTriangles = 0.01;

struct ThinTriangles
{
  std::size_t thin = 0;
  /** The number of triangles, thin or not. */
  std::size_t all = 0;
};

/**
 * Counts the triangles that are thin: their height over the longest side is less than a tenth of
 * that side. There fast marching can be far from the shortest distance; Plugin/Documentation/
 * algorithm.md has its errors on flattened surfaces. Time O(n).
 * @param counts  whether a triangle counts
 */
ThinTriangles countThinTriangles(
  const TriangleMesh& mesh, const std::function<bool(Index)>& counts);

}

#endif
