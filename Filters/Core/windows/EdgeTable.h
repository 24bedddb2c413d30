// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeTable_h
#define geodesic_EdgeTable_h

#include "base/Index.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Which triangles meet at the edges of a mesh. Side k of triangle t, opposite its corner k, is
 * half-edge 3t + k. An edge is a circle of half-edges, one of each triangle that has it.
 *
 * Of triangles with the same three corners only the first has a place in the circles: what crosses
 * the others crosses it as well. Memory: 4 bytes for each half-edge and each corner, 5 a vertex.
 */
class EdgeTable
{
public:
  /** Time O(n log k) where most vertices have about k triangles. */
  explicit EdgeTable(const TriangleMesh& mesh);

  /** The next half-edge of the same edge; @p halfEdge itself if its triangle is the only one. */
  Index next(Index halfEdge) const { return this->Next[halfEdge]; }
  /** The triangles that have a vertex. */
  std::span<const Index> trianglesAt(Index vertex) const
  {
    return { this->Around.data() + this->Starts[vertex],
      this->Around.data() + this->Starts[vertex + 1] };
  }
  /** Whether an earlier triangle has the same corners. */
  bool isRepeated(Index triangle) const { return this->Repeated[triangle]; }
  /**
   * Whether a shortest path can turn at a vertex: at one on the border, where sheets meet, or where
   * the angles of the triangles sum up to more than a full turn.
   */
  bool canTurn(Index vertex) const { return this->Turning[vertex] != 0; }

private:
  void collectTriangles(const TriangleMesh& mesh);
  void linkEdges(const TriangleMesh& mesh);
  void findTurns(const TriangleMesh& mesh);

  std::vector<Index> Starts;
  std::vector<Index> Around;
  std::vector<Index> Next;
  std::vector<bool> Repeated;
  std::vector<std::uint8_t> Turning;
};

}

#endif
