// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionFront_h
#define geodesic_RegionFront_h

#include "solve/Seed.h"
#include "solve/SeedFront.h"

#include <functional>
#include <span>

namespace geodesic
{

class Partition;
class TriangleMesh;

/**
 * Makes the labels and starts of those seeds that are regions, by increasing number of the seed.
 * Collective; the number of collective calls does not depend on the number of regions. Time
 * O(n log n) for n vertices in regions.
 * @param goesOn called for each few thousand vertices; once it has returned false, the front is of
 *               no use
 */
SeedFront frontOfRegions(const TriangleMesh& mesh, std::span<const Seed> seeds,
  const std::function<bool()>& goesOn, Partition& partition);

}

#endif
