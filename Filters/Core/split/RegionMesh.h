// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionMesh_h
#define geodesic_RegionMesh_h

#include "base/Index.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"

#include <memory>
#include <vector>

namespace geodesic
{

/**
 * What regions of a mesh depend on whatever the lines are: which triangles meet at edges, the area
 * of each, and the border. Built once for a mesh, in time O(n log k) as the edge table; about 30
 * bytes a triangle.
 */
class RegionMesh
{
public:
  explicit RegionMesh(std::shared_ptr<const TriangleMesh> mesh);

  const TriangleMesh& mesh() const { return *this->Mesh; }
  const EdgeTable& edges() const { return this->Edges; }
  double areaOf(Index triangle) const { return this->Areas[triangle]; }
  /** The half-edges of edges that have a single triangle; repeated triangles do not count. */
  const std::vector<Index>& border() const { return this->Border; }
  /** The two ends of a half-edge, smaller vertex first. */
  std::pair<Index, Index> endsOf(Index halfEdge) const
  {
    const Triangle& corners = this->Mesh->triangle(EdgeTable::triangleOf(halfEdge));
    return std::minmax(corners[(halfEdge + 1) % 3], corners[(halfEdge + 2) % 3]);
  }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  EdgeTable Edges;
  std::vector<double> Areas;
  std::vector<Index> Border;
};

}

#endif
