// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_ExactPath_h
#define geodesic_testing_ExactPath_h

#include "Surfaces.h"

#include <memory>
#include <vector>

namespace geodesic::testing
{

/**
 * A peer: exact shortest paths of CGAL, from one point of a surface to any of its points.
 * S.-Q. Xin, G.-J. Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, ACM
 * Trans. Graph. 28 (2009).
 */
class ExactPath
{
public:
  /** Prepares all paths from the source; the surface must be manifold. */
  ExactPath(const Surface& surface, Index source);
  ~ExactPath();

  /** The corners of the path's polyline. */
  std::vector<Vector3> to(Index target);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

}

#endif
