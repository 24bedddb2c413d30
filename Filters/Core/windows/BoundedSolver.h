// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BoundedSolver_h
#define geodesic_BoundedSolver_h

#include "mesh/EdgeTable.h"
#include "solve/FrontSolver.h"
#include "windows/WindowFront.h"

#include <memory>

namespace geodesic
{

/**
 * Geodesic distance with a promise: no distance is smaller than the exact one on the polyhedron, or
 * larger than (1 + SolveOptions::tolerance) times it, rounding aside (1e-11 of the largest). It is
 * the front of ExactSolver with neighbouring windows merged; see WindowMerging.
 *
 * Seeds and barriers are as in ExactSolver. Fields of inputs in other orders agree within the
 * tolerance. A vertex whose distance lies within the tolerance of the maximum distance may be left
 * out.
 *
 * Time about linear: few windows are left at an edge, however far from the seed. Memory: 85 bytes a
 * vertex, and 48 for each window that waits.
 */
class BoundedSolver final : public FrontSolver
{
public:
  /** Time O(n). */
  explicit BoundedSolver(std::shared_ptr<const TriangleMesh> mesh);

protected:
  /** @throws as ExactSolver; std::invalid_argument for a tolerance that is not positive */
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;

private:
  EdgeTable Edges;
  WindowWorkspace Workspace;
};

}

#endif
