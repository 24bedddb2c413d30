// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SimpleFan_h
#define geodesic_SimpleFan_h

#include "mesh/VertexRings.h"

#include <span>

namespace geodesic
{

/** Whether a ring is one fan of triangles with each neighbour in it once, as inside a surface and
 * on a boundary. At edges of more than two triangles, and where triangles are there twice, a fan
 * may come to a neighbour again. Time O(n log n) for n triangles. */
bool isSimpleFan(std::span<const RingEntry> ring);

}

#endif
