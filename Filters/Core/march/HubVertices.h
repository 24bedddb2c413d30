// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_HubVertices_h
#define geodesic_HubVertices_h

#include "base/Index.h"

#include <vector>

namespace geodesic
{

class Partition;
class TriangleMesh;

/**
 * The vertices of more than a thousand triangles, counted in all pieces, in ascending order: poles,
 * centres of fans, ends of edges at which many sheets meet. Each value that goes on from there
 * costs as much as a small field. Collective. Time O(n).
 */
std::vector<Index> hubVertices(const TriangleMesh& mesh, Partition& partition);

}

#endif
