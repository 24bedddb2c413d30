// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RequestCheck_h
#define geodesic_RequestCheck_h

#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <span>

namespace geodesic
{

class ClosedTriangles;
class Partition;
class TriangleMesh;

/** Checks cost and barriers, in time O(n).
 * @throws std::invalid_argument where they do not fit the mesh, or a cost is not positive */
void checkSurface(const TriangleMesh& mesh, const SolveOptions& options);

/** Checks the other options. @throws std::invalid_argument for an option that does not fit the
 * mesh; the message has the value and what is allowed */
void checkOptions(const TriangleMesh& mesh, const SolveOptions& options);

/**
 * Checks that a front can start from every seed. Collective.
 * @pre the seeds are on the mesh (see checkSeeds())
 * @throws std::invalid_argument with the number of the first seed from which none can: one with a
 *         point at an excluded vertex, on an edge or in a face of excluded vertices only, or inside
 *         closed triangles
 */
void checkSeedsAreOpen(const TriangleMesh& mesh, std::span<const Seed> seeds,
  const SolveOptions& options, const ClosedTriangles& closed, Partition& partition);

}

#endif
