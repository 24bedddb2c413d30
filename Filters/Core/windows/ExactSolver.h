// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ExactSolver_h
#define geodesic_ExactSolver_h

#include "solve/FrontSolver.h"
#include "windows/EdgeTable.h"
#include "windows/WindowFront.h"

#include <memory>

namespace geodesic
{

/**
 * Exact geodesic distance from points on the polyhedron that the triangles make, by windows; see
 * Window and WindowFront. Distances are right to rounding, 1e-14 of the largest, on needles too.
 *
 * Seeds are points at vertices, on edges and in faces, with start values. A path may go along the
 * edges and corners of closed triangles, and along the side of a triangle that lies opposite to an
 * excluded vertex, but through neither. Of equally near seeds the nearest
 * one is the smallest at vertices; behind such ties it may be any of them.
 *
 * Time O(n^1.5 log n) on smooth surfaces, O(n) on planes, and O(n^2 log n) at worst. Memory: 80
 * bytes a vertex, and 48 for each window that waits: 50 to 180 bytes a vertex on surfaces tried.
 */
class ExactSolver final : public FrontSolver
{
public:
  /** Time O(n). */
  explicit ExactSolver(std::shared_ptr<const TriangleMesh> mesh);

protected:
  /** @throws std::invalid_argument for a cost, for seeds that are no points, or on a surface in
   * several pieces; std::runtime_error beyond SolveOptions::memoryLimit */
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;

private:
  EdgeTable Edges;
  WindowWorkspace Workspace;
};

}

#endif
