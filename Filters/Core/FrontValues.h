#ifndef geodesic_FrontValues_h
#define geodesic_FrontValues_h

#include "BucketQueue.h"
#include "DistanceField.h"
#include "LabelSets.h"
#include "MarchControl.h"
#include "MarchingFront.h"
#include "RingSweep.h"
#include "SeedFront.h"
#include "SolveOptions.h"
#include "StopLimit.h"
#include "TriangleMesh.h"
#include "VertexState.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace geodesic
{

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

/** The values of the only label: the field itself, but for the value of the seed. */
template <class Cost>
class OneLabelValues
{
public:
  OneLabelValues(
    const MarchContext<Cost>& context, const Label& label, std::span<VertexState> state)
    : Context(context)
    , LeastOf(label, context.cost.smallest())
    , Offset(label.value)
    , State(state)
    , Distances(context.field.distances())
    , Positions(context.mesh.positions())
  {
  }

  Index current() const { return 0; }
  void setCurrent(Index) {}
  double keyOf(double value) const { return value; }

  void visit(Index vertex, const MarchingFront::Visit& visit) const
  {
    if (this->Context.field.isReached(vertex))
    {
      visit(0, this->value(vertex));
    }
  }

  double value(Index vertex) const { return this->Distances[vertex] - this->Offset; }

  FrontValue look(Index vertex) const
  {
    const double value = this->value(vertex);
    return { value, value, this->State[vertex].isQueued };
  }

  double ceiling(Index vertex, double value) const
  {
    const double counts = value * this->Context.control.keptFraction();
    return this->Context.limit.isNone()
      ? counts
      : std::min(counts, this->Context.limit.with(this->Context.cost.reach(vertex)) - this->Offset);
  }

  FrontValue propose(Index vertex, double value)
  {
    const double old = this->value(vertex);
    value = this->LeastOf.raised(value, this->Positions[vertex]);
    if (!(value < this->ceiling(vertex, old)) || this->State[vertex].isPinned ||
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
    if (!this->State[vertex].isQueued)
    {
      this->State[vertex].isQueued = true;
      this->Context.queue.push(vertex, value);
    }
  }

  /** Keeps the value, whatever is proposed. */
  void pin(Index vertex) { this->State[vertex].isPinned = true; }
  /** To be called as the vertex is taken from the queue. */
  void unqueue(Index vertex) { this->State[vertex].isQueued = false; }

private:
  const MarchContext<Cost>& Context;
  StraightLineBound LeastOf;
  double Offset;
  std::span<VertexState> State;
  std::span<const double> Distances;
  std::span<const Vector3> Positions;
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
    , First(smallestOf(labels))
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

  Index current() const { return this->Current; }

  FrontValue look(Index vertex) const
  {
    // Away from borders a vertex has a value for this label, or none at all.
    const LabelSets::Entry& first = this->Sets[vertex];
    if (first.label == this->Current || first.label == LabelSets::NoLabel) [[likely]]
    {
      return { first.value, first.value, first.isQueued != 0 };
    }
    const Index known = this->Sets.find(vertex, this->Current);
    if (known == NoIndex)
    {
      return { DistanceField::Unreached, this->keptUpTo(vertex), false };
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
    const double kept =
      std::min(value * this->Context.control.keptFraction(), this->keptUpTo(vertex));
    return this->Context.limit.isNone()
      ? kept
      : std::min(kept, this->Context.limit.with(this->Context.cost.reach(vertex)) - this->Offset);
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
  static double smallestOf(std::span<const Label> labels)
  {
    return std::min_element(labels.begin(), labels.end(),
      [](const Label& a, const Label& b) { return a.value < b.value; })
      ->value;
  }

  const MarchContext<Cost>& Context;
  std::span<const Label> Labels;
  LabelSets& Sets;
  std::vector<StraightLineBound> LeastOf;
  double First;
  Index Current = 0;
  double Offset = 0.0;
};

}

#endif
