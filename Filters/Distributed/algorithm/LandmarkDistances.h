// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LandmarkDistances_h
#define geodesic_LandmarkDistances_h

#include "algorithm/DistributedPathFinder.h"
#include "global/GlobalPoints.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/**
 * The lengths of the shortest paths between all pairs of landmarks. A landmark shares its march
 * with all paths to the landmarks after it, and each pair is searched once, so that the matrix is
 * symmetric.
 * @param request    what DistributedPathFinder takes; progress counts the steps of all marches
 * @param landmarks  n points of the solver's mesh
 * @param isAborted  whether the search must stop; it is asked after each search on all ranks
 * @return n rows of n lengths, 0 on the diagonal and NaN where no path leads; nothing if the search
 *         was aborted. Only the first of several ranks has lengths above 0.
 * Time: n - 1 marches as far as the farthest landmark, and n (n - 1) / 2 traced paths.
 */
std::optional<std::vector<double>> distancesAmong(const PathRequest& request,
  std::span<const GlobalPoint> landmarks, const std::function<bool()>& isAborted);

/**
 * The lengths of the shortest paths from each landmark of one set to each of another. The smaller
 * set marches.
 * @return one row for each landmark of @p from, of one length for each of @p to; otherwise as
 * distancesAmong()
 */
std::optional<std::vector<double>> distancesBetween(const PathRequest& request,
  std::span<const GlobalPoint> from, std::span<const GlobalPoint> to,
  const std::function<bool()>& isAborted);

}

#endif
