// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistinctPositions_h
#define geodesic_DistinctPositions_h

#include "base/ThreadTeam.h"
#include "base/Vector3.h"

#include <span>

namespace geodesic
{

/**
 * Whether no two positions are equal. Hashes of the coordinates rule out nearly all of them, so
 * that few are compared. Time O(n) where few are equal, memory 12 bytes a position while it runs.
 * @param positions  finite
 * @param team       threads that do a part of the work
 */
bool areDistinct(std::span<const Vector3> positions, const ThreadTeam& team = ThreadTeam());

}

#endif
