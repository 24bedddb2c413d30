// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeLowering_h
#define geodesic_EdgeLowering_h

#include <span>

namespace geodesic
{

class ClosedTriangles;
class DistanceField;
class Partition;
class StopLimit;
class TriangleMesh;
class UnitCost;
class VertexCost;
struct SolveOptions;

/**
 * Lowers distances along edges, after a march within bounds (see LabelBounds), until none is more
 * than that of a neighbour and the price of the edge between. An edge has the cost of the cheaper
 * open triangle beside it, as in the march. A vertex that is lowered takes over the nearest seed.
 * Collective.
 *
 * Other marches leave no such distances. But a label ends with its reach, and what other labels and
 * the first march have behind it may be more: the reach counts on others that are near in space,
 * which on thin or folded triangles may be far along the surface. The result is the least of all
 * ways along edges from the distances before, so it does not depend on the order. Time O(n), hardly
 * any for most vertices, and O(k log k) for k vertices that are lowered.
 * @param ends  for each seed the distance at which the first of its labels ends: only vertices
 *              that are nearly as far may have a neighbour to lower
 * @return false when cancelled
 */
bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed, const UnitCost& cost,
  const SolveOptions& options, std::span<const double> ends, Partition& partition, StopLimit& limit,
  DistanceField& field);
bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const VertexCost& cost, const SolveOptions& options, std::span<const double> ends,
  Partition& partition, StopLimit& limit, DistanceField& field);

}

#endif
