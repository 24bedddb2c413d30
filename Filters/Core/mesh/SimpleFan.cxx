// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SimpleFan.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace geodesic
{
namespace
{

/** Whether the neighbours of some entries are different ones. */
bool areDifferent(std::span<const RingEntry> entries)
{
  constexpr std::size_t few = 12;
  if (entries.size() > few)
  {
    std::vector<Index> neighbours;
    neighbours.reserve(entries.size());
    std::transform(entries.begin(), entries.end(), std::back_inserter(neighbours),
      [](const RingEntry& entry) { return entry.neighbour(); });
    std::sort(neighbours.begin(), neighbours.end());
    return std::adjacent_find(neighbours.begin(), neighbours.end()) == neighbours.end();
  }
  for (std::size_t i = 1; i < entries.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (entries[i].neighbour() == entries[j].neighbour())
      {
        return false;
      }
    }
  }
  return true;
}

}

bool isSimpleFan(std::span<const RingEntry> ring)
{
  if (ring.empty())
  {
    return false;
  }
  const std::span<const RingEntry> opening = ring.first(ring.size() - 1);
  const bool isOneFan = std::all_of(
    opening.begin(), opening.end(), [](const RingEntry& entry) { return entry.opensTriangle(); });
  // The last entry repeats the first one where the fan closes.
  const bool isClosed = ring.front().neighbour() == ring.back().neighbour();
  return isOneFan && areDifferent(isClosed ? opening : ring);
}

}
