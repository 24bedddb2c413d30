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
 * Sets the cost of each shared vertex to the mean of its costs on all ranks, as for merged points.
 * Collective.
 * @param cost one value for each vertex; empty on a rank without a surface, or on all ranks
 */
void shareCost(RankGroup& ranks, const DistributedSurface& surface, std::vector<double>& cost);

/**
 * Excludes each shared vertex that another rank excludes. Collective.
 * @param excluded one flag for each vertex; empty if none is excluded
 */
void shareExcluded(RankGroup& ranks, const DividedMesh& mesh, std::vector<std::uint8_t>& excluded);

}

#endif
