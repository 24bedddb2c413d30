// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_FaceSequences_h
#define geodesic_testing_FaceSequences_h

#include "Surfaces.h"

#include <vector>

namespace geodesic::testing
{

/**
 * Exact distances between all points of a small surface, by brute force: straight lines through all
 * sequences of different faces, and all turns at points. Any surface is allowed. For about a dozen
 * faces: time grows exponentially.
 * @return for each point the distances to all; +infinity where no path leads
 */
std::vector<std::vector<double>> leastOfFaceSequences(const Surface& surface);

}

#endif
