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
 * A copy of a mesh whose triangles are split so that curves run along edges, and which is cut open
 * along some of them: the vertices made for a cut are there once for each side of it. So nothing
 * that goes over faces or edges passes a cut, but round its ends.
 *
 * Where a cut goes through a vertex of the base mesh, that one vertex stays, and is on no side; it
 * is to be excluded (see excluded()).
 */
class SplitMesh
{
public:
  /**
   * @param base   is shared
   * @param curves to run along edges
   * @param cuts   the same, and to be cut open
   * Time and memory O(size of the mesh); O(k^2) for k pieces of curves in one face.
   */
  SplitMesh(std::shared_ptr<const TriangleMesh> base, std::span<const SurfacePath> curves,
    std::span<const SurfacePath> cuts);

  /** Whether a path leaves the mesh's vertices and edges, so that it splits faces. */
  static bool splits(const SurfacePath& path);

  const TriangleMesh& base() const { return *this->Base; }
  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }

  /** The vertex that stands for a vertex of the base mesh. */
  Index vertexOf(Index baseVertex) const { return this->Mesh->vertexOfPoint(baseVertex); }
  /** Where a vertex is on the base mesh. */
  const PathPoint& origin(Index vertex) const
  {
    return this->Origins[this->Mesh->pointOfVertex(vertex)];
  }
  Index baseTriangleOf(Index triangle) const
  {
    return this->BaseTriangles[this->Mesh->sourceOfTriangle(triangle)];
  }
  /** A point of the base mesh. */
  SurfacePoint pointOf(const SurfacePoint& basePoint) const;
  /** The points of curve @p number, at vertices. */
  std::vector<SurfacePoint> curve(std::size_t number) const;

  /** Whether a point of this mesh lies on a cut. */
  bool isOnCut(const SurfacePoint& point) const;
  /** Per vertex: whether it stands for an excluded vertex of the base mesh, or one on a cut. */
  std::vector<std::uint8_t> excluded(std::span<const std::uint8_t> baseExcluded) const;
  /** The same, and all other vertices on cuts, for ways along edges. */
  std::vector<std::uint8_t> excludedForEdges(std::span<const std::uint8_t> baseExcluded) const;
  /** Per vertex, interpolated. */
  std::vector<double> cost(std::span<const double> baseCost) const;
  /** Per triangle: whether it is part of a closed one. */
  std::vector<std::uint8_t> closed(std::span<const std::uint8_t> baseClosed) const;
  /** The region with all vertices in faces and on edges that lie within it. */
  std::vector<Index> region(const std::vector<Index>& baseVertices) const;

private:
  std::shared_ptr<const TriangleMesh> Base;
  std::shared_ptr<const TriangleMesh> Mesh;
  // By the number of a point given to the mesh: first the base mesh's vertices, then the new ones.
  std::vector<PathPoint> Origins;
  std::vector<std::uint8_t> OnCut;
  std::vector<std::vector<Index>> Curves;
  std::set<std::pair<Index, Index>> CutEdges;
  /** By the number of a triangle given to the mesh. */
  std::vector<Index> BaseTriangles;
  /** Split triangles of the base mesh, in order, each with the triangles in it. */
  std::vector<std::pair<Index, Index>> PiecesOfSplit;
};

}

#endif
