// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalSeeds_h
#define geodesic_distributed_GlobalSeeds_h

#include "base/BoundingBox.h"
#include "global/GlobalPoints.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "request/SeedResolver.h"

#include <span>
#include <string>
#include <vector>

class vtkDataObject;

namespace geodesic::distributed
{

/** Returns the box round the points and regions of seeds, the same on all ranks. Collective. */
BoundingBox boxOf(RankGroup& ranks, const DistributedSurface& surface, std::span<const Seed> seeds);

/** Makes one seed at each point. */
std::vector<Seed> seedsAt(std::vector<GlobalPoint> points);

/**
 * Projects the points of a SeedSource that no line uses to the nearest points of the surface.
 * Returns the points of all ranks; a point that a lower rank has, too, is left out. Collective.
 * @param source null if this rank has no part of the source
 */
std::vector<GlobalPoint> loosePointsOf(
  RankGroup& ranks, const DistributedSurface& surface, vtkDataObject* source);

/**
 * Makes one seed for each value that any rank has, by increasing value. Collective.
 * @param regions the regions of this rank
 */
std::vector<Seed> seedsOfRegions(RankGroup& ranks, bridge::RegionsByValue regions);

}

#endif
