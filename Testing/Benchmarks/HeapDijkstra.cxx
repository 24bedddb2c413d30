// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeapDijkstra.h"

#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <limits>

namespace geodesic::testing
{
namespace
{
constexpr std::size_t Children = 4;
}

HeapDijkstra::HeapDijkstra(const TriangleMesh& mesh, std::span<const double> cost)
  : Distances(mesh.numberOfVertices())
  , Places(mesh.numberOfVertices(), NoIndex)
{
  std::vector<Index> neighbours;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    this->Starts.push_back(static_cast<Index>(this->Edges.size()));
    neighbours.clear();
    for (const RingEntry& entry : mesh.ring(v))
    {
      neighbours.push_back(entry.neighbour());
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (Index n : neighbours)
    {
      const double weight = cost.empty() ? 1.0 : 0.5 * (cost[v] + cost[n]);
      this->Edges.push_back({ weight * norm(mesh.position(n) - mesh.position(v)), n });
    }
  }
  this->Starts.push_back(static_cast<Index>(this->Edges.size()));
}

void HeapDijkstra::lower(Index vertex, double distance)
{
  this->Distances[vertex] = distance;
  std::size_t place = this->Places[vertex];
  if (place == NoIndex)
  {
    place = this->Heap.size();
    this->Heap.push_back({});
  }
  while (place > 0 && distance < this->Heap[(place - 1) / Children].distance)
  {
    const std::size_t parent = (place - 1) / Children;
    this->put(place, this->Heap[parent]);
    place = parent;
  }
  this->put(place, { distance, vertex });
}

HeapDijkstra::Trial HeapDijkstra::takeFirst()
{
  const Trial first = this->Heap.front();
  this->Places[first.vertex] = NoIndex;
  const Trial last = this->Heap.back();
  this->Heap.pop_back();
  const std::size_t size = this->Heap.size();
  std::size_t place = 0;
  for (std::size_t child = 1; child < size; child = Children * place + 1)
  {
    const std::size_t end = std::min(child + Children, size);
    std::size_t least = child;
    for (std::size_t other = child + 1; other < end; ++other)
    {
      least = this->Heap[other].distance < this->Heap[least].distance ? other : least;
    }
    if (!(this->Heap[least].distance < last.distance))
    {
      break;
    }
    this->put(place, this->Heap[least]);
    place = least;
  }
  if (size > 0)
  {
    this->put(place, last);
  }
  return first;
}

const std::vector<double>& HeapDijkstra::solve(Index source)
{
  std::fill(
    this->Distances.begin(), this->Distances.end(), std::numeric_limits<double>::infinity());
  this->lower(source, 0.0);
  while (!this->Heap.empty())
  {
    const Trial trial = this->takeFirst();
    for (Index e = this->Starts[trial.vertex]; e < this->Starts[trial.vertex + 1]; ++e)
    {
      const double through = trial.distance + this->Edges[e].length;
      if (through < this->Distances[this->Edges[e].to])
      {
        this->lower(this->Edges[e].to, through);
      }
    }
  }
  return this->Distances;
}

}
