// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FieldValues_h
#define geodesic_FieldValues_h

#include "base/Lanes.h"
#include "march/FrontQueues.h"
#include "march/NeighbourValues.h"
#include "march/SourceFront.h"
#include "march/UpdateBounds.h"
#include "march/VertexState.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "solve/MarchControl.h"
#include "solve/SolveOptions.h"
#include "solve/StartValue.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <span>

namespace geodesic
{

/** What a march works on: mesh, costs, options, and its field, queues and vertex states. */
template <class Cost>
struct MarchContext
{
  const TriangleMesh& mesh;
  const UpdateBounds& bounds;
  const Cost& cost;
  const SolveOptions& options;
  const StopLimit& limit;
  const MarchControl& control;
  DistanceField& field;
  FrontQueues& queues;
  std::span<VertexState> states;
};

/** Reads the best values and the states of two or four vertices at once, for an update for one
 * label: a best value is the distance in the field less the value of the label's seed. */
class FieldReader
{
public:
  FieldReader(std::span<const double> distances, std::span<const VertexState> states,
    const SourceFront& label)
    : Distances(distances.data())
    , States(states.data())
    , SeedValue(label.seedValue)
  {
  }

  template <class Real>
  GEODESIC_INLINED Real values(const Indices<Real>& vertices) const
  {
    return lanesOf<Real>([&](int lane) { return this->Distances[vertices[lane]]; }) -
      this->SeedValue;
  }
  template <class Real>
  GEODESIC_INLINED BitsOf<Real> states(const Indices<Real>& vertices) const
  {
    return bitsWith<Real>([&](int lane) { return this->States[vertices[lane]].bits(); });
  }

private:
  const double* Distances;
  const VertexState* States;
  double SeedValue;
};

/**
 * Whether a vertex that waits is queued once more where its value falls so that it comes sooner. It
 * then is in the queue several times, and waits only until it is taken first. Where triangles are
 * of about one size, it hardly ever comes sooner. Where sizes are spread, as a program for CAD
 * meshes a box with fillets, small triangles would wait in the buckets of first, far too high
 * values that came over large ones: 20 updates a vertex there, where 1.7 are enough.
 */
template <class Cost>
bool queuesAgain(const MarchContext<Cost>& context)
{
  constexpr double mostOfOneSize = 1.5;
  return context.cost.queueOrder() == QueueOrder::ByValue ||
    context.mesh.spreadOfEdges() > mostOfOneSize;
}

/** Whether updates that come on a way leave a value as it is because it is final. */
template <class Cost, Way way>
bool isFixed(const VertexState& state)
{
  return !(Cost::isUnit && way == Way::Along) && state.isFinal();
}

/**
 * The best values of vertices, which are in the field: its distances less the values of the labels'
 * seeds. It is the common base of OneLabelValues and LabelValues.
 */
template <class Cost>
class FieldValues
{
public:
  /** The distance of the queue's key 0. */
  double firstDistance() const { return this->First; }

protected:
  FieldValues(const MarchContext<Cost>& context, double firstDistance)
    : Context(context)
    , Control(context.control)
    , Field(context.field)
    , MayStop(context.limit.isPossible())
    , HasExcluded(!context.options.excluded.empty())
    , QueuesAgain(queuesAgain(context))
    , First(firstDistance)
    , States(context.states)
    , Distances(context.field.distances())
    , Positions(context.mesh.positions())
  {
  }

  /** Fetches what an update round a vertex reads of the mesh. GCC drops the call unless it is
   * inlined. */
  GEODESIC_INLINED void prefetchRing(Index vertex) const
  {
    this->Context.mesh.prefetch(vertex);
    this->Context.bounds.prefetch(this->Context.mesh.rings().firstEntry(vertex));
  }

  const MarchContext<Cost>& context() const { return this->Context; }
  const Vector3& position(Index vertex) const { return this->Positions[vertex]; }
  VertexState& state(Index vertex) { return this->States[vertex]; }
  const VertexState& state(Index vertex) const { return this->States[vertex]; }
  FieldReader fieldReader(const SourceFront& label) const
  {
    return { this->Distances, this->States, label };
  }

  /** The best value of a vertex, less the value of the label's seed. */
  double value(const SourceFront& label, Index vertex) const
  {
    return this->Distances[vertex] - label.seedValue;
  }

  /** The ceiling of a vertex: only values below it count. @param old  the value there so far, or a
   * lower one that values must also be below */
  double ceiling(const SourceFront& label, Index vertex, double old) const
  {
    const double counts = old * this->Control.keptFraction();
    return this->MayStop ? std::min(counts, this->Context.limit.with(vertex) - label.seedValue)
                         : counts;
  }

  bool isExcluded(Index vertex) const
  {
    return this->HasExcluded && this->Context.options.isExcluded(vertex);
  }

  /** Gives a vertex a value of its best value's label, if that counts. A processor can't predict
   * whether it does, so there is no branch on it.
   * @pre the vertex is in the queue and not final, so it is not excluded either
   * @return what the vertex then has */
  NeighbourValue lower(const SourceFront& label, Index vertex, double value)
  {
    const double ceiling = this->ceiling(label, vertex, this->value(label, vertex));
    const Pair distance = select(Pair{ value } < Pair{ ceiling }, Pair{ value + label.seedValue },
      Pair{ this->Distances[vertex] });
    this->queueAgain(label, vertex, distance[0]);
    this->Field.lowerDistance(vertex, distance[0]);
    const double held = distance[0] - label.seedValue;
    return { held, held, true };
  }

  /** Gives a vertex a value if that counts, and queues it. @pre the vertex has no value or a best
   * one of the same label
   * @return what the vertex then has */
  template <Way way>
  NeighbourValue offer(const SourceFront& label, Index vertex, double value)
  {
    const double old = this->value(label, vertex);
    if (!isFixed<Cost, way>(this->state(vertex)) && !this->isExcluded(vertex) &&
      value < this->ceiling(label, vertex, old))
    {
      this->set(label, vertex, value);
      return { value, value, true };
    }
    return { old, old, this->state(vertex).isQueued() };
  }

  /** Stores the best value of a vertex, and queues the vertex. */
  void set(const SourceFront& label, Index vertex, double value)
  {
    if (this->state(vertex).isQueued())
    {
      this->queueAgain(label, vertex, value + label.seedValue);
      this->Field.lowerDistance(vertex, value + label.seedValue);
    }
    else
    {
      this->Field.setDistance(vertex, value + label.seedValue);
      this->state(vertex).queueFor(label.labelBits);
      this->queue(label, this->groupOf(label, vertex).best, vertex, value);
    }
  }

  /** Stores the best value of a vertex before the march, and queues the vertex unless it is idle.
   * @pre the vertex has no value or a best one of the same label, which is stored */
  void setFirst(const SourceFront& label, const StartValue& first)
  {
    if (first.isIdle)
    {
      this->Field.setDistance(first.vertex, first.value + label.seedValue);
    }
    else
    {
      this->set(label, first.vertex, first.value);
    }
    this->state(first.vertex).setFinal(first.isFinal);
  }

  /** The group of a label's values. */
  FrontGroup& groupOf(const SourceFront& label) { return this->Context.queues.group(label.group); }
  /** The group of a label's best value at a vertex. */
  FrontGroup& groupOf(const SourceFront& label, Index vertex)
  {
    return this->Context.queues.group(label.group + this->Context.queues.groupOfVertex(vertex));
  }

  /** Whether a vertex may be in the queue several times. */
  bool mayBeQueuedAgain() const { return this->QueuesAgain; }

  /** @param item  the vertex of a best value, or the number that stands for a secondary value */
  void queue(const SourceFront& label, BucketQueue& into, Index item, double value)
  {
    into.push(item, value + label.seedValue - this->First);
  }

private:
  /** To be called before a waiting vertex gets a lower distance, or the same: see queuesAgain(). */
  GEODESIC_INLINED void queueAgain(const SourceFront& label, Index vertex, double distance)
  {
    if (this->QueuesAgain &&
      this->Context.queues.comesSooner(
        distance - this->First, this->Distances[vertex] - this->First)) [[unlikely]]
    {
      this->queue(label, this->groupOf(label, vertex).best, vertex, distance - label.seedValue);
    }
  }

  const MarchContext<Cost>& Context;
  // What every update reads, copied out of the context.
  const MarchControl& Control;
  DistanceField& Field;
  bool MayStop;
  bool HasExcluded;
  bool QueuesAgain;
  double First;
  std::span<VertexState> States;
  std::span<const double> Distances;
  std::span<const Vector3> Positions;
};

}

#endif
