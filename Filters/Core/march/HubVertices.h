// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_HubVertices_h
#define geodesic_HubVertices_h

#include "base/Index.h"

#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

class Partition;
class TriangleMesh;

/** A vertex of more triangles is a hub: a pole, the centre of a fan, the end of an edge at which
 * many sheets meet. Each value that goes on from there costs as much as a small field. */
constexpr std::size_t MostTrianglesElsewhere = 1000;

/** The hubs among some vertices, by their triangles in all pieces, in ascending order, and maybe
 * others. Collective. Time linear in their number. */
std::vector<Index> hubVertices(
  const TriangleMesh& mesh, std::span<const Index> among, Partition& partition);

/** Whether there is any hub on any piece. Collective. Time O(n). */
bool hasHubs(const TriangleMesh& mesh, Partition& partition);

}

#endif
