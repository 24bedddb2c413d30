// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/EdgeLowering.h"

#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/DistanceField.h"
#include "solve/MarchControl.h"
#include "solve/MarchingFront.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** The vertices that were lowered, and may lower others. Labels here are the numbers of seeds. */
class EdgeLowering final : public MarchingFront
{
public:
  EdgeLowering(const TriangleMesh& mesh, const ClosedTriangles& closed, const SolveOptions& options,
    StopLimit& limit, DistanceField& field)
    : Mesh(mesh)
    , Closed(closed)
    , Options(options)
    , Limit(limit)
    , Control(options, limit)
    , Field(field)
  {
  }

  /** Lowers the neighbours of some vertices. */
  void begin(std::span<const Index> vertices)
  {
    for (const Index vertex : vertices)
    {
      this->lowerNeighbours(vertex);
    }
  }

  void advance(double limit, std::vector<Index>* taken) override
  {
    while (this->nextDistance() < limit && this->Control.mayGoOn(this->Field.reached().size()))
    {
      std::pop_heap(this->Heap.begin(), this->Heap.end(), std::greater<>());
      const auto [distance, vertex] = this->Heap.back();
      this->Heap.pop_back();
      if (taken)
      {
        taken->push_back(vertex);
      }
      if (distance == this->Field.distance(vertex))
      {
        this->lowerNeighbours(vertex);
      }
    }
  }

  double nextDistance() const override
  {
    return this->Heap.empty() ? DistanceField::Unreached : this->Heap.front().first;
  }
  double meanLongestEdge() const override { return this->Mesh.meanLongestEdge(); }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  bool isCancelled() const override { return this->Control.isCancelled(); }

  void visitValues(Index vertex, const Visit& visit) const override
  {
    if (this->Field.isReached(vertex))
    {
      visit(this->Field.nearestSeed(vertex), this->Field.distance(vertex));
    }
  }

  void lower(Index vertex, Index label, double value) override
  {
    if (value < this->ceiling(vertex))
    {
      this->set(vertex, label, value);
    }
  }

private:
  /** Only distances below this one count at a vertex. */
  double ceiling(Index vertex) const
  {
    return this->Field.distance(vertex) * this->Control.keptFraction();
  }

  void lowerNeighbours(Index vertex)
  {
    const double own = this->Field.distance(vertex);
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Index neighbour = ring[i].neighbour();
      const double length = norm(this->Mesh.position(neighbour) - this->Mesh.position(vertex));
      const double distance = own + length;
      if (this->Closed.isOpenEdge(vertex, i) && distance < this->ceiling(neighbour) &&
        distance <= this->Limit.exactly(neighbour) && !this->Options.isExcluded(neighbour))
      {
        this->set(neighbour, this->Field.nearestSeed(vertex), distance);
      }
    }
  }

  void set(Index vertex, Index seed, double distance)
  {
    this->Field.setDistance(vertex, distance);
    this->Field.setNearestSeed(vertex, seed);
    this->Heap.emplace_back(distance, vertex);
    std::push_heap(this->Heap.begin(), this->Heap.end(), std::greater<>());
  }

  const TriangleMesh& Mesh;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  StopLimit& Limit;
  MarchControl Control;
  DistanceField& Field;
  std::vector<std::pair<double, Index>> Heap;
};

}

bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const SolveOptions& options, std::span<const Index> from, Partition& partition, StopLimit& limit,
  DistanceField& field)
{
  EdgeLowering front(mesh, closed, options, limit, field);
  front.begin(from);
  return partition.march(front, limit);
}

}
