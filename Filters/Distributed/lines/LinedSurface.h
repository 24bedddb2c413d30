// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_LinedSurface_h
#define geodesic_distributed_LinedSurface_h

#include "gather/GatheredSurface.h"
#include "global/GlobalPoints.h"
#include "lines/GlobalLines.h"
#include "pieces/DividedMesh.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "request/SolveSurface.h"
#include "request/SurfaceLines.h"

#include <memory>
#include <vector>

namespace geodesic::distributed
{

/** The lines of seeds and barriers, and what else guides the front on a surface. */
struct LinedRequest
{
  std::shared_ptr<const DistributedSurface> surface;
  /** This rank's piece. */
  const bridge::PathAttributes& input;
  const GlobalLines& seedLines;
  const GlobalLines& barrierLines;
  /** By the piece's vertices and triangles. */
  const bridge::Barriers& barriers;
  const std::vector<double>& cost;
  /** See bridge::SolveSurface. */
  bool alongEdges;
};

/**
 * A surface with lines, on any number of ranks: what is solved on in its place. On one rank the
 * mesh is split along the lines; on several, what is round them first moves to the first rank.
 */
class LinedSurface
{
public:
  /**
   * Joins the lines over the surface and splits it, which on one rank is done again only where
   * either changed. Collective.
   * @return what this rank solves on
   * @throws std::exception on all ranks where no way joins two points of a line
   */
  bridge::SolveSurface update(RankGroup& ranks, const LinedRequest& request);

  /** The mesh of the surface's piece, or what took its place, before it is split. */
  const std::shared_ptr<const TriangleMesh>& mesh() const;
  /** What is solved on. */
  const DividedMesh& divided() const;
  /** Null where this rank has split nothing. */
  const SplitMesh* split() const { return this->Lines.split().get(); }
  /** Null on one rank, and where there are no lines. */
  const GatheredSurface* gathered() const { return this->Gathered.get(); }
  /** Points where they are now, on mesh(). */
  std::vector<GlobalPoint> relocated(std::vector<GlobalPoint> points) const;

private:
  void gather(RankGroup& ranks, const LinedRequest& request);

  std::shared_ptr<const DistributedSurface> Surface;
  bridge::SurfaceLines Lines;
  std::unique_ptr<const GatheredSurface> Gathered;
  std::unique_ptr<const DividedMesh> Divided;
};

}

#endif
