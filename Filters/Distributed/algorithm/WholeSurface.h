// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_WholeSurface_h
#define geodesic_distributed_WholeSurface_h

#include "gather/CorridorMesh.h"
#include "pieces/DividedMesh.h"
#include "ranks/RankGroup.h"
#include "solve/DistanceSolver.h"
#include "solve/SolveOptions.h"

#include <memory>

namespace geodesic
{
struct SolverTraits;
}

namespace geodesic::distributed
{

/** All of a surface on the first of several ranks, for searches by methods that need it in one
 * piece. The other ranks have an object without a mesh. */
class WholeSurface
{
public:
  /**
   * Gathers the surface. Collective. Time O(n log n) on the first rank.
   * @param pieces  the surface
   * @param options its cost and barriers on this rank's piece
   */
  WholeSurface(RankGroup& ranks, const DividedMesh& pieces, const SolveOptions& options,
    const SolverTraits& method);

  /** Null on all ranks but the first. */
  const std::shared_ptr<const CorridorMesh>& corridor() const { return this->Mesh; }
  /** A solver on the corridor's mesh. @pre this is the first rank */
  DistanceSolver& solver() const { return *this->Solver; }

private:
  std::shared_ptr<const CorridorMesh> Mesh;
  std::unique_ptr<DistanceSolver> Solver;
};

}

#endif
