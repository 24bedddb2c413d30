// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionSigns_h
#define geodesic_RegionSigns_h

#include "base/Index.h"
#include "split/LineChains.h"

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace geodesic
{

/** The regions between lines, and which of them lie beside each other. */
struct RegionGraph
{
  struct Region
  {
    double area = 0.0;
    /** How much of the surface's border the region has. */
    double border = 0.0;
  };
  /** A chain of lines that runs between two regions. */
  struct Passage
  {
    Index chain;
    /** 1 if the first region is on its left, -1 if the second one is, 0 if nobody can say. */
    int left;

    friend auto operator<=>(const Passage&, const Passage&) = default;
  };
  /** Regions on both sides of lines; one is NoIndex where a line runs along the border. */
  struct Crossing
  {
    std::array<Index, 2> regions;
    std::vector<Passage> passages;

    friend auto operator<=>(const Crossing&, const Crossing&) = default;
  };

  std::vector<Region> regions;
  std::vector<Crossing> crossings;
  /** Regions that are one, so that they lie on the same sides of all lines. */
  std::vector<std::pair<Index, Index>> links;
};

/**
 * The sign of each region: 1, -1, or 0 where no line is on the region's part of the surface.
 *
 * Each chain of lines has a minus side. That of an open chain is its right. That of a closed one is
 * its inside: the side with less of the surface's border or, if both have as much (as on a closed
 * surface), with the smaller area or, if these are equal as well, the left. A region's sign is -1
 * if it is on the minus sides of an odd number of chains, so that the sign changes at each line.
 *
 * @param name what the lines are, for messages
 * @throws std::invalid_argument for a chain that does not cut its part of the surface in two by
 *         itself, that has no length, or that is open and has no constant left side
 * Time O(size of the graph).
 */
std::vector<std::int8_t> regionSigns(
  const RegionGraph& graph, std::span<const LineChain> chains, const std::string& name);

/** "SeedSource's line 2" or "SeedSource's lines 2 to 5", for messages. */
std::string nameOfLines(const std::string& name, const LineChain& chain);

}

#endif
