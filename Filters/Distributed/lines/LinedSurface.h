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
#include "solve/DistanceField.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace geodesic::distributed
{

/** The lines of seeds and barriers, with the cost and the other barriers of a surface. */
struct LinedRequest
{
  std::shared_ptr<const DistributedSurface> surface;
  /** This rank's piece with the attributes of the input. */
  const bridge::PathAttributes& input;
  const GlobalLines& seedLines;
  const GlobalLines& barrierLines;
  /** For the piece's vertices and triangles. */
  const bridge::Barriers& barriers;
  const std::vector<double>& cost;
  /** See bridge::SolveSurface. */
  bool alongEdges;
};

/**
 * A surface that is split along the lines of seeds and barriers, on any number of ranks. On several
 * ranks, all triangles along the lines first move to the first rank, which then splits them.
 */
class LinedSurface
{
public:
  /**
   * Joins the lines over the surface and splits it. Both are done again only if the surface or the
   * lines changed on any rank; on several ranks, triangles along the lines move and are split again
   * also if their cost or barriers changed. Collective.
   * @return the mesh that this rank solves on, with cost and barriers
   * @throws std::exception on all ranks if no path joins two points of a line
   */
  bridge::SolveSurface update(RankGroup& ranks, const LinedRequest& request);

  /**
   * The mesh before it is split: that of this rank's piece or, with moved triangles, of gathered().
   */
  const std::shared_ptr<const TriangleMesh>& mesh() const;
  /** The mesh that is solved on. */
  const DividedMesh& divided() const { return *this->sharedDivided(); }
  const std::shared_ptr<const DividedMesh>& sharedDivided() const;
  /** The split mesh; null if this rank has split nothing. */
  const SplitMesh* split() const { return this->Lines.split().get(); }
  /** The lines of seeds on mesh(); on several ranks, the first one has all of them. */
  const std::vector<SurfacePath>& seedPaths() const { return this->Lines.seeds(); }
  /** The lines of barriers, likewise. */
  const std::vector<SurfacePath>& barrierPaths() const { return this->Lines.barriers(); }
  /** The barriers that are no lines, for the vertices and triangles of mesh(). */
  const bridge::Barriers& barriers() const
  {
    return this->Gathered ? this->Gathered->barriers() : this->Barriers;
  }
  /** The surface with moved triangles; null if there is only one rank, or no line. */
  const GatheredSurface* gathered() const { return this->Gathered.get(); }
  /** How many vertices of the input a field on divided() reached, each on the rank that owns it. */
  std::size_t numberOfOwnReached(const DistanceField& field) const;
  /** Returns points with their places on mesh(). */
  std::vector<GlobalPoint> relocated(std::vector<GlobalPoint> points) const;

private:
  /** The lines of seeds and barriers as all ranks have them. */
  struct Joined
  {
    GlobalLines seedLines;
    GlobalLines barrierLines;
    /** The paths that join the lines' points, on the first rank. */
    std::vector<GlobalPath> seedPaths;
    std::vector<GlobalPath> barrierPaths;
  };

  void updateOnSeveral(RankGroup& ranks, const LinedRequest& request);
  void join(RankGroup& ranks, const LinedRequest& request);
  void gather(RankGroup& ranks, const LinedRequest& request);

  std::shared_ptr<const DistributedSurface> Surface;
  Joined Known;
  bridge::Barriers Barriers;
  std::vector<double> Cost;
  bridge::SurfaceLines Lines;
  std::unique_ptr<const GatheredSurface> Gathered;
  std::shared_ptr<const DividedMesh> Divided;
};

}

#endif
