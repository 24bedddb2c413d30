// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_HeapDijkstra_h
#define geodesic_testing_HeapDijkstra_h

#include "base/Index.h"

#include <span>
#include <vector>

namespace geodesic
{
class TriangleMesh;
}

namespace geodesic::testing
{

/**
 * The yardstick: Dijkstra's algorithm along the edges, on flat arrays in the mesh's own order, edge
 * lengths stored, with an indexed heap of four children a node. Of the heaps tried
 * (std::priority_queue, lazy ones of 2, 4 and 8 children, indexed ones of 2 and 4) it was the
 * fastest, or within noise of it, on every mesh.
 */
class HeapDijkstra
{
public:
  /** @param cost of a unit of length at each vertex; an edge's is the mean of its ends'. Empty: 1.
   */
  explicit HeapDijkstra(const TriangleMesh& mesh, std::span<const double> cost = {});

  /** Distances from a vertex to all others, valid until the next call; +infinity where unreached.
   */
  const std::vector<double>& solve(Index source);

private:
  struct Edge
  {
    double length;
    Index to;
  };

  struct Trial
  {
    double distance;
    Index vertex;
  };

  void put(std::size_t place, const Trial& trial)
  {
    this->Heap[place] = trial;
    this->Places[trial.vertex] = static_cast<Index>(place);
  }
  void lower(Index vertex, double distance);
  Trial takeFirst();

  std::vector<Index> Starts;
  std::vector<Edge> Edges;
  std::vector<double> Distances;
  std::vector<Trial> Heap;
  /** Of each vertex in the heap; NoIndex outside. */
  std::vector<Index> Places;
};

}

#endif
