// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BoundedSolver_h
#define geodesic_BoundedSolver_h

#include "windows/MergedPath.h"
#include "windows/WindowSolver.h"

#include <memory>
#include <optional>
#include <vector>

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
 * Paths are no longer than the distances at their starts, and so within the same tolerance of the
 * shortest; see MergedPath.
 *
 * Time about linear: few windows are left at an edge, however far from the seed. Memory: 85 bytes a
 * vertex, and 48 for each window that waits. Where paths are wanted, all windows stay, of which a
 * field has 3 to 14 a vertex: 56 bytes for each, and 48 a vertex.
 */
class BoundedSolver final : public WindowSolver
{
public:
  /** Time O(n). */
  explicit BoundedSolver(std::shared_ptr<const TriangleMesh> mesh);

protected:
  /** @throws as ExactSolver; std::invalid_argument for a tolerance that is not positive */
  bool march(const Request& request, StopLimit& limit, DistanceField& field) override;
  std::vector<SurfacePoint> trace(
    const SurfacePoint& start, const PathStarts::Start& found) const override;

private:
  /** Through the windows of the last run. */
  std::optional<MergedPath> Path;
};

}

#endif
