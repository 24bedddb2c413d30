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

/** Tells which triangles of a vertex's ring a front may not cross. The vertices of such a closed
 * triangle, and its edges to open triangles, stay open. */
class ClosedTriangles
{
public:
  /**
   * @param mesh    must outlive this object
   * @param closed  one flag for each triangle, non-zero where it is closed; or empty
   * If any triangle is closed: time O(n), memory 7 bytes a vertex.
   */
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

  /** Whether any triangle round @p vertex may be crossed. */
  bool hasOpenTriangle(Index vertex) const;

private:
  const TriangleMesh& Mesh;
  /** One flag for each ring entry; empty where no triangle is closed. */
  std::vector<std::uint8_t> Closed;
};

}

#endif
