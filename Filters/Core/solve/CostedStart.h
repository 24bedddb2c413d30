// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CostedStart_h
#define geodesic_CostedStart_h

#include "solve/SeedFront.h"
#include "solve/SolveOptions.h"
#include "solve/StartValue.h"

#include <span>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class FrontSolver;
class Partition;
class TriangleMesh;

/**
 * Returns the start values where the cost is 1: the lengths of the starts, all final. Collective;
 * like those of costedStarts(), values at shared vertices are the same on all pieces.
 */
std::vector<StartValue> unitStarts(const SeedFront& front, Partition& partition);

/**
 * Returns the start values where each vertex has a cost. Collective.
 *
 * The update assumes a flat source. Near a point in a varying cost there is none, and the update's
 * clamps make its values erratic. So where the cost varies within three mean edges of a round
 * label's origin, the vertices of that disc get final values: their length, from a march at cost 1
 * within the barriers, times the mean of the costs at the origin and at the vertex. Where it does
 * not vary, only the label's starts get such values. The start of a straight label is its length
 * times the cost at the vertex, final only where the length is 0.
 *
 * A disc ends at the nearest vertex that is more than twice as dear as a neighbour, or less than
 * half: beyond it that mean says nothing. So near a point the update would see sources that are not
 * there, as where triangles are bypassed.
 * @param unitSolver any solver on the mesh; its field is overwritten
 * @param atJumps    gets the vertices of discs that end so, within three mean edges. Triangles
 *                   there are to be bypassed, see Detours.
 */
std::vector<StartValue> costedStarts(const TriangleMesh& mesh, const SeedFront& front,
  const ClosedTriangles& closed, const SolveOptions& options, Partition& partition,
  FrontSolver& unitSolver, std::vector<Index>& atJumps);

/**
 * Returns the cost at the origin of a round label, interpolated in the origin's triangle, which may
 * be on another piece. Collective.
 */
double costAtOrigin(
  const TriangleMesh& mesh, std::span<const double> cost, const Label& label, Partition& partition);

}

#endif
