#include "FastMarchingSolver.h"

#include "ClosedFans.h"
#include "FrontValues.h"
#include "MarchControl.h"
#include "Partition.h"
#include "QueuedFront.h"
#include "RingSweep.h"
#include "StopLimit.h"
#include "TriangleCost.h"
#include "TriangleMesh.h"

#include <utility>

namespace geodesic
{
namespace
{

/** How far ahead in the queue the mesh is fetched: the time that memory takes to answer. */
constexpr std::size_t Lookahead = 3;

}

FastMarchingSolver::FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh)
  : DistanceSolver(std::move(mesh))
{
  this->State.resize(this->mesh().numberOfVertices(), 0);
}

bool FastMarchingSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  if (!request.hasCost)
  {
    const UnitCost cost(this->mesh(), request.partition);
    const auto starts = unitStarts(request.front, request.partition);
    return this->marchAtCost(cost, starts, request, limit, field);
  }
  if (!this->UnitSolver)
  {
    this->UnitSolver = std::make_unique<FastMarchingSolver>(this->sharedMesh());
  }
  const VertexCost cost(this->mesh(), request.options.cost, request.partition);
  const auto starts = costedStarts(
    this->mesh(), request.front, request.options, request.partition, *this->UnitSolver);
  return this->marchAtCost(cost, starts, request, limit, field);
}

template <class Cost>
bool FastMarchingSolver::marchAtCost(const Cost& cost, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const double width = BucketWidthInMeanEdges * this->mesh().meanEdgeLength() * cost.mean();
  // A piece without triangles has no edges.
  this->Queue.start(
    width > 0.0 ? width : 1.0, 2.0 * this->mesh().longestEdgeLength() * cost.largest());
  if (request.front.labels.size() > 1)
  {
    return this->marchManyLabels(cost, starts, request, limit, field);
  }
  return request.front.labels[0].shape == FrontShape::Round
    ? this->marchOneLabel<FrontShape::Round>(cost, starts, request, limit, field)
    : this->marchOneLabel<FrontShape::Straight>(cost, starts, request, limit, field);
}

template <FrontShape Shape, class Cost>
bool FastMarchingSolver::marchOneLabel(const Cost& cost, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const TriangleMesh& mesh = this->mesh();
  MarchControl control(request.options, limit, mesh.numberOfVertices());
  const MarchContext<Cost> context{ mesh, cost, request.options, limit, control, field,
    this->Queue };
  const Label& label = request.front.labels[0];
  OneLabelValues<Cost> values(context, label, this->State);
  RingSweep<Shape, Cost, OneLabelValues<Cost>> ringSweep(mesh, request.closed, cost, values);

  for (const StartValue& start : starts)
  {
    values.set(start.vertex, start.value);
    if (start.isFinal)
    {
      values.pin(start.vertex);
    }
  }
  // Flat: function calls in the loop, which is there once for each kind of cost, take a tenth more.
  QueuedFront front(
    this->Queue, control, label.value, values, [&](std::uint64_t end) __attribute__((flatten)) {
      while (this->Queue.hasBefore(end) && control.mayGoOn())
      {
        const Index vertex = this->Queue.pop();
        if (const Index ahead = this->Queue.ahead(Lookahead); ahead != NoIndex)
        {
          mesh.prefetch(ahead);
        }
        values.unqueue(vertex);
        ringSweep.sweep(vertex, values.value(vertex));
      }
    });
  const bool finished = request.partition.march(front, limit);
  for (Index vertex : field.reached())
  {
    this->State[vertex] = 0;
    field.setNearestSeed(vertex, label.seed);
  }
  return finished;
}

template <class Cost>
bool FastMarchingSolver::marchManyLabels(const Cost& cost, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const TriangleMesh& mesh = this->mesh();
  const std::vector<Label>& labels = request.front.labels;
  LabelSets& sets = this->Labels;
  sets.start(mesh.numberOfVertices());
  MarchControl control(request.options, limit, mesh.numberOfVertices());
  const MarchContext<Cost> context{ mesh, cost, request.options, limit, control, field,
    this->Queue };
  using Values = LabelValues<Cost>;
  Values values(context, labels, sets);
  RingSweep<FrontShape::Round, Cost, Values> round(mesh, request.closed, cost, values);
  RingSweep<FrontShape::Straight, Cost, Values> straight(mesh, request.closed, cost, values);

  // Many small fronts spread over more memory than the processor has near. What says where to look
  // is fetched before what is there.
  const auto prefetchRound = [&]
  {
    if (const Index far = this->Queue.ahead(2 * Lookahead); far != NoIndex)
    {
      __builtin_prefetch(&sets[far]);
      mesh.rings().prefetchStart(sets.vertexOf(far));
    }
    if (const Index ahead = this->Queue.ahead(Lookahead); ahead != NoIndex)
    {
      mesh.prefetch(sets.vertexOf(ahead));
    }
    if (const Index next = this->Queue.ahead(1); next != NoIndex)
    {
      for (const RingEntry& entry : mesh.ring(sets.vertexOf(next)))
      {
        __builtin_prefetch(&sets[entry.neighbour()]);
        __builtin_prefetch(&mesh.position(entry.neighbour()));
      }
    }
  };
  for (const StartValue& start : starts)
  {
    values.setCurrent(start.label);
    const Index entry = sets.add(start.vertex, start.label);
    values.set(entry, start.value);
    sets[entry].isPinned = start.isFinal;
  }
  QueuedFront front(
    this->Queue, control, values.firstDistance(),
    values, [&](std::uint64_t end) __attribute__((flatten)) {
      while (this->Queue.hasBefore(end) && control.mayGoOn())
      {
        const Index popped = this->Queue.pop();
        prefetchRound();
        sets[popped].isQueued = false;
        const LabelSets::Entry entry = sets[popped];
        const Index vertex = sets.vertexOf(popped);
        values.setCurrent(entry.label);
        if (entry.value > values.keptUpTo(vertex))
        {
          continue;
        }
        if (labels[entry.label].shape == FrontShape::Round)
        {
          round.sweep(vertex, entry.value);
        }
        else
        {
          straight.sweep(vertex, entry.value);
        }
      }
    });
  const bool finished = request.partition.march(front, limit);
  for (Index vertex : field.reached())
  {
    field.setNearestSeed(vertex, sets.nearestSeed(vertex, field.distance(vertex), labels));
    sets.clear(vertex);
  }
  sets.finish();
  return finished;
}

}
