// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/ReferenceSolver.h"

#include "march/BucketQueue.h"
#include "march/EikonalUpdate.h"
#include "march/HigherBounds.h"
#include "march/HubTies.h"
#include "march/LabelBounds.h"
#include "march/ReferenceValues.h"
#include "march/SourceFront.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/MarchControl.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <array>

namespace geodesic
{
namespace
{

/**
 * The march of all labels on one mesh, with the algorithm's loop in advance(). A vertex has a value
 * for each label whose value there is within a margin of the best one.
 */
template <class Cost>
class ReferenceFront final : public MarchingFront
{
public:
  ReferenceFront(const TriangleMesh& mesh, const Cost& cost, std::span<const Label> labels,
    LabelBounds* bounds, const ClosedTriangles& closed, const SolveOptions& options,
    StopLimit& limit, DistanceField& field)
    : Mesh(mesh)
    , TriangleCost(cost)
    , Labels(labels)
    , Bounds(bounds)
    , Closed(closed)
    , Options(options)
    , Limit(limit)
    , Control(options, limit)
    , Field(field)
    , First(leastSeedValue(labels))
    , Values(mesh.numberOfVertices())
  {
    // Any width gives the same field.
    const double width = 0.25 * this->meanLongestEdge();
    this->Queue.start(width > 0.0 ? width : 1.0, 2.0 * mesh.longestEdgeLength() * cost.largest(),
      cost.queueOrder());
  }

  /** Gives a vertex a start value and puts it into the queue. */
  void start(const StartValue& first)
  {
    const Index number = this->Values.findOrAdd(first.vertex, first.label);
    this->Values[number].isFinal = first.isFinal;
    this->set(number, first.value, first.isIdle);
  }

  void advance(double limit, std::vector<Index>* taken) override
  {
    std::uint64_t end = this->Queue.bucketOf(limit - this->First);
    if (this->nextDistance() < limit)
    {
      // A bucket may be wider than the step to the limit; some of what waits is taken all the same.
      end = std::max(end, this->Queue.nextBucket() + 1);
    }
    // The queue hands out several at a time; one is taken here.
    std::array<Index, 1> room;
    while (this->Queue.hasBefore(end) && this->Control.mayGoOn(this->Values.size()))
    {
      ReferenceValue& first = this->Values[this->Queue.take(room)[0]];
      if (!first.isQueued)
      {
        continue;
      }
      first.isQueued = false;
      if (taken)
      {
        taken->push_back(first.vertex);
      }
      // It is dropped where another label has come so much nearer that it is beyond the margin.
      if (this->distance(first) <= this->keptUpTo(first.vertex))
      {
        // A copy, as values may be added, and so moved, meanwhile.
        this->updateNeighbours(ReferenceValue(first));
      }
    }
  }

  double nextDistance() const override
  {
    return this->Queue.isEmpty() ? DistanceField::Unreached
                                 : this->First + this->Queue.keyOf(this->Queue.nextBucket());
  }
  double meanLongestEdge() const override
  {
    return this->Mesh.meanLongestEdge() * this->TriangleCost.mean();
  }
  double typicalEdge() const override
  {
    return this->Mesh.meanLongestEdge() * this->TriangleCost.typical();
  }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  bool isCancelled() const override { return this->Control.isCancelled(); }

  void visitValues(Index vertex, const Visit& visit) const override
  {
    this->visitKept(vertex, [&](const ReferenceValue& kept) { visit(kept.label, kept.value); });
  }

  void lower(Index vertex, Index label, double value) override
  {
    this->Queue.goBackTo(value + this->Labels[label].value - this->First);
    this->propose(vertex, label, value);
  }

  /** See goOnWithinHigherBounds(). Bounds are read where they are needed. */
  void takeHigherBounds() {}
  void goBackTo(Index vertex) { this->Queue.goBackTo(this->Field.distance(vertex) - this->First); }
  void queueAgain(Index vertex)
  {
    this->Values.visit(vertex,
      [&](const ReferenceValue& held)
      { this->set(this->Values.find(vertex, held.label), held.value); });
  }

  /** Sets the nearest seed of each vertex in the field; of equally near ones the smallest number.
   * The field gets the least gain that counted if that was raised. */
  void finish()
  {
    this->Field.noteRaisedGain(this->Control.raisedGain());
    constexpr double rounding = 1.0 + 1e-10;
    for (const Index vertex : this->Field.reached())
    {
      Index nearest = NoIndex;
      const ReferenceValue* least = nullptr;
      this->visitKept(vertex,
        [&](const ReferenceValue& kept)
        {
          if (!least || this->distance(kept) < this->distance(*least))
          {
            least = &kept;
          }
          if (this->distance(kept) <= this->Field.distance(vertex) * rounding)
          {
            nearest = std::min(nearest, this->Labels[kept.label].seed);
          }
        });
      this->Field.setNearestSeed(vertex, nearest);
      if (this->Bounds &&
        this->Bounds->mayEnd(least->label, least->value + this->TriangleCost.reach(vertex)))
      {
        this->Bounds->noteAtEnd(vertex);
      }
    }
  }

private:
  /** Updates the neighbours of a vertex over all open triangles round it, for one label. */
  void updateNeighbours(const ReferenceValue& from)
  {
    const std::span<const RingEntry> ring = this->Mesh.ring(from.vertex);
    if (this->Bounds &&
      !this->Ties.goesOn(from.vertex, ring.size(), from.label, this->distance(from)))
    {
      return;
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (this->Closed.isOpen(from.vertex, i))
      {
        this->update(from, i, i + 1);
        this->update(from, i + 1, i);
      }
    }
  }

  /** Updates the third corner of a triangle over the edge from @p from's vertex to the second.
   * @param entryOfSecond, entryOfThird  entries of the ring of @p from's vertex */
  void update(const ReferenceValue& from, std::size_t entryOfSecond, std::size_t entryOfThird)
  {
    const Label& label = this->Labels[from.label];
    const std::span<const RingEntry> ring = this->Mesh.ring(from.vertex);
    const Index second = ring[entryOfSecond].neighbour();
    const Index third = ring[entryOfThird].neighbour();
    const Vector3 edge = this->Mesh.toNeighbour(from.vertex, entryOfSecond);
    const Vector3 side = this->Mesh.toNeighbour(from.vertex, entryOfThird);
    const Vector3 normal = cross(edge, side);
    const FlatTriangle triangle{ dot(edge, edge), dot(edge, side), dot(normal, normal) };
    const double cost = this->TriangleCost.ofTriangle(from.vertex, second, third);
    const double atSecond = this->Values.valueOf(second, from.label);
    double value = from.value + cost * norm(side);
    // The update divides by the edge's length. If that is 0, the edge is one point, and the side is
    // the only line from it.
    if (triangle.squaredEdge > 0.0 && !this->isFinal(third, from.label))
    {
      value = std::min(value,
        label.shape == FrontShape::Straight
          ? straightFrontUpdate(triangle, from.value, atSecond, cost)
          : this->TriangleCost.isBypassed(cost, from.vertex, second, third)
          ? bypassedUpdate(triangle, from.value, atSecond, cost)
          : cost * pointSourceUpdate(triangle, from.value / cost, atSecond / cost));
    }
    const StraightLineBound bound(label, this->TriangleCost.smallest());
    this->propose(third, from.label, bound.raised(value, this->Mesh.position(third)));
  }

  /**
   * Gives a vertex a value of a label if that counts: if it is lower than the label's value there,
   * by more than the tolerance of MarchControl, within the margin above the best value, and not
   * beyond the limit; unless the vertex is excluded. A final value falls at cost 1 alone.
   * @param value without the value of the label's seed
   */
  void propose(Index vertex, Index label, double value)
  {
    const double seedValue = this->Labels[label].value;
    const double known = this->Values.valueOf(vertex, label);
    const double kept = this->keptUpTo(vertex) - seedValue;
    const double mayMatter = this->Limit.with(vertex) - seedValue;
    const bool counts =
      value < std::min(std::min(known, kept) * this->Control.keptFraction(), mayMatter);
    if (!counts || this->isBeyondBounds(vertex, label, value) || this->Options.isExcluded(vertex))
    {
      return;
    }
    const Index number = this->Values.findOrAdd(vertex, label);
    if (Cost::isUnit || !this->Values[number].isFinal)
    {
      this->set(number, value);
    }
  }

  /** Whether the value of a label at a vertex is final. */
  bool isFinal(Index vertex, Index label) const
  {
    const Index number = this->Values.find(vertex, label);
    return number != NoIndex && this->Values[number].isFinal;
  }

  /** Whether a value without that of the seed is above the bounds of its vertex or its label. */
  bool isBeyondBounds(Index vertex, Index label, double value) const
  {
    return this->Bounds &&
      (value > this->Bounds->ofLabel(label) ||
        value + this->Labels[label].value >
          this->Bounds->ofVertex(vertex, this->Bounds->allowanceOf(label)));
  }

  /** Stores the value of a number, lowers the field's distance to it, and queues the number unless
   * it is idle. */
  void set(Index number, double value, bool isIdle = false)
  {
    ReferenceValue& held = this->Values[number];
    held.value = value;
    const double distance = this->distance(held);
    if (distance < this->Field.distance(held.vertex))
    {
      this->Field.setDistance(held.vertex, distance);
    }
    // By value it is queued again where it falls; the first time that it is taken counts.
    if (!isIdle && (!held.isQueued || this->Queue.isByValue()))
    {
      held.isQueued = true;
      this->Queue.push(number, distance - this->First);
    }
  }

  /** The largest distance of any label that a vertex keeps: its best one and the margin (see
   * labelMargin()); infinity with only one label, or where bounds take the place of the margin. */
  double keptUpTo(Index vertex) const
  {
    return this->Labels.size() == 1 || this->Bounds
      ? DistanceField::Unreached
      : this->Field.distance(vertex) + this->TriangleCost.margin(vertex);
  }

  /** A value as a distance, with the value of its seed. */
  double distance(const ReferenceValue& of) const
  {
    return of.value + this->Labels[of.label].value;
  }

  /** Calls @p visit with each value of a vertex that is within its margin. */
  template <class Visit>
  void visitKept(Index vertex, const Visit& visit) const
  {
    this->Values.visit(vertex,
      [&](const ReferenceValue& known)
      {
        if (this->distance(known) <= this->keptUpTo(vertex))
        {
          visit(known);
        }
      });
  }

  const TriangleMesh& Mesh;
  const Cost& TriangleCost;
  std::span<const Label> Labels;
  LabelBounds* Bounds;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  const StopLimit& Limit;
  MarchControl Control;
  DistanceField& Field;
  /** The least value of any label. The queue's keys are distances less this one. */
  double First;
  /** Holds the numbers of values (see ReferenceValues), roughly in order of distance. */
  BucketQueue Queue;
  ReferenceValues Values;
  HubTies Ties;
};

}

ReferenceSolver::ReferenceSolver(const std::shared_ptr<const TriangleMesh>& mesh)
  : ReferenceSolver(mesh, std::make_shared<UpdateBounds>(*mesh))
{
}

ReferenceSolver::ReferenceSolver(
  std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds)
  : MarchingSolver(std::move(mesh), std::move(bounds))
{
}

template <class Cost>
bool ReferenceSolver::marchAtCost(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field)
{
  ReferenceFront<Cost> front(this->mesh(), cost, request.front.labels, bounds, request.closed,
    request.options, limit, field);
  std::for_each(starts.begin(), starts.end(), [&](const StartValue& start) { front.start(start); });
  const bool finished = request.partition.march(front, limit) &&
    goOnWithinHigherBounds(bounds, front, front, request.partition, limit, field);
  field.orderReached();
  front.finish();
  return finished;
}

bool ReferenceSolver::marchFrom(std::span<const StartValue> starts, const UnitCost& cost,
  const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field)
{
  return this->marchAtCost(starts, cost, request, bounds, limit, field);
}

bool ReferenceSolver::marchFrom(std::span<const StartValue> starts, const VertexCost& cost,
  const Request& request, LabelBounds* bounds, StopLimit& limit, DistanceField& field)
{
  return this->marchAtCost(starts, cost, request, bounds, limit, field);
}

std::unique_ptr<MarchingSolver> ReferenceSolver::another() const
{
  return std::make_unique<ReferenceSolver>(this->sharedMesh(), this->bounds());
}

}
