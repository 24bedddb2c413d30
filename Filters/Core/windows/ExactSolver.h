// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ExactSolver_h
#define geodesic_ExactSolver_h

#include "windows/WindowSolver.h"

#include <memory>
#include <vector>

namespace geodesic
{

/**
 * Exact geodesic distance on the polyhedron that the triangles make, by windows; see Window and
 * WindowFront. Distances are right to rounding, 1e-14 of the largest, on needles too.
 *
 * Seeds are points at vertices, on edges and in faces, curves and regions, with start values. A
 * path may go along the edges and corners of closed triangles, and along the side of a triangle
 * that lies opposite to an excluded vertex, but through neither. Of equally near seeds the nearest
 * one is the smallest at vertices; behind such ties it may be any of them. Paths are the shortest
 * of all, not only locally.
 *
 * Time O(n^1.5 log n) on smooth surfaces, O(n) on planes, and O(n^2 log n) at worst. Memory: 80
 * bytes a vertex, and 48 for each window that waits: 50 to 180 bytes a vertex on surfaces tried;
 * 40 bytes a vertex more where paths are wanted.
 */
class ExactSolver final : public WindowSolver
{
public:
  /** Time O(n). */
  explicit ExactSolver(std::shared_ptr<const TriangleMesh> mesh);

protected:
  /** @throws std::invalid_argument for a cost, or on a surface in several pieces;
   * std::runtime_error beyond SolveOptions::memoryLimit */
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;
  std::vector<SurfacePoint> trace(
    const SurfacePoint& start, const PathStarts::Start& found) const override;
};

}

#endif
