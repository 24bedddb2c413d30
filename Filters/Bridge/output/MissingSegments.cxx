// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/MissingSegments.h"

#include <algorithm>

namespace geodesic::bridge
{

std::string messageOfMissing(const std::vector<std::string>& names, std::size_t segments)
{
  constexpr std::size_t mostNamed = 5;
  std::string named = names.front();
  for (std::size_t i = 1; i < std::min(names.size(), mostNamed); ++i)
  {
    named += ", or " + names[i];
  }
  if (names.size() > mostNamed)
  {
    named += ", nor for " + std::to_string(names.size() - mostNamed) + " segments more";
  }
  const std::size_t found = segments - names.size();
  return "No path over the surface leads " + named + ". " +
    (found == 0 ? "So there is no segment"
                : "The other " + std::to_string(found) + " of " + std::to_string(segments) +
          " segments are in the output") +
    ". Connect the parts of the surface, remove a part of the barriers, or move the points.";
}

}
