// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeTable_h
#define geodesic_EdgeTable_h

#include "base/BulkVector.h"
#include "base/Index.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Which triangles meet at the edges of a mesh. Half-edge 3t + k is the side of triangle t opposite
 * its corner k, from corner k + 1 to corner k + 2. An edge is a circle of half-edges, one of each
 * triangle that has it: two on a manifold, one at a border, more where sheets meet.
 *
 * Of triangles with the same three corners only the first has a place in the circles: what crosses
 * the others crosses it as well. Memory: 4 bytes for each half-edge and each corner, 5 a vertex,
 * and more where an edge has more than two triangles.
 */
class EdgeTable
{
public:
  /** Time O(n log k) where most vertices have about k triangles. */
  explicit EdgeTable(const TriangleMesh& mesh);

  static Index triangleOf(Index halfEdge) { return halfEdge / 3; }
  /** The half-edge of the same triangle that begins where @p halfEdge ends. */
  static Index following(Index halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }

  /** The next half-edge of the same edge; @p halfEdge itself if its triangle is the only one. */
  Index next(Index halfEdge) const { return this->Next[halfEdge]; }
  /** Whether an edge has more than two triangles. */
  bool isOfMany(Index halfEdge) const { return this->next(this->next(halfEdge)) != halfEdge; }
  /** The least half-edge of the same edge. Time O(1). */
  Index first(Index halfEdge) const
  {
    return this->isOfMany(halfEdge) ? this->FirstOfMany.at(halfEdge)
                                    : std::min(halfEdge, this->next(halfEdge));
  }
  /** The triangles that have a vertex. */
  std::span<const Index> trianglesAt(Index vertex) const
  {
    return { this->Around.data() + this->Starts[vertex],
      this->Around.data() + this->Starts[vertex + 1] };
  }
  /** Whether an earlier triangle has the same corners. */
  bool isRepeated(Index triangle) const { return this->Repeated[triangle]; }
  /** The repeated triangles, each with the first one that has the same corners. */
  const std::vector<std::pair<Index, Index>>& repetitions() const { return this->Repetitions; }
  /**
   * Whether a shortest path can turn at a vertex: where the angles of its triangles sum up to more
   * than a full turn, on the border to a half turn or more, and wherever sheets meet.
   */
  bool canTurn(Index vertex) const { return this->Turning[vertex] != 0; }

  std::size_t bytes() const
  {
    return (this->Starts.size() + this->Around.size() + this->Next.size()) * sizeof(Index) +
      this->Turning.size();
  }

private:
  void collectTriangles(const TriangleMesh& mesh);
  void linkEdges(const TriangleMesh& mesh);
  /** Notes the least half-edge of an edge, if it has more than two triangles. */
  void noteFirst(Index halfEdge);
  void addRepetition(Index triangle, Index first);
  void findTurns(const TriangleMesh& mesh);

  std::vector<Index> Starts;
  BulkVector<Index> Around;
  BulkVector<Index> Next;
  /** For half-edges of edges with more than two triangles. */
  std::unordered_map<Index, Index> FirstOfMany;
  std::vector<bool> Repeated;
  std::vector<std::pair<Index, Index>> Repetitions;
  std::vector<std::uint8_t> Turning;
};

}

#endif
