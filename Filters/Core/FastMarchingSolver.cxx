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

#include <array>
#include <utility>

namespace geodesic
{
namespace
{

/** So many vertices are swept before what their crossings gave is proposed. They are of one bucket,
 * so hardly any of them gains by another. Meanwhile the mesh round the next ones is fetched. */
constexpr std::size_t Handful = 12;

}

FastMarchingSolver::FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh)
  : DistanceSolver(std::move(mesh))
{
  this->State.resize(this->mesh().numberOfVertices());
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
      std::array<Index, Handful> room;
      while (this->Queue.hasBefore(end))
      {
        const std::span<const Index> handful = this->Queue.take(room);
        if (!control.mayGoOn(handful.size()))
        {
          break;
        }
        for (Index next : this->Queue.next(Handful))
        {
          mesh.prefetch(next);
        }
        for (Index vertex : handful)
        {
          values.unqueue(vertex);
          ringSweep.sweep(vertex, values.value(vertex));
        }
        ringSweep.settle();
      }
    });
  const bool finished = request.partition.march(front, limit);
  for (Index vertex : field.reached())
  {
    this->State[vertex] = {};
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
  const auto prefetchNext = [&]
  {
    const std::span<const Index> next = this->Queue.next(2 * Handful);
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      if (i < Handful)
      {
        mesh.prefetch(sets.vertexOf(next[i]));
      }
      else
      {
        __builtin_prefetch(&sets[next[i]]);
        mesh.rings().prefetchStart(sets.vertexOf(next[i]));
      }
    }
  };
  const auto prefetchNeighbours = [&](Index vertex)
  {
    for (const RingEntry& entry : mesh.ring(vertex))
    {
      __builtin_prefetch(&sets[entry.neighbour()]);
      __builtin_prefetch(&mesh.position(entry.neighbour()));
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
      std::array<Index, Handful> room;
      while (this->Queue.hasBefore(end))
      {
        const std::span<const Index> handful = this->Queue.take(room);
        if (!control.mayGoOn(handful.size()))
        {
          break;
        }
        prefetchNext();
        for (std::size_t i = 0; i < handful.size(); ++i)
        {
          if (i + 1 < handful.size())
          {
            prefetchNeighbours(sets.vertexOf(handful[i + 1]));
          }
          LabelSets::Entry& taken = sets[handful[i]];
          taken.isQueued = false;
          values.setCurrent(taken.label);
          const double value = sets[handful[i]].value;
          const Index vertex = sets.vertexOf(handful[i]);
          if (value > values.keptUpTo(vertex))
          {
            continue;
          }
          if (labels[values.current()].shape == FrontShape::Round)
          {
            round.sweep(vertex, value);
          }
          else
          {
            straight.sweep(vertex, value);
          }
        }
        round.settle();
        straight.settle();
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
