// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_SidesOfSeeds_h
#define geodesic_distributed_SidesOfSeeds_h

#include "lines/LinedSurface.h"
#include "ranks/RankGroup.h"
#include "solve/DistanceField.h"
#include "solve/Seed.h"
#include "split/RegionMesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/**
 * On which side of the lines of seeds each vertex of a surface is. It is kept from run to run, and
 * found again only where the mesh, the lines or the barriers changed on any rank.
 */
class SidesOfSeeds
{
public:
  /**
   * Finds the sides. Collective.
   * @param surface  with the lines of the seeds
   * @throws std::invalid_argument on all ranks if a seed is no line, and as globalSides()
   */
  void update(RankGroup& ranks, const LinedSurface& surface, const std::vector<Seed>& seeds);

  void clear();

  /** The sign of each vertex of LinedSurface::mesh(), as globalSides() gives it; empty after
   * clear(). */
  std::span<const std::int8_t> signs() const { return this->Signs; }

  /**
   * Checks that each vertex that a field reaches is on a side.
   * @param surface  the one of the last update()
   * @throws std::invalid_argument if one is on none
   */
  void check(const LinedSurface& surface, const DistanceField& field) const;

private:
  std::vector<std::int8_t> Signs;
  /** What the signs were found for. */
  std::shared_ptr<const RegionMesh> Mesh;
  std::vector<SurfacePath> Lines;
  std::vector<SurfacePath> BarrierLines;
  bridge::Barriers Barriers;
};

}

#endif
