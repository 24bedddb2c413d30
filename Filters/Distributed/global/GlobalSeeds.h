// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalSeeds_h
#define geodesic_distributed_GlobalSeeds_h

#include "base/BoundingBox.h"
#include "global/GlobalPoints.h"
#include "input/InputBlocks.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "request/SeedResolver.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

class vtkDataObject;
class vtkSelection;

namespace geodesic::distributed
{

/** Returns the box round the points and regions of seeds, the same on all ranks. Collective. */
BoundingBox boxOf(RankGroup& ranks, const TriangleMesh& mesh, std::span<const Seed> seeds);

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

/**
 * Makes one seed for each value but 0 of SeedArray on the surface of all ranks. Collective.
 * @param name    of the array, for the error message
 * @param choose  reads this rank's array; returns none if none is chosen, and may throw
 * @throws std::invalid_argument if an array is chosen and gives no seed
 */
std::vector<Seed> seedsOfArray(RankGroup& ranks, const DistributedSurface& surface,
  const std::string& name, const std::function<bridge::ChosenArray()>& choose);

/**
 * Makes seeds of the selected points and cells of the surface of all ranks. Collective.
 * @param selection  SeedSelection; null if there is none
 * @param input      this rank's piece, to which it refers
 * @throws std::invalid_argument if something is selected, but nothing of the surface
 */
std::vector<Seed> seedsOfSelection(RankGroup& ranks, const DistributedSurface& surface,
  vtkSelection* selection, vtkDataObject* input, const bridge::InputBlocks& blocks);

}

#endif
