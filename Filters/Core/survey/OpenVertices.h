// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_OpenVertices_h
#define geodesic_OpenVertices_h

#include "base/Index.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class Partition;
class TriangleMesh;

/**
 * One flag for each vertex of this piece: non-zero where a front can start and the piece speaks for
 * the vertex (Partition::owns()). The vertex is not excluded, and has an open triangle on one piece
 * at least. Collective.
 * @param never  one flag for each vertex, non-zero where the result is zero in any case; or empty
 */
std::vector<std::uint8_t> openVertices(const TriangleMesh& mesh, const SolveOptions& options,
  std::span<const std::uint8_t> never, Partition& partition);

/**
 * The seed at a vertex, on all pieces that have it. Collective.
 * @param vertex    on the piece that speaks for it; NoIndex on the others
 * @param position  the same on all pieces
 */
Seed seedAtVertex(
  const TriangleMesh& mesh, Index vertex, const Vector3& position, Partition& partition);

}

#endif
