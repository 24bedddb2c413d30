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

class FrontSolver;
class Partition;
class TriangleMesh;

/**
 * The starts where the cost is 1: lengths are values, and final. Those at shared vertices are the
 * same on all pieces, as all starts here.
 */
std::vector<StartValue> unitStarts(const SeedFront& front, Partition& partition);

/**
 * The starts where each vertex has a cost.
 *
 * Near a point in a varying cost the flat source that the update assumes does not exist, and its
 * clamps make it erratic. So where the cost varies within three mean edges of a round label's
 * origin, the vertices of that disc get their length (unfolded, within barriers: a march at cost 1)
 * times the mean of the cost at both ends, for good. Elsewhere a start is its length times the
 * local cost.
 * @param unitSolver any solver on the mesh; its field is overwritten
 */
std::vector<StartValue> costedStarts(const TriangleMesh& mesh, const SeedFront& front,
  const SolveOptions& options, Partition& partition, FrontSolver& unitSolver);

/** The cost at the origin of a round label, which may be on another piece. Collective. */
double costAtOrigin(
  const TriangleMesh& mesh, std::span<const double> cost, const Label& label, Partition& partition);

}

#endif
