// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LandmarkDistances_h
#define geodesic_LandmarkDistances_h

#include "algorithm/PathSearches.h"
#include "global/GlobalPoints.h"

#include <optional>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/**
 * The lengths of the shortest paths between all pairs of landmarks. A landmark shares its march
 * with all paths to the landmarks after it in landmarkOrder(), and each pair is searched once, so
 * that the matrix is symmetric. Threads share the marches.
 * @param landmarks  n points of the solver's mesh
 * @return n rows of n lengths, 0 on the diagonal and NaN where no path leads; nothing if the search
 *         was aborted. Only the first of several ranks has lengths above 0.
 * Time: n - 1 marches as far as the farthest landmark that is left, and n (n - 1) / 2 traced paths.
 */
std::optional<std::vector<double>> distancesAmong(
  PathSearches& searches, std::span<const GlobalPoint> landmarks);

/**
 * The lengths of the shortest paths from each landmark of one set to each of another. The smaller
 * set marches.
 * @return one row for each landmark of @p from, of one length for each of @p to; otherwise as
 * distancesAmong()
 */
std::optional<std::vector<double>> distancesBetween(
  PathSearches& searches, std::span<const GlobalPoint> from, std::span<const GlobalPoint> to);

}

#endif
