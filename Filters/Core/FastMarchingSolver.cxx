#include "FastMarchingSolver.h"

#include "ClosedFans.h"
#include "FieldValues.h"
#include "LabelValues.h"
#include "MarchControl.h"
#include "OneLabelValues.h"
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

/** Many small fronts spread over more memory than the processor has near. So what waits in a bucket
 * is swept by blocks of so many vertices, whose numbers go with their places. */
constexpr int BlockBits = 9;

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
  const double width = BucketWidthInEdges * this->mesh().meanLongestEdge() * cost.mean();
  // A piece without triangles has no edges.
  const bool isOneFront = request.front.labels.size() == 1;
  this->Queue.start(width > 0.0 ? width : 1.0,
    2.0 * this->mesh().longestEdgeLength() * cost.largest(), isOneFront ? 0 : BlockBits);
  if (!isOneFront)
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
  MarchControl control(request.options, limit, this->mesh().numberOfVertices());
  const MarchContext<Cost> context{ this->mesh(), cost, request.options, limit, control, field,
    this->Queue, this->State };
  OneLabelValues<Cost> values(context, request.front.labels[0]);
  RingSweep<Shape, Cost, OneLabelValues<Cost>> ringSweep(
    this->mesh(), request.closed, cost, values);
  return this->run(
    values, starts, request, limit, control, field,
    [&](Index vertex, double value) { ringSweep.sweep(vertex, value); },
    [&] { ringSweep.settle(); });
}

template <class Cost>
bool FastMarchingSolver::marchManyLabels(const Cost& cost, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  MarchControl control(request.options, limit, this->mesh().numberOfVertices());
  const MarchContext<Cost> context{ this->mesh(), cost, request.options, limit, control, field,
    this->Queue, this->State };
  using Values = LabelValues<Cost>;
  Values values(context, labels, this->Labels);
  RingSweep<FrontShape::Round, Cost, Values> round(this->mesh(), request.closed, cost, values);
  RingSweep<FrontShape::Straight, Cost, Values> straight(
    this->mesh(), request.closed, cost, values);
  const bool finished = this->run(
    values, starts, request, limit, control, field,
    [&](Index vertex, double value)
    {
      if (labels[values.current()].shape == FrontShape::Round)
      {
        round.sweep(vertex, value);
      }
      else
      {
        straight.sweep(vertex, value);
      }
    },
    [&]
    {
      round.settle();
      straight.settle();
    });
  this->Labels.finish();
  return finished;
}

template <class Values, class Sweep, class Settle>
bool FastMarchingSolver::run(Values& values, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, MarchControl& control, DistanceField& field,
  Sweep sweep, Settle settle)
{
  for (const StartValue& start : starts)
  {
    values.setCurrent(start.label);
    values.start(start.vertex, start.value, start.isFinal);
  }
  QueuedFront front(this->Queue, control, values.firstDistance(), values,
    [&](std::uint64_t end)
    {
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
          this->mesh().prefetch(values.vertexOf(next));
        }
        for (Index waiting : handful)
        {
          const TakenValue taken = values.take(waiting);
          if (taken.vertex != NoIndex)
          {
            sweep(taken.vertex, taken.value);
          }
        }
        settle();
      }
    });
  const bool finished = request.partition.march(front, limit);
  field.orderReached();
  for (Index vertex : field.reached())
  {
    field.setNearestSeed(vertex, values.nearestSeed(vertex));
    values.clear(vertex);
  }
  return finished;
}

}
