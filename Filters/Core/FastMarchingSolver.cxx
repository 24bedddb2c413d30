#include "FastMarchingSolver.h"

#include "ClosedFans.h"
#include "MarchControl.h"
#include "Partition.h"
#include "RingSweep.h"
#include "StopLimit.h"
#include "TriangleCost.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geodesic
{
namespace
{

constexpr std::uint8_t Queued = 1;
constexpr std::uint8_t Pinned = 2;

/** Width of the queue's buckets; 0.1 to 0.5 serve about equally well. */
constexpr double BucketWidthInMeanEdges = 0.25;

/** How far ahead in the queue the mesh is fetched: the time that memory takes to answer. */
constexpr std::size_t Lookahead = 3;

double smallestValue(std::span<const Label> labels)
{
  return std::min_element(
    labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.value < b.value; })
    ->value;
}

/**
 * No way is shorter than the straight line to where a round front starts. Holding updates to that
 * keeps them monotone, and keeps rounding from growing from update to update where triangles lie on
 * each other over the source: there the update's slope exceeds 1.
 */
class StraightLineBound
{
public:
  StraightLineBound(const Label& label, double smallestCost)
    : Origin(label.position)
    , SquaredCost(label.shape == FrontShape::Round ? smallestCost * smallestCost : 0.0)
  {
  }

  /** @p value, or the bound at @p position where that is more. */
  double raised(double value, const Vector3& position) const
  {
    const Vector3 away = position - this->Origin;
    const double square = this->SquaredCost * dot(away, away);
    return value * value < square ? std::sqrt(square) : value;
  }

private:
  Vector3 Origin;
  double SquaredCost;
};

/** What the values of every label have in common; see RingSweep. */
template <class Cost>
struct MarchContext
{
  const TriangleMesh& mesh;
  const Cost& cost;
  const SolveOptions& options;
  const StopLimit& limit;
  const MarchControl& control;
  DistanceField& field;
  BucketQueue& queue;
};

/** A march as a Partition sees it; @p Values and @p advance are the march. */
template <class Values, class Advance>
class QueuedFront final : public MarchingFront
{
public:
  /** @param firstDistance the distance of the queue's key 0 */
  QueuedFront(BucketQueue& queue, const MarchControl& control, double firstDistance, Values& values,
    Advance advance)
    : Queue(queue)
    , Control(control)
    , FirstDistance(firstDistance)
    , FrontValues(values)
    , AdvanceBefore(std::move(advance))
  {
  }

  void advance(double limit) override
  {
    this->AdvanceBefore(this->Queue.bucketOf(limit - this->FirstDistance));
  }

  double nextDistance() const override
  {
    return this->Queue.isEmpty() ? DistanceField::Unreached
                                 : this->FirstDistance + this->Queue.nextKey();
  }

  double meanEdge() const override { return this->Queue.width() / BucketWidthInMeanEdges; }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  bool isCancelled() const override { return this->Control.isCancelled(); }

  void visitValues(Index vertex, const Visit& visit) const override
  {
    this->FrontValues.visit(vertex, visit);
  }

  void lower(Index vertex, Index label, double value) override
  {
    this->FrontValues.setCurrent(label);
    this->Queue.goBackTo(this->FrontValues.keyOf(value));
    this->FrontValues.propose(vertex, value);
  }

private:
  BucketQueue& Queue;
  const MarchControl& Control;
  double FirstDistance;
  Values& FrontValues;
  Advance AdvanceBefore;
};

/** The values of the only label: the field itself, but for the value of the seed. */
template <class Cost>
class OneLabelValues
{
public:
  OneLabelValues(
    const MarchContext<Cost>& context, const Label& label, std::span<std::uint8_t> state)
    : Context(context)
    , LeastOf(label, context.cost.smallest())
    , Offset(label.value)
    , State(state)
  {
  }

  void setCurrent(Index) {}
  double keyOf(double value) const { return value; }

  void visit(Index vertex, const MarchingFront::Visit& visit) const
  {
    if (this->Context.field.isReached(vertex))
    {
      visit(0, this->value(vertex));
    }
  }

  double value(Index vertex) const { return this->Context.field.distance(vertex) - this->Offset; }

  FrontValue look(Index vertex) const
  {
    const double value = this->value(vertex);
    return { value, value, (this->State[vertex] & Queued) != 0 };
  }

  double ceiling(Index vertex, double value) const
  {
    const double reach = this->Context.cost.reach(vertex);
    return std::min(
      value * this->Context.control.keptFraction(), this->Context.limit.with(reach) - this->Offset);
  }

  FrontValue propose(Index vertex, double value)
  {
    const double old = this->value(vertex);
    value = this->LeastOf.raised(value, this->Context.mesh.position(vertex));
    if (!(value < this->ceiling(vertex, old)) || (this->State[vertex] & Pinned) ||
      this->Context.options.isExcluded(vertex))
    {
      return this->look(vertex);
    }
    this->set(vertex, value);
    return { value, value, true };
  }

  void set(Index vertex, double value)
  {
    this->Context.field.setDistance(vertex, value + this->Offset);
    if (!(this->State[vertex] & Queued))
    {
      this->State[vertex] |= Queued;
      this->Context.queue.push(vertex, value);
    }
  }

private:
  const MarchContext<Cost>& Context;
  StraightLineBound LeastOf;
  double Offset;
  std::span<std::uint8_t> State;
};

/** The values of one of several labels, the current one. */
template <class Cost>
class LabelValues
{
public:
  LabelValues(const MarchContext<Cost>& context, std::span<const Label> labels, LabelSets& sets)
    : Context(context)
    , Labels(labels)
    , Sets(sets)
    , First(smallestValue(labels))
  {
    this->LeastOf.reserve(labels.size());
    for (const Label& label : labels)
    {
      this->LeastOf.emplace_back(label, context.cost.smallest());
    }
  }

  void setCurrent(Index label)
  {
    this->Current = label;
    this->Offset = this->Labels[label].value;
  }

  FrontValue look(Index vertex) const
  {
    const Index known = this->Sets.find(vertex, this->Current);
    if (known == NoIndex)
    {
      const double kept =
        this->Sets.isEmpty(vertex) ? DistanceField::Unreached : this->keptUpTo(vertex);
      return { DistanceField::Unreached, kept, false };
    }
    const LabelSets::Entry& entry = this->Sets[known];
    return { entry.value, entry.value, entry.isQueued != 0 };
  }

  /** The values that the vertex keeps, by label. */
  void visit(Index vertex, const MarchingFront::Visit& visit)
  {
    this->Sets.visit(vertex,
      [&](const LabelSets::Entry& entry)
      {
        this->setCurrent(entry.label);
        if (entry.value <= this->keptUpTo(vertex))
        {
          visit(entry.label, entry.value);
        }
      });
  }

  double firstDistance() const { return this->First; }
  /** The place in the queue of a value of the current label. */
  double keyOf(double value) const { return value + this->Offset - this->First; }

  /** The largest value of the current label that a vertex keeps beside its best one. */
  double keptUpTo(Index vertex) const
  {
    return this->Context.field.distance(vertex) + this->Context.cost.margin(vertex) - this->Offset;
  }

  double ceiling(Index vertex, double value) const
  {
    const double reach = this->Context.cost.reach(vertex);
    return std::min({ value * this->Context.control.keptFraction(), this->keptUpTo(vertex),
      this->Context.limit.with(reach) - this->Offset });
  }

  FrontValue propose(Index vertex, double value)
  {
    const Index known = this->Sets.find(vertex, this->Current);
    const bool isNew = known == NoIndex;
    const double old = isNew ? DistanceField::Unreached : this->Sets[known].value;
    value = this->LeastOf[this->Current].raised(value, this->Context.mesh.position(vertex));
    if (!(value < this->ceiling(vertex, old)) || this->Context.options.isExcluded(vertex) ||
      (!isNew && this->Sets[known].isPinned))
    {
      return { old, std::min(old, this->keptUpTo(vertex)), !isNew && this->Sets[known].isQueued };
    }
    this->set(isNew ? this->Sets.add(vertex, this->Current) : known, value);
    return { value, value, true };
  }

  void set(Index number, double value)
  {
    LabelSets::Entry& entry = this->Sets[number];
    entry.value = value;
    const Index vertex = this->Sets.vertexOf(number);
    const double distance = value + this->Offset;
    if (distance < this->Context.field.distance(vertex))
    {
      this->Context.field.setDistance(vertex, distance);
    }
    if (!entry.isQueued)
    {
      entry.isQueued = true;
      this->Context.queue.push(number, this->keyOf(value));
    }
  }

private:
  const MarchContext<Cost>& Context;
  std::span<const Label> Labels;
  LabelSets& Sets;
  std::vector<StraightLineBound> LeastOf;
  double First;
  Index Current = 0;
  double Offset = 0.0;
};

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
    this->State[start.vertex] |= start.isFinal ? Pinned : 0;
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
        this->State[vertex] &= ~Queued;
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
