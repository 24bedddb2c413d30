// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "global/PointsOrSource.h"

#include "ranks/RankGroup.h"

#include <stdexcept>

namespace geodesic::distributed
{

std::vector<GlobalPoint> pointsOrSource(RankGroup& ranks, const DistributedSurface& surface,
  std::span<const double> coordinates, const std::string& positions, vtkDataObject* source,
  const std::string& sourceName, const ThreadTeam& team)
{
  if (!ranks.isAny(source != nullptr))
  {
    return globalPointsAt(ranks, surface, coordinates, positions, Precision::Double, team);
  }
  if (!coordinates.empty())
  {
    throw std::invalid_argument(positions + " has " + std::to_string(coordinates.size()) +
      " numbers, and " + sourceName + " is set as well. Clear " + positions + ", or set " +
      sourceName + " to None.");
  }
  return globalPointsOf(ranks, surface, source, sourceName);
}

}
