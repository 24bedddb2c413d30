// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/EdgeLowering.h"

#include "march/TriangleCost.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/DistanceField.h"
#include "solve/MarchControl.h"
#include "solve/MarchingFront.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** The vertices that were lowered, and may lower others. Labels here are the numbers of seeds. */
template <class Cost>
class EdgeLowering final : public MarchingFront
{
public:
  EdgeLowering(const TriangleMesh& mesh, const ClosedTriangles& closed, const Cost& cost,
    const SolveOptions& options, StopLimit& limit, DistanceField& field)
    : Mesh(mesh)
    , Closed(closed)
    , TriangleCost(cost)
    , Options(options)
    , Limit(limit)
    , Control(options, limit)
    , Field(field)
  {
  }

  /** Looks at the vertices that are nearly as far as the end of a label. */
  void begin(std::span<const double> ends)
  {
    for (std::size_t i = 0, count = this->Field.reached().size(); i < count; ++i)
    {
      const Index vertex = this->Field.reached()[i];
      const double farthest = this->Field.distance(vertex) + this->TriangleCost.reach(vertex);
      const Index seed = this->Field.nearestSeed(vertex);
      if (seed == NoIndex || farthest > ends[seed])
      {
        this->lowerNeighbours(vertex);
      }
    }
  }

  void advance(double limit) override
  {
    while (this->nextDistance() < limit && this->Control.mayGoOn(this->Field.reached().size()))
    {
      std::pop_heap(this->Heap.begin(), this->Heap.end(), std::greater<>());
      const auto [distance, vertex] = this->Heap.back();
      this->Heap.pop_back();
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
  double meanLongestEdge() const override
  {
    return this->Mesh.meanLongestEdge() * this->TriangleCost.mean();
  }
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
      const double distance = own + this->priceOfEdge(vertex, i) * length;
      if (distance < this->ceiling(neighbour) && distance <= this->Limit.exactly(neighbour) &&
        !this->Options.isExcluded(neighbour))
      {
        this->set(neighbour, this->Field.nearestSeed(vertex), distance);
      }
    }
  }

  /** The price of a unit of length along an edge of a vertex; infinity if no open triangle lies
   * beside it. @param i number of its entry in the vertex's ring */
  double priceOfEdge(Index vertex, std::size_t i) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    if constexpr (Cost::isUnit)
    {
      return this->Closed.isOpenEdge(vertex, i) ? 1.0 : none;
    }
    else
    {
      const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
      const auto priceOf = [&](std::size_t opening)
      {
        return this->Closed.isOpen(vertex, opening)
          ? this->TriangleCost.ofTriangle(
              vertex, ring[opening].neighbour(), ring[opening + 1].neighbour())
          : none;
      };
      return std::min(priceOf(i), i > 0 ? priceOf(i - 1) : none);
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
  const Cost& TriangleCost;
  const SolveOptions& Options;
  StopLimit& Limit;
  MarchControl Control;
  DistanceField& Field;
  std::vector<std::pair<double, Index>> Heap;
};

template <class Cost>
bool lower(const TriangleMesh& mesh, const ClosedTriangles& closed, const Cost& cost,
  const SolveOptions& options, std::span<const double> ends, Partition& partition, StopLimit& limit,
  DistanceField& field)
{
  EdgeLowering<Cost> front(mesh, closed, cost, options, limit, field);
  front.begin(ends);
  return partition.march(front, limit);
}

}

bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed, const UnitCost& cost,
  const SolveOptions& options, std::span<const double> ends, Partition& partition, StopLimit& limit,
  DistanceField& field)
{
  return lower(mesh, closed, cost, options, ends, partition, limit, field);
}

bool lowerAlongEdges(const TriangleMesh& mesh, const ClosedTriangles& closed,
  const VertexCost& cost, const SolveOptions& options, std::span<const double> ends,
  Partition& partition, StopLimit& limit, DistanceField& field)
{
  return lower(mesh, closed, cost, options, ends, partition, limit, field);
}

}
