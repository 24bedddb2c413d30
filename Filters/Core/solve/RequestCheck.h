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

/** @throws std::invalid_argument for an option that does not fit the mesh, naming value and limit
 */
void checkOptions(const TriangleMesh& mesh, const SolveOptions& options);

/**
 * @pre the seeds are on the mesh (see seedFront)
 * @throws std::invalid_argument naming the first seed from which no front can start: one with a
 * point that is excluded, or on an edge between excluded vertices, or inside a closed triangle
 */
void checkSeedsAreOpen(const TriangleMesh& mesh, std::span<const Seed> seeds,
  const SolveOptions& options, const ClosedTriangles& closed, Partition& partition);

}

#endif
