// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalRegions_h
#define geodesic_distributed_GlobalRegions_h

#include "global/GlobalPoints.h"
#include "input/InputBlocks.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"
#include "split/RegionCut.h"

#include "vtkType.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace geodesic::distributed
{

/** For each vertex of this rank's piece 1 if other ranks have it too, for RegionCut. */
std::vector<std::uint8_t> sharedFlags(const DistributedSurface& surface);

/**
 * Makes the regions of the pieces those of the whole surface: the same numbers, areas and
 * perimeters on all ranks, the largest region first, equal ones by the first rank that has them.
 * The first rank gets the areas, and the sides between shared vertices, of all. Collective.
 */
void joinRegions(RankGroup& ranks, const DistributedSurface& surface, RegionCut& cut);

/**
 * The region at each of some points, the same on all ranks. Collective.
 * @param property name of the points in the error message
 * @throws std::invalid_argument on all ranks for a point on a line between regions
 */
std::vector<Index> regionsWith(RankGroup& ranks, const RegionCut& cut,
  std::span<const GlobalPoint> points, const std::string& property);

/**
 * The global ids of the points that the cut adds, which no point has: by number, from the mesh's
 * number of vertices on. A point that several ranks add has the same on all. Empty if the input has
 * no global ids. Collective.
 */
std::vector<vtkIdType> idsOfNewPoints(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::InputBlocks& blocks, const RegionCut& cut);

}

#endif
