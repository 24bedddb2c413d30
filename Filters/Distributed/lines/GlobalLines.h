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
 * Projects the points of each line of a source to the surface, in single precision. Returns the
 * lines of all ranks; a line that a lower rank has, too, is left out. Collective.
 * @param source null if this rank has no part of the source
 */
GlobalLines globalLinesOf(RankGroup& ranks, const DistributedSurface& surface,
  vtkDataObject* source, const std::string& property);

/**
 * Joins the points of each line over the surface, as joinedCurve() does. Collective; for several
 * ranks only.
 * @param input    this rank's piece with the attributes of the input
 * @param property name of the lines in the error message
 * @return one path for each line; without points on all ranks but the first
 * @throws std::exception on all ranks if no path joins two points of a line
 */
std::vector<GlobalPath> joinedLines(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::PathAttributes& input, const GlobalLines& lines, const std::string& property);

}

#endif
