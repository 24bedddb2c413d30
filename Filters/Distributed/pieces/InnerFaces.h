// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_InnerFaces_h
#define geodesic_distributed_InnerFaces_h

#include "input/InputBlocks.h"
#include "input/PointIdentity.h"
#include "ranks/RankGroup.h"

namespace geodesic::distributed
{

/**
 * Where a grid is cut into pieces, each piece's outer surface has faces inside the whole: marks
 * those as hidden cells. A face that two pieces have is inside; one of a ghost cell is outside only
 * where another piece has it as its own. Collective; what was found is kept for the next run on the
 * same surfaces.
 */
void hideInnerFaces(
  RankGroup& ranks, bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

}

#endif
