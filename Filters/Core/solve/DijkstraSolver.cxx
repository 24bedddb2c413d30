// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/DijkstraSolver.h"

#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/CostedStart.h"
#include "solve/MarchControl.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace geodesic
{
namespace
{

/** The heap's order: the least bound first, of equal ones that of the smaller seed. */
bool isAfter(const EdgeTrial& a, const EdgeTrial& b)
{
  return std::tie(a.bound, a.seed) > std::tie(b.bound, b.seed);
}

/** A front that spreads along edges. A vertex keeps one value, that of its nearest seed; a label
 * here is the number of a seed. */
class EdgeFront final : public MarchingFront
{
public:
  EdgeFront(const TriangleMesh& mesh, const ClosedTriangles& closed, const SolveOptions& options,
    const StopLimit& limit, MarchControl& control, DistanceField& field,
    std::vector<EdgeTrial>& heap)
    : Mesh(mesh)
    , Closed(closed)
    , Options(options)
    , Limit(limit)
    , Control(control)
    , Field(field)
    , Heap(heap)
  {
    this->Heap.clear();
  }

  /** Sets a distance that is less, or equal and of a smaller seed, and within the limit. */
  void propose(Index vertex, Index seed, double distance)
  {
    const double old = this->Field.distance(vertex);
    const bool isBetter =
      distance < old || (distance == old && seed < this->Field.nearestSeed(vertex));
    if (isBetter && distance <= this->Limit.exactly(vertex) && !this->Options.isExcluded(vertex))
    {
      this->Field.setDistance(vertex, distance);
      this->Field.setNearestSeed(vertex, seed);
      this->Heap.push_back({ distance + this->Limit.leftFrom(vertex), distance, vertex, seed });
      std::push_heap(this->Heap.begin(), this->Heap.end(), isAfter);
    }
  }

  void advance(double limit, std::vector<Index>* taken) override
  {
    while (this->nextDistance() < limit && this->Control.mayGoOn(this->Field.reached().size()))
    {
      std::pop_heap(this->Heap.begin(), this->Heap.end(), isAfter);
      const EdgeTrial trial = this->Heap.back();
      this->Heap.pop_back();
      if (taken)
      {
        taken->push_back(trial.vertex);
      }
      // An item is out of date where a better one for its vertex was proposed after it.
      if (trial.distance == this->Field.distance(trial.vertex) &&
        trial.seed == this->Field.nearestSeed(trial.vertex))
      {
        this->updateNeighbours(trial);
      }
    }
  }

  double nextDistance() const override
  {
    return this->Heap.empty() ? DistanceField::Unreached : this->Heap.front().bound;
  }

  double meanLongestEdge() const override
  {
    const std::span<const double> cost = this->Options.cost;
    const double sum = std::accumulate(cost.begin(), cost.end(), 0.0);
    const double mean = cost.empty() ? 1.0 : sum / static_cast<double>(cost.size());
    return mean * this->Mesh.meanLongestEdge();
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
    this->propose(vertex, label, value);
  }

private:
  void updateNeighbours(const EdgeTrial& trial)
  {
    const Vector3 centre = this->Mesh.position(trial.vertex);
    const std::span<const RingEntry> ring = this->Mesh.ring(trial.vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (this->Closed.isOpenEdge(trial.vertex, i))
      {
        const Index neighbour = ring[i].neighbour();
        const double length = norm(this->Mesh.position(neighbour) - centre);
        const double meanCost = 0.5 * (this->costOf(trial.vertex) + this->costOf(neighbour));
        this->propose(neighbour, trial.seed, trial.distance + length * meanCost);
      }
    }
  }

  double costOf(Index vertex) const
  {
    return this->Options.cost.empty() ? 1.0 : this->Options.cost[vertex];
  }

  const TriangleMesh& Mesh;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  const StopLimit& Limit;
  MarchControl& Control;
  DistanceField& Field;
  std::vector<EdgeTrial>& Heap;
};

}

DijkstraSolver::DijkstraSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
{
}

bool DijkstraSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  MarchControl control(request.options, limit);
  EdgeFront front(this->mesh(), request.closed, request.options, limit, control, field, this->Heap);
  for (const StartValue& start : this->starts(request))
  {
    const Label& label = request.front.labels[start.label];
    front.propose(start.vertex, label.seed, label.value + start.value);
  }
  return request.partition.march(front, limit);
}

std::vector<StartValue> DijkstraSolver::starts(const Request& request) const
{
  const std::span<const double> cost = request.options.cost;
  const std::vector<Label>& labels = request.front.labels;
  std::vector<double> atOrigins(labels.size(), 1.0);
  for (std::size_t i = 0; i < labels.size() && request.hasCost; ++i)
  {
    if (labels[i].shape == FrontShape::Round)
    {
      atOrigins[i] = costAtOrigin(this->mesh(), cost, labels[i], request.partition);
    }
  }
  std::vector<StartValue> starts = unitStarts(request.front, request.partition);
  for (StartValue& start : starts)
  {
    const double atVertex = cost.empty() ? 1.0 : cost[start.vertex];
    const bool isRound = labels[start.label].shape == FrontShape::Round;
    start.value *= 0.5 * ((isRound ? atOrigins[start.label] : atVertex) + atVertex);
  }
  return starts;
}

}
