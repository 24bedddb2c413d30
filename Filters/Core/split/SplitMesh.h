// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SplitMesh_h
#define geodesic_SplitMesh_h

#include "path/PathPoint.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * A copy of a mesh, the base mesh, whose triangles are split so that curves run along edges. The
 * copy is cut open along some of the curves: each vertex made for a cut exists once for each side
 * of it. So fronts and paths over faces and edges pass a cut only round its ends.
 *
 * A vertex of the base mesh on a cut stays a single vertex, on no side of the cut. It must be
 * excluded (see excluded()).
 */
class SplitMesh
{
public:
  /**
   * @param base   the mesh to split; the object keeps it
   * @param curves curves that are to run along edges
   * @param cuts   curves that are to run along edges, and to be cut open
   * @throws std::invalid_argument for a curve with consecutive points that share no face
   * Time and memory O(size of the mesh); O(k^2) for k pieces of curves in one face.
   */
  SplitMesh(std::shared_ptr<const TriangleMesh> base, std::span<const SurfacePath> curves,
    std::span<const SurfacePath> cuts);

  /** Whether a path has a point that is no vertex, so that it splits faces. */
  static bool splits(const SurfacePath& path);

  const TriangleMesh& base() const { return *this->Base; }
  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }

  /** The vertex of the split mesh for a vertex of the base mesh. */
  Index vertexOf(Index baseVertex) const { return this->Mesh->vertexOfPoint(baseVertex); }
  /** The place of a vertex on the base mesh. */
  const PathPoint& origin(Index vertex) const
  {
    return this->Origins[this->Mesh->pointOfVertex(vertex)];
  }
  /** The triangle of the base mesh of which a triangle is a part. */
  Index baseTriangleOf(Index triangle) const
  {
    return this->BaseTriangles[this->Mesh->sourceOfTriangle(triangle)];
  }
  /** The point of the split mesh for a point of the base mesh. */
  SurfacePoint pointOf(const SurfacePoint& basePoint) const;
  /** The points of the curve of a number in `curves`, all at vertices. */
  std::vector<SurfacePoint> curve(std::size_t number) const;

  /** Whether a point of the split mesh lies on a cut. */
  bool isOnCut(const SurfacePoint& point) const;
  /** For each vertex 1 if it stands for a vertex of the base mesh that is excluded or on a cut,
   * else 0. @param baseExcluded such flags for the base mesh; empty for none */
  std::vector<std::uint8_t> excluded(std::span<const std::uint8_t> baseExcluded) const;
  /** The same, with 1 also for all other vertices on cuts; for paths along edges. */
  std::vector<std::uint8_t> excludedForEdges(std::span<const std::uint8_t> baseExcluded) const;
  /** The cost of each vertex, interpolated from those of the base mesh. */
  std::vector<double> cost(std::span<const double> baseCost) const;
  /** For each triangle the flag of the base mesh's triangle of which it is a part: 1 if closed. */
  std::vector<std::uint8_t> closed(std::span<const std::uint8_t> baseClosed) const;
  /** A region's vertices: those of the base mesh in @p baseVertices, and new ones on edges and in
   * faces whose corners are all among these. */
  std::vector<Index> region(const std::vector<Index>& baseVertices) const;

private:
  std::shared_ptr<const TriangleMesh> Base;
  std::shared_ptr<const TriangleMesh> Mesh;
  // Indexed by the number of a point given to the mesh: first the base mesh's vertices, then new
  // ones.
  std::vector<PathPoint> Origins;
  std::vector<std::uint8_t> OnCut;
  std::vector<std::vector<Index>> Curves;
  std::set<std::pair<Index, Index>> CutEdges;
  /** Indexed by the number of a triangle given to the mesh. */
  std::vector<Index> BaseTriangles;
  /** Pairs of a split triangle of the base mesh and a triangle in it, sorted. */
  std::vector<std::pair<Index, Index>> PiecesOfSplit;
};

}

#endif
