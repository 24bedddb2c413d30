// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_FoundPath_h
#define geodesic_distributed_FoundPath_h

#include "global/GlobalPath.h"
#include "ranks/RankGroup.h"

#include <span>

namespace geodesic::distributed
{

/** What is known of a path between two points. */
struct FoundPath
{
  bool isKnown = false;
  /** Whether a path joins the points. */
  bool hasPath = false;
  bool isProvenShortest = false;
  // On the first rank, or the one that has found it:
  double cost = 0.0;
  GlobalPath path;
};

/** Sends what each rank has found to the first one, and then as tellAll(). Collective; each path is
 * found by one rank at most. */
void gatherOnFirst(RankGroup& ranks, std::span<FoundPath> found);
/** Lets all ranks know what the first one knows, but for costs and paths. Collective. */
void tellAll(RankGroup& ranks, std::span<FoundPath> found);

}

#endif
