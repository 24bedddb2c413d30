// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalLines_h
#define geodesic_distributed_GlobalLines_h

#include "global/GlobalPath.h"
#include "global/GlobalPoints.h"
#include "output/PathAttributes.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace geodesic::distributed
{

/** The points of each line. */
using GlobalLines = std::vector<std::vector<GlobalPoint>>;

/**
 * The points of each line of a source, projected to the surface in single precision: the lines of
 * all ranks, one that a lower rank has as well counted once. Collective.
 * @param source null where this rank has none of it
 */
GlobalLines globalLinesOf(RankGroup& ranks, const DistributedSurface& surface,
  vtkDataObject* source, const std::string& property);

/**
 * Each line joined over the surface, as by joinedCurve. Collective, on several ranks.
 * @param input    this rank's piece
 * @param property what gave the lines, for the message
 * @return on the first rank; no points on the others
 * @throws std::exception on all ranks where no way joins two points
 */
std::vector<GlobalPath> joinedLines(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::PathAttributes& input, const GlobalLines& lines, const std::string& property);

}

#endif
