// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistinctPositions_h
#define geodesic_DistinctPositions_h

#include "base/Vector3.h"

#include <span>

namespace geodesic
{

/**
 * Whether no two positions are equal. A table of bits, by a hash of the coordinates, rules out
 * nearly all of them, so that few are compared.
 * Time O(n) for finite positions, memory 8 bytes a position while it runs.
 * B. H. Bloom, Space/time trade-offs in hash coding with allowable errors, CACM 13 (1970).
 */
bool areDistinct(std::span<const Vector3> positions);

}

#endif
