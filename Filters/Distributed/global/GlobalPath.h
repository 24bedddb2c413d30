// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalPath_h
#define geodesic_distributed_GlobalPath_h

#include "pieces/SharedPoints.h"

#include <array>
#include <vector>

namespace geodesic::distributed
{

/** A point of a path over the pieces of several ranks. */
struct GlobalPathPoint
{
  std::array<GlobalVertex, 3> corners;
  std::array<double, 3> weights;
};
using GlobalPath = std::vector<GlobalPathPoint>;

}

#endif
