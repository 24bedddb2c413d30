// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DealtRequest_h
#define geodesic_distributed_DealtRequest_h

#include "pieces/DealtSurface.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{
class DistanceSolver;
}

namespace geodesic::distributed
{

/** What is to be solved on a surface, as the mesh that its triangles were dealt to needs it. */
class DealtRequest
{
public:
  /**
   * Sends along what the request says about the pieces. Collective.
   * @param options      its costs, flags and partition are those of the piece
   * @param seeds        point seeds and regions
   * @param destinations the targets' places on the piece
   */
  DealtRequest(RankGroup& ranks, const DealtSurface& dealt, const SolveOptions& options,
    std::vector<Seed> seeds, const DealtSurface::Places& destinations);
  DealtRequest(const DealtRequest&) = delete;
  void operator=(const DealtRequest&) = delete;

  const std::vector<Seed>& seeds() const { return this->Seeds; }
  /** They borrow this object's arrays, and have no partition yet. */
  SolveOptions& options() { return this->Options; }

private:
  SolveOptions Options;
  std::vector<Seed> Seeds;
  std::vector<double> Cost;
  std::vector<std::uint8_t> Excluded;
  std::vector<std::uint8_t> Closed;
  std::vector<Triangle> Targets;
};

/**
 * Solves on the first rank, which has all triangles that matter; the others wait. Collective.
 * @return the field, null on the other ranks; and why the run ended, on all
 */
std::pair<const DistanceField*, StopReason> solveOnFirst(
  RankGroup& ranks, DealtRequest& request, DistanceSolver& solver);

}

#endif
