// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_PartialSearch_h
#define geodesic_distributed_PartialSearch_h

#include "path/PathFinder.h"
#include "solve/DistanceSolver.h"
#include "solve/SolveOptions.h"

#include <memory>
#include <optional>

namespace geodesic::distributed
{

/** Whether a path costs so much less than another one that it is to be taken: which of two ways
 * round that is does not hang on rounding. */
inline bool costsLess(double cost, double other)
{
  constexpr double rounding = 1e-9;
  return cost < (1.0 - rounding) * other;
}

/**
 * Finds paths between points on a part of a surface, and tells where the part is not enough. It is
 * if the path does not come to a vertex that lacks triangles, and the front only to such that no
 * way by them, even in a straight line from there on, is shorter than the path. Then the path is
 * that on the whole surface.
 */
class PartialSearch
{
public:
  /**
   * @param mesh     the part
   * @param options  cost, barriers, progress, and which vertices lack triangles. Its arrays must
   *                 outlive this object and stay the same
   * @param example  a solver of the method to use
   */
  PartialSearch(std::shared_ptr<const TriangleMesh> mesh, const SolveOptions& options,
    const PathStyle& style, const DistanceSolver& example);

  struct Outcome
  {
    /** Whether the part was enough. */
    bool isKnown = false;
    /** From the first point to the second; none if no path joins them. */
    std::optional<SurfacePath> path;
    /** See TracedPath. */
    double cost = 0.0;
    bool isProvenShortest = false;
  };

  /** @param fromBothEnds see PathSearches::between() @throws as PathFinder */
  Outcome between(const SurfacePoint& from, const SurfacePoint& to, bool fromBothEnds);

private:
  /** The path from @p start to @p end. */
  Outcome search(const SurfacePoint& end, const SurfacePoint& start);

  /** Whether what lies beyond the part can't change a path. @param start of the path, where the
   * field ends */
  bool isEnough(const DistanceField& field, const Outcome& outcome, const Vector3& start) const;

  SolveOptions Options;
  PathStyle Style;
  std::unique_ptr<DistanceSolver> Solver;
  // Of all vertices of the part.
  double LeastCost = 1.0;
  double MostCost = 1.0;
};

}

#endif
