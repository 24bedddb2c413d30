#include "FastMarchingSolver.h"

#include "ClosedFans.h"
#include "MarchControl.h"
#include "RingSweep.h"
#include "StopLimit.h"
#include "TriangleCost.h"
#include "TriangleMesh.h"

#include <algorithm>

namespace geodesic
{
namespace
{

constexpr std::uint8_t Queued = 1;
constexpr std::uint8_t Pinned = 2;

/** Width of the queue's buckets; 0.25 to 1 serve about equally well. */
constexpr double BucketWidthInMeanEdges = 0.5;

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
  StraightLineBound(const TriangleMesh& mesh, const Label& label, double smallestCost)
    : Mesh(mesh)
    , Origin(label.shape == FrontShape::Round ? mesh.positionOf(label.origin) : Vector3{})
    , Cost(label.shape == FrontShape::Round ? smallestCost : 0.0)
  {
  }

  double operator()(Index vertex) const
  {
    return this->Cost * norm(this->Mesh.position(vertex) - this->Origin);
  }

private:
  const TriangleMesh& Mesh;
  Vector3 Origin;
  double Cost;
};

}

FastMarchingSolver::FastMarchingSolver(std::shared_ptr<const TriangleMesh> mesh)
  : DistanceSolver(std::move(mesh))
{
  this->State.resize(this->mesh().numberOfVertices(), 0);
}

bool FastMarchingSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  if (request.options.cost.empty())
  {
    const UnitCost cost(this->mesh());
    return this->marchAtCost(cost, unitStarts(request.front), request, limit, field);
  }
  if (!this->UnitSolver)
  {
    this->UnitSolver = std::make_unique<FastMarchingSolver>(this->sharedMesh());
  }
  const VertexCost cost(this->mesh(), request.options.cost);
  const auto starts = costedStarts(this->mesh(), request.front, request.options, *this->UnitSolver);
  return this->marchAtCost(cost, starts, request, limit, field);
}

template <class Cost>
bool FastMarchingSolver::marchAtCost(const Cost& cost, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  this->Queue.start(BucketWidthInMeanEdges * this->mesh().meanEdgeLength() * cost.mean(),
    2.0 * this->mesh().longestEdgeLength() * cost.largest());
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
  const double offset = request.front.labels[0].value;
  MarchControl control(request.options, limit, mesh.numberOfVertices());
  const StraightLineBound leastOf(mesh, request.front.labels[0], cost.smallest());
  const auto valueOf = [&](Index vertex) { return field.distance(vertex) - offset; };
  const auto ceilingOf = [&](Index vertex, double value)
  { return std::min(value * control.keptFraction(), limit.with(cost.reach(vertex)) - offset); };
  const auto propose = [&](Index vertex, double value)
  {
    const double old = valueOf(vertex);
    std::uint8_t& state = this->State[vertex];
    value = std::max(value, leastOf(vertex));
    if (!(value < ceilingOf(vertex, old)) || (state & Pinned) || request.options.isExcluded(vertex))
    {
      return old;
    }
    field.setDistance(vertex, value + offset);
    if (!(state & Queued))
    {
      state |= Queued;
      this->Queue.push(vertex, value);
    }
    return value;
  };

  for (const StartValue& start : starts)
  {
    field.setDistance(start.vertex, start.value + offset);
    this->State[start.vertex] = start.isFinal ? Pinned | Queued : Queued;
    this->Queue.push(start.vertex, start.value);
  }
  while (!this->Queue.isEmpty() && control.mayGoOn())
  {
    const Index vertex = this->Queue.pop();
    this->State[vertex] &= ~Queued;
    sweepRing<Shape>(
      mesh, request.closed, cost, vertex, valueOf(vertex), valueOf, ceilingOf, propose);
  }
  for (Index vertex : field.reached())
  {
    this->State[vertex] = 0;
    field.setNearestSeed(vertex, request.front.labels[0].seed);
  }
  return !control.isCancelled();
}

template <class Cost>
bool FastMarchingSolver::marchManyLabels(const Cost& cost, std::span<const StartValue> starts,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  const TriangleMesh& mesh = this->mesh();
  const std::vector<Label>& labels = request.front.labels;
  LabelSets& sets = this->Labels;
  sets.start(mesh.numberOfVertices());
  const double first = smallestValue(labels);
  MarchControl control(request.options, limit, mesh.numberOfVertices());
  const auto lower = [&](Index entry, double value)
  {
    const Index vertex = sets[entry].vertex;
    sets[entry].value = value;
    const double distance = value + labels[sets[entry].label].value;
    if (distance < field.distance(vertex))
    {
      field.setDistance(vertex, distance);
    }
    if (!sets[entry].isQueued)
    {
      sets[entry].isQueued = true;
      this->Queue.push(entry, distance - first);
    }
  };
  const auto keptUpTo = [&](Index vertex)
  { return field.distance(vertex) + LabelSets::MarginInEdges * cost.reach(vertex); };

  for (const StartValue& start : starts)
  {
    const Index entry = sets.add(start.vertex, start.label);
    sets[entry].isPinned = start.isFinal;
    lower(entry, start.value);
  }
  while (!this->Queue.isEmpty() && control.mayGoOn())
  {
    const Index popped = this->Queue.pop();
    sets[popped].isQueued = false;
    const LabelSets::Entry current = sets[popped];
    const double offset = labels[current.label].value;
    const StraightLineBound leastOf(mesh, labels[current.label], cost.smallest());
    if (current.value + offset > keptUpTo(current.vertex))
    {
      continue;
    }
    const auto valueOf = [&](Index vertex) { return sets.value(vertex, current.label); };
    const auto ceilingOf = [&](Index vertex, double value)
    {
      return std::min(value * control.keptFraction(),
        std::min(keptUpTo(vertex), limit.with(cost.reach(vertex))) - offset);
    };
    const auto propose = [&](Index vertex, double value)
    {
      const Index known = sets.find(vertex, current.label);
      const double old = known == NoIndex ? DistanceField::Unreached : sets[known].value;
      value = std::max(value, leastOf(vertex));
      if (!(value < ceilingOf(vertex, old)) || request.options.isExcluded(vertex) ||
        (known != NoIndex && sets[known].isPinned))
      {
        return old;
      }
      lower(known == NoIndex ? sets.add(vertex, current.label) : known, value);
      return value;
    };
    if (labels[current.label].shape == FrontShape::Round)
    {
      sweepRing<FrontShape::Round>(
        mesh, request.closed, cost, current.vertex, current.value, valueOf, ceilingOf, propose);
    }
    else
    {
      sweepRing<FrontShape::Straight>(
        mesh, request.closed, cost, current.vertex, current.value, valueOf, ceilingOf, propose);
    }
  }
  for (Index vertex : field.reached())
  {
    field.setNearestSeed(vertex, sets.nearestSeed(vertex, field.distance(vertex), labels));
  }
  sets.clear(field.reached());
  return !control.isCancelled();
}

}
