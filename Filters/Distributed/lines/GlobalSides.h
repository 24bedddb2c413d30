// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalSides_h
#define geodesic_distributed_GlobalSides_h

#include "lines/LinedSurface.h"
#include "ranks/RankGroup.h"
#include "split/RegionMesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace geodesic::distributed
{

/**
 * On which side of the lines of seeds each vertex of this rank's mesh is, as curveSides() says, on
 * any number of ranks. The first rank gets the regions of all, with what they share, and decides.
 * Collective.
 * @param mesh  of LinedSurface::mesh()
 * @param name  what the lines are, for messages
 * @throws std::invalid_argument on all ranks, as CurveSides and regionSigns()
 */
std::vector<std::int8_t> globalSides(RankGroup& ranks, const LinedSurface& surface,
  const std::shared_ptr<const RegionMesh>& mesh, const std::string& name);

}

#endif
