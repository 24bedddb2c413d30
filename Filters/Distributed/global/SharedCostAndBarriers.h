// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SharedCostAndBarriers_h
#define geodesic_distributed_SharedCostAndBarriers_h

#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"

#include <cstdint>
#include <vector>

namespace geodesic::distributed
{

/**
 * Makes the cost of each shared vertex the same on all ranks, the mean, as where points are merged.
 * Collective.
 * @param cost one value a vertex; empty on a rank without a surface, or on all
 */
void shareCost(RankGroup& ranks, const DistributedSurface& surface, std::vector<double>& cost);

/**
 * Excludes each shared vertex that another rank excludes. Collective.
 * @param excluded one flag a vertex, or empty: none
 */
void shareExcluded(RankGroup& ranks, const DividedMesh& mesh, std::vector<std::uint8_t>& excluded);

}

#endif
