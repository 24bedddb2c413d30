// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeedCheck_h
#define geodesic_SeedCheck_h

#include "solve/Seed.h"

#include <span>

namespace geodesic
{

class Partition;
class TriangleMesh;

/**
 * @throws std::invalid_argument with the number of the first invalid seed: one without points, with
 * a triangle or vertex that does not exist, with weights that are negative or do not sum to 1,
 * or with a value that is negative or not finite; a curve with a segment that is neither in one
 * face nor along one edge
 */
void checkSeeds(const TriangleMesh& mesh, std::span<const Seed> seeds, const Partition& partition);

}

#endif
