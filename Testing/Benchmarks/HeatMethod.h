// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_HeatMethod_h
#define geodesic_testing_HeatMethod_h

#include "base/Index.h"

#include <memory>
#include <vector>

namespace geodesic
{
class TriangleMesh;
}

namespace geodesic::testing
{

/**
 * A peer: the heat method of CGAL, in its default mode, on an intrinsic Delaunay triangulation.
 * K. Crane, C. Weischedel, M. Wardetzky, Geodesics in heat, ACM Trans. Graph. 32 (2013).
 */
class HeatMethod
{
public:
  /** Factorizes the mesh, which must be manifold. */
  explicit HeatMethod(const TriangleMesh& mesh);
  ~HeatMethod();

  /** Distances of all vertices from one of them. */
  std::vector<double> solve(Index source);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

}

#endif
