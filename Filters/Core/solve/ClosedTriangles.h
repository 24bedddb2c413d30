// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ClosedTriangles_h
#define geodesic_ClosedTriangles_h

#include "mesh/TriangleMesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

/** Which triangles of the rings a front may not cross. Their vertices and border edges stay open.
 */
class ClosedTriangles
{
public:
  /** @param closed one flag a triangle, or none. Time O(n) if there is one, memory 7 bytes a
   * vertex. */
  ClosedTriangles(const TriangleMesh& mesh, std::span<const std::uint8_t> closed);

  /** Whether every triangle may be crossed. */
  bool isEmpty() const { return this->Closed.empty(); }

  /** Whether entry @p i of the ring of @p vertex opens a triangle that may be crossed. */
  bool isOpen(Index vertex, std::size_t i) const
  {
    return this->Mesh.ring(vertex)[i].opensTriangle() &&
      (this->Closed.empty() || !this->Closed[this->Mesh.rings().firstEntry(vertex) + i]);
  }

  /** Whether entry @p i of the ring of @p vertex is the far end of an edge of an open triangle. */
  bool isOpenEdge(Index vertex, std::size_t i) const
  {
    return this->isOpen(vertex, i) || (i > 0 && this->isOpen(vertex, i - 1));
  }

  bool hasOpenTriangle(Index vertex) const;

private:
  const TriangleMesh& Mesh;
  std::vector<std::uint8_t> Closed;
};

}

#endif
