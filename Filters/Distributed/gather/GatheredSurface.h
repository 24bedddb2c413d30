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
 * The pieces of a surface, with all triangles along some lines moved to the first rank. That rank
 * alone can then split the surface along the lines, because no other rank has an edge that a line
 * crosses.
 *
 * O(length of the lines) triangles move. The other ranks keep all their vertices, with their
 * numbers, and share those of the moved triangles with the first rank.
 */
class GatheredSurface
{
public:
  /**
   * Moves the triangles along the lines. Collective.
   * @param lines    the paths of all lines, on the first rank; ignored on the others
   * @param barriers,cost for the vertices and triangles of this rank's piece
   */
  GatheredSurface(RankGroup& ranks, const DistributedSurface& surface,
    std::span<const GlobalPath> lines, const bridge::Barriers& barriers,
    const std::vector<double>& cost);

  /**
   * The piece's mesh without the triangles that moved. On the first rank it includes those that
   * moved there, with their points after the input's.
   */
  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  const bridge::Barriers& barriers() const { return this->Barriers; }
  const std::vector<double>& cost() const { return this->Cost; }

  /** Converts paths to paths on mesh(). On the first rank only. */
  std::vector<SurfacePath> pathsOf(std::span<const GlobalPath> paths) const;
  /**
   * Sets GlobalPoint::local to the point's place on mesh(); empty if the point is not on this rank
   * now.
   */
  void relocate(GlobalPoint& point) const;
  /**
   * Converts the vertices of regions from the piece to mesh(). Collective.
   * @param mesh made with the keys of keysOf()
   */
  void relocateRegions(RankGroup& ranks, const DividedMesh& mesh, const SplitMesh* split,
    std::vector<Seed>& seeds) const;

  /**
   * Returns the place of a vertex on the pieces. On the first rank only.
   * @param vertex as a DividedMesh with the keys of keysOf() identifies it
   */
  GlobalPathPoint originOf(const GlobalVertex& vertex, const SplitMesh* split) const;

  /**
   * Returns the keys for the vertices of mesh(), or of the first rank's split mesh; see
   * SharedPoints.
   */
  std::vector<Key> keysOf(const TriangleMesh& mesh, const SplitMesh* split) const;

private:
  void leaveOut(const std::vector<Index>& moved);
  void takeIn(const Corridor& moved, const bridge::Barriers& barriers,
    const std::vector<double>& cost, bool hasCost);
  GlobalVertex globalOf(Index vertex) const;
  Index find(const GlobalVertex& vertex) const;

  const DistributedSurface& Surface;
  std::shared_ptr<const TriangleMesh> Mesh;
  bridge::Barriers Barriers;
  std::vector<double> Cost;
  /**
   * The vertices that were added on the first rank, in the order of their points after the input's.
   */
  std::vector<GlobalVertex> Added;
  std::map<GlobalVertex, Index> PointOfAdded;
};

}

#endif
