// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LineChains_h
#define geodesic_LineChains_h

#include "base/Index.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** Lines that follow on each other, as the segments of a path do. */
struct LineChain
{
  /** The numbers of the lines, in increasing order. */
  std::vector<std::size_t> lines;
  /** Whether an even number of the chain's ends meet at each of them, so that nothing is open. */
  bool isClosed = true;
};

/**
 * The chains of lines, in the order of their first lines.
 * @param ends the points at which each line begins and ends; lines with one in common follow on
 *             each other
 * Time O(n log n).
 */
std::vector<LineChain> chainsOf(std::span<const std::pair<Index, Index>> ends);

}

#endif
