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
#include "solve/StopLimit.h"

#include <algorithm>
#include <span>

namespace geodesic
{

/** What the values of every label have in common; see NeighbourUpdate. */
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

/** What it takes to look at many vertices, at hand: the best values less that of a label's seed,
 * and their states. */
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

/** Values of labels that the field itself holds: its distances less the values of the seeds. */
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

  double value(const SourceFront& label, Index vertex) const
  {
    return this->Distances[vertex] - label.seedValue;
  }

  /** What a value has to be below in order to count where there is @p old. */
  double ceiling(const SourceFront& label, Index vertex, double old) const
  {
    const double counts = old * this->Control.keptFraction();
    // Until a target is reached there is no limit, and no need to look up the reach.
    return this->MayStop && this->Context.limit.isKnown()
      ? std::min(
          counts, this->Context.limit.with(this->Context.cost.reach(vertex)) - label.seedValue)
      : counts;
  }

  bool isExcluded(Index vertex) const
  {
    return this->HasExcluded && this->Context.options.isExcluded(vertex);
  }

  /** Lowers the value of a vertex that waits, as no excluded one does, if that counts; returns what
   * then holds. Whether it counts is not to be guessed, so there is no branch on it. */
  NeighbourValue lower(const SourceFront& label, Index vertex, double value)
  {
    const double ceiling = this->ceiling(label, vertex, this->value(label, vertex));
    const Pair distance = select(Pair{ value } < Pair{ ceiling }, Pair{ value + label.seedValue },
      Pair{ this->Distances[vertex] });
    this->Field.lowerDistance(vertex, distance[0]);
    const double held = distance[0] - label.seedValue;
    return { held, held, true };
  }

  /** Gives a vertex that has no value or one of the same label a value, which it takes if that
   * counts; returns what then holds. */
  NeighbourValue offer(const SourceFront& label, Index vertex, double value)
  {
    const double old = this->value(label, vertex);
    if (!this->state(vertex).isPinned() && !this->isExcluded(vertex) &&
      value < this->ceiling(label, vertex, old))
    {
      this->set(label, vertex, value);
      return { value, value, true };
    }
    return { old, old, this->state(vertex).isQueued() };
  }

  void set(const SourceFront& label, Index vertex, double value)
  {
    if (this->state(vertex).isQueued())
    {
      this->Field.lowerDistance(vertex, value + label.seedValue);
    }
    else
    {
      this->Field.setDistance(vertex, value + label.seedValue);
      this->state(vertex).queueFor(label.labelBits);
      this->queue(label, label.group->best, vertex, value);
    }
  }

  /** @param item  a vertex, or what else stands for a value of the label */
  void queue(const SourceFront& label, BucketQueue& into, Index item, double value)
  {
    into.push(item, value + label.seedValue - this->First);
  }

private:
  const MarchContext<Cost>& Context;
  // What of it every value asks for.
  const MarchControl& Control;
  DistanceField& Field;
  bool MayStop;
  bool HasExcluded;
  double First;
  std::span<VertexState> States;
  std::span<const double> Distances;
  std::span<const Vector3> Positions;
};

}

#endif
