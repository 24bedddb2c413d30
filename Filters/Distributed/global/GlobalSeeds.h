// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalSeeds_h
#define geodesic_distributed_GlobalSeeds_h

#include "global/GlobalPoints.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "request/SeedResolver.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace geodesic::distributed
{

/** One seed at each point. */
std::vector<Seed> seedsAt(std::vector<GlobalPoint> points);

/**
 * The points of a SeedSource that no line uses, projected to the nearest point of the surface:
 * those of all ranks, one that a lower rank has as well counted once.
 * @param source null where this rank has none of it
 */
std::vector<GlobalPoint> loosePointsOf(
  RankGroup& ranks, const DistributedSurface& surface, vtkDataObject* source);

/**
 * One seed for each value that is on any rank, by increasing value.
 * @param regions those of this rank
 */
std::vector<Seed> seedsOfRegions(RankGroup& ranks, bridge::RegionsByValue regions);

}

#endif
