// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_CutLines_h
#define geodesic_distributed_CutLines_h

#include "global/GlobalPath.h"
#include "path/PathPoint.h"
#include "pieces/DistributedSurface.h"
#include "ranks/RankGroup.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace geodesic::distributed
{

/**
 * The parts of lines that are on this rank's piece of a surface, for RegionCut. A part goes on as
 * long as consecutive points share a face or an edge of the piece. Where a line only touches the
 * piece, the part is a single point: the piece's faces must be split there as those of the ranks
 * beside it are.
 */
struct CutLines
{
  std::vector<SurfacePath> parts;
  /** For each part the number of its line. */
  std::vector<std::size_t> lineOf;
  /** Each line's ends, as numbers that are the same for the same place, and on all ranks. */
  std::vector<std::pair<Index, Index>> ends;
};

/**
 * Collective.
 * @param lines paths on the first rank, see joinedLines(); ignored on the others
 */
CutLines cutLinesOf(
  RankGroup& ranks, const DistributedSurface& surface, std::span<const GlobalPath> lines);

}

#endif
