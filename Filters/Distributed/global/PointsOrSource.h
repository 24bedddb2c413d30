// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PointsOrSource_h
#define geodesic_PointsOrSource_h

#include "global/GlobalPoints.h"

#include <span>
#include <string>
#include <vector>

class vtkDataObject;

namespace geodesic::distributed
{

/**
 * Returns the points of a data set if any rank has one, else those at positions. Collective.
 * @param positions, sourceName names of both in error messages
 * @param team as in globalPointsAt()
 * @throws std::invalid_argument on all ranks if there are positions and a data set; also as
 * globalPointsAt() and globalPointsOf()
 */
std::vector<GlobalPoint> pointsOrSource(RankGroup& ranks, const DistributedSurface& surface,
  std::span<const double> coordinates, const std::string& positions, vtkDataObject* source,
  const std::string& sourceName, const ThreadTeam& team);

}

#endif
