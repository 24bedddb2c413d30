// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_PathScout_h
#define geodesic_distributed_PathScout_h

#include "gather/Corridor.h"
#include "gather/CorridorMesh.h"
#include "global/GlobalPoints.h"
#include "path/PathFinder.h"
#include "path/PathTracer.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/**
 * Extends a corridor along paths that are not known yet. It traces each path through a ball round
 * its beginning, then through a ball round the point where it leaves the first one, and so on until
 * its end is near. So it makes meshes of balls only, in time O(length) for a path, and what finds
 * the path afterwards has nearly all triangles that it needs. Paths that come close to each other
 * go on as one: behind it they do so mostly.
 */
class PathScout
{
public:
  /** Has all ranks cut the triangles in balls; see patchesOfAll(). */
  using Cut = std::function<std::vector<SurfacePatch>(std::span<const Ball>)>;

  /** The radius of balls, in longest edges at their centres. They let a path go on for a while, and
   * bring few triangles that are too far beside it. */
  static constexpr double ReachInEdges = 8.0;

  /**
   * @param ends    by number of the seed; all arguments must live as long as this
   * @param style   that of the paths
   * @param options whose progress is reported
   * @param hasCost see CorridorMesh
   */
  PathScout(Corridor& corridor, const std::vector<GlobalPoint>& ends, const PathStyle& style,
    const SolveOptions& options, bool hasCost, Cut cut);

  /**
   * Follows the paths from some points.
   * @param mostPoints  of the corridor; a single path has as many as it needs
   * @return false if there would be more, and so the paths were not followed to their ends
   * @throws SearchCancelled
   */
  bool followFrom(std::span<const GlobalPoint> starts, std::size_t mostPoints);
  /** Follows the paths from vertices that the corridor has to the ends nearest to them. */
  void followFrom(std::span<const PatchVertex> vertices);

private:
  /** Where a path has come to. */
  struct Walker
  {
    Ball ball;
    /** Where the path begins; null later. */
    const GlobalPoint* start;
    /** Otherwise, the vertex where it goes on; none if it ends near by. */
    std::optional<GlobalVertex> vertex;
    /** The number of the end. */
    Index seed;
    double distance;
  };
  class Window;

  /** Goes on until no path goes on, or there are too many points. */
  bool follow(std::vector<Walker> walkers, std::size_t mostPoints);

  Corridor& Along;
  const std::vector<GlobalPoint>& Ends;
  const PathStyle& Style;
  const SolveOptions& Options;
  bool HasCost;
  Cut CutOnAll;
};

}

#endif
