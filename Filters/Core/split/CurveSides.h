// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveSides_h
#define geodesic_CurveSides_h

#include "path/PathPoint.h"
#include "split/LineChains.h"
#include "split/RegionMesh.h"
#include "split/RegionSigns.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace geodesic
{

/** What no front crosses, beside the surface's border: barriers. Each may be empty. */
struct Walls
{
  /** Paths on the surface. */
  std::span<const SurfacePath> lines;
  /** A flag for each vertex. */
  std::span<const std::uint8_t> excluded;
  /** A flag for each triangle. */
  std::span<const std::uint8_t> closed;
};

/**
 * On which side of curves each vertex of a surface is, for signed distances: -1 inside of closed
 * curves and to the right of open ones, 1 on their other side, as regionSigns() decides. The left
 * is that of somebody who walks along the curve on the side of the surface that the normals point
 * to; there the corners of each face are in counterclockwise order. On a curve the sign is 1. It is
 * 0 where one comes to no curve over the surface.
 *
 * Surfaces go on over edges with any number of faces and, beside curves, through single points; not
 * over walls, where a curve can end as at the border: lines, edges between two excluded vertices,
 * and closed triangles.
 *
 * A surface may be in several pieces, one of which has all faces that curves run through. Then
 * regionSigns() needs the graph of all pieces, with what sharedRegions() and sharedBorder() say.
 */
class CurveSides
{
public:
  /**
   * @param curves paths on the surface; those with a common end follow on each other
   * @param name   what the curves are, for messages
   * @param walls  they need not last longer than this call
   * @param shared a flag for each vertex: 1 if other pieces may have it; empty for one piece
   * @throws std::invalid_argument for a curve along an edge with three or more faces
   * Time O(n) for the mesh, with small constants, and O(k log k) for k points of curves.
   */
  CurveSides(const std::shared_ptr<const RegionMesh>& mesh, std::span<const SurfacePath> curves,
    const std::string& name, const Walls& walls = {}, std::span<const std::uint8_t> shared = {});

  /** The regions of this piece, without what it shares. */
  const RegionGraph& graph() const { return this->Graph; }
  const std::vector<LineChain>& chains() const { return this->Chains; }
  bool isOnCurve(Index vertex) const { return this->OnCurve[vertex]; }
  /** One of the regions at a vertex; NoIndex if no face has the vertex. */
  Index regionAt(Index vertex) const { return this->RegionAt[vertex]; }

  /** Each region at each shared vertex. If it is on no curve, these regions are one. */
  const std::vector<std::pair<Index, Index>>& sharedRegions() const { return this->SharedRegions; }
  /** An edge between shared vertices that has one face here. */
  struct BorderEdge
  {
    std::pair<Index, Index> ends;
    /** NoIndex at a wall. */
    Index region;
    double length;
  };
  /** They are the surface's border only if no other piece has a face there. */
  const std::vector<BorderEdge>& sharedBorder() const { return this->SharedBorder; }

  /** One sign for each vertex, by those of the regions. */
  std::vector<std::int8_t> signs(std::span<const std::int8_t> ofRegions) const;

private:
  class Collector;

  RegionGraph Graph;
  std::vector<LineChain> Chains;
  std::vector<bool> OnCurve;
  std::vector<Index> RegionAt;
  std::vector<std::pair<Index, Index>> SharedRegions;
  std::vector<BorderEdge> SharedBorder;
};

/**
 * The sign of each vertex of a surface in one piece.
 * @throws as CurveSides and regionSigns()
 */
std::vector<std::int8_t> curveSides(const std::shared_ptr<const RegionMesh>& mesh,
  std::span<const SurfacePath> curves, const std::string& name, const Walls& walls = {});

}

#endif
