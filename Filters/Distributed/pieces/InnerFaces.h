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
 * Marks the faces of the outer surfaces that lie inside the whole grid as hidden cells. A grid that
 * is cut into pieces has such faces where the pieces meet.
 *
 * A face that two pieces have is inside. A face of a ghost cell is outside only if another piece
 * has it as its own. The result is kept for the next run on the same surfaces. Collective.
 */
void hideInnerFaces(
  RankGroup& ranks, bridge::InputBlocks& blocks, const bridge::PointIdentity& identity);

}

#endif
