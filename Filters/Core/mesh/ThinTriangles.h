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

struct ThinTriangles
{
  /** Height over the longest side less than a tenth of that side. */
  std::size_t thin = 0;
  /** Less than a fiftieth. */
  std::size_t needles = 0;
  /** The number of triangles, thin or not. */
  std::size_t all = 0;

  /** Whether so many are thin that users of fast marching are told: there it can be far from the
   * shortest distance. Plugin/Documentation/algorithm.md has its errors on flattened surfaces. */
  bool areMany() const { return this->isPart(this->thin, 0.01); }
  /** Whether so many are thin that fast marching gains by intrinsic triangles (see
   * IntrinsicTriangles.h). Delaunay triangulations of random points have fewer, and spheres of
   * meridians mostly, whose poles do no harm. */
  bool needOthers() const
  {
    return this->isPart(this->thin, 0.05) || this->isPart(this->needles, 0.015);
  }

private:
  bool isPart(std::size_t count, double part) const
  {
    return count > 0 && static_cast<double>(count) >= part * static_cast<double>(this->all);
  }
};

/** Counts thin triangles. Time O(n). @param counts  whether a triangle counts */
ThinTriangles countThinTriangles(
  const TriangleMesh& mesh, const std::function<bool(Index)>& counts);
/** The same of all triangles. */
ThinTriangles countThinTriangles(const TriangleMesh& mesh);

}

#endif
