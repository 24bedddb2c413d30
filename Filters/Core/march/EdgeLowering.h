// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeLowering_h
#define geodesic_EdgeLowering_h

#include "base/Index.h"

#include <span>

namespace geodesic
{

class ClosedTriangles;
class DistanceField;
class Partition;
class StopLimit;
class TriangleMesh;
struct SolveOptions;

/**
 * Lowers distances along edges, after a march at cost 1 within bounds (see LabelBounds), until none
 * is more than that of a neighbour and the edge between. A vertex that is lowered takes over the
 * nearest seed. Collective.
 *
 * Other marches at cost 1 leave no such distances. But a label ends with its reach, and what other
 * labels and the first march have behind it may be more: the reach counts on others that are near
 * in space, which on thin or folded triangles may be far along the surface. The result is the least
 * of all ways along edges from the distances before, so it does not depend on the order. Time O(k
 * log k) for k vertices that are looked at.
 * @param from  the vertices that may have a neighbour to lower: those at which a label ends
 * @return false when cancelled
 */
bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const SolveOptions& options, std::span<const Index> from, Partition& partition, StopLimit& limit,
  DistanceField& field);

}

#endif
