// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GatheredSurface_h
#define geodesic_distributed_GatheredSurface_h

#include "gather/Corridor.h"
#include "global/GlobalPath.h"
#include "global/GlobalPoints.h"
#include "path/PathPoint.h"
#include "pieces/DistributedSurface.h"
#include "ranks/KeyMatches.h"
#include "ranks/RankGroup.h"
#include "request/CostAndBarriers.h"
#include "solve/Seed.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace geodesic
{
class SplitMesh;
}

namespace geodesic::distributed
{

/**
 * The pieces of a surface with all triangles round some lines on the first rank, which can so be
 * split along them by that rank alone: no other has an edge that a line crosses. O(length of the
 * lines) triangles move. On the other ranks they stay as closed ones, so that vertices keep their
 * numbers, and the vertices of moved triangles are shared with the first rank.
 */
class GatheredSurface
{
public:
  /**
   * Collective.
   * @param lines    on the first rank; not read on the others
   * @param barriers, cost by the piece's vertices and triangles
   */
  GatheredSurface(RankGroup& ranks, const DistributedSurface& surface,
    std::span<const GlobalPath> lines, const bridge::Barriers& barriers,
    const std::vector<double>& cost);

  /** The piece's mesh, on the first rank with what moved there, its points after the input's. */
  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  const bridge::Barriers& barriers() const { return this->Barriers; }
  const std::vector<double>& cost() const { return this->Cost; }

  /** What the first rank has of these. */
  std::vector<SurfacePath> pathsOf(std::span<const GlobalPath> paths) const;
  /** A point where it is now: on the mesh, or nowhere on this rank. */
  void relocate(GlobalPoint& point) const;
  /**
   * The vertices of regions on the mesh, by those on the piece. Collective.
   * @param mesh by keysOf
   */
  void relocateRegions(RankGroup& ranks, const DividedMesh& mesh, const SplitMesh* split,
    std::vector<Seed>& seeds) const;

  /** One flag a triangle that moved to the first rank; empty there. */
  const std::vector<bool>& movedTriangles() const { return this->HasMoved; }
  /**
   * Where a vertex is on the pieces. On the first rank.
   * @param vertex as DividedMesh names it that was made by keysOf
   */
  GlobalPathPoint originOf(const GlobalVertex& vertex, const SplitMesh* split) const;

  /** What the vertices of the mesh, or of the first rank's split one, are shared by. */
  std::vector<Key> keysOf(const TriangleMesh& mesh, const SplitMesh* split) const;

private:
  void closeMoved(const std::vector<Index>& triangles);
  void takeIn(const Corridor& moved, const bridge::Barriers& barriers,
    const std::vector<double>& cost, bool hasCost);
  GlobalVertex globalOf(Index vertex) const;
  Index find(const GlobalVertex& vertex) const;

  const DistributedSurface& Surface;
  std::shared_ptr<const TriangleMesh> Mesh;
  bridge::Barriers Barriers;
  std::vector<double> Cost;
  /** On the first rank, by their points' numbers after the input's. */
  std::vector<GlobalVertex> Added;
  std::map<GlobalVertex, Index> PointOfAdded;
  std::vector<bool> HasMoved;
};

}

#endif
