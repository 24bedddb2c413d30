// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedValues_h
#define geodesic_SharedValues_h

#include "march/SharedFieldValues.h"

#include <vector>

namespace geodesic
{

/** The values of a march of one label on several threads, for one of them: as OneLabelValues, in a
 * field that all threads share. */
template <class Cost>
class SharedValues : public SharedFieldValues<Cost>
{
public:
  /** A mesh must have fewer vertices: an item of the queue is a vertex, or a notice of one. */
  static constexpr Index MostVertices = SharedFieldValues<Cost>::Notice;

  /** @param reached  gets the vertices that this thread gives their first value */
  SharedValues(const MarchContext<Cost>& context, const Label& label, SharedMarch::Share& share,
    std::vector<Index>& reached)
    : SharedFieldValues<Cost>(context, label.value, share, reached)
    , Only(label, 0, context.cost.smallest())
    , QueuesAgain(queuesAgain(context))
  {
  }

  static constexpr bool hasOtherLabels = false;
  /** The only label. */
  const SourceFront& label() const { return this->Only; }

  /** Reads the values of vertices. */
  class Reader
  {
  public:
    explicit Reader(SharedValues& of)
      : Shared(of)
      , SeedValue(of.Only.seedValue)
    {
    }
    /** Counts only what waits in this thread's queue as waiting: what waits elsewhere may have been
     * taken meanwhile. */
    template <class Real>
    GEODESIC_INLINED BestValues<Real> look(const Indices<Real>& vertices) const
    {
      const Real distances = this->Shared.template distances<Real>(vertices);
      const BitsOf<Real> states = this->Shared.template states<Real>(vertices);
      const BitsOf<Real> others = this->Shared.template others<Real>(vertices);
      return { distances - this->SeedValue, 0, highestBits<Real>(states & ~others) };
    }

  private:
    typename SharedValues::SharedReader Shared;
    double SeedValue;
  };
  Reader reader(const SourceFront&) { return Reader(*this); }

  template <Way way>
  NeighbourValue propose(const SourceFront&, Index vertex, double value)
  {
    value = this->Only.leastOf.raised(value, this->Context.mesh.position(vertex));
    const VertexState state = this->state(vertex);
    const bool isOwn = this->Share.owns(vertex);
    const double old = this->key(vertex);
    const double ceiling = old * this->Context.control.keptFraction();
    if (isOwn && state.isQueuedFor(0))
    {
      // A processor can't predict whether the value counts, so there is no branch on it.
      const Pair held = select(Pair{ value } < Pair{ ceiling }, Pair{ value }, Pair{ old });
      this->queueAgain(vertex, held[0], old);
      this->setDistance(vertex, this->Only.distance(held[0]));
      return { held[0], held[0], true };
    }
    if (!(value < ceiling) || isFixed<Cost, way>(state) || this->Context.options.isExcluded(vertex))
    {
      return { old, old, isOwn && state.isQueued() };
    }
    if (!isOwn)
    {
      this->Share.send({ vertex, 0 }, value, way == Way::Along);
      return { old, old, false };
    }
    this->set(vertex, state, value);
    return { value, value, true };
  }

  /** How many vertices have a value, those of other threads as far as is known. */
  std::size_t numberOfValues() const
  {
    return this->Share.valuesOfOthers() + this->numberOfOwnValues();
  }
  /** To how many this thread gave it. */
  std::size_t numberOfOwnValues() const { return this->numberOfReached(); }

  Index vertexOf(Index item) const { return item & ~SharedValues::Notice; }
  GEODESIC_INLINED void prefetch(Index item) const { this->prefetchRing(this->vertexOf(item)); }
  /** In the order of buckets, that of threads, all items are handed out. */
  bool isWaiting(Index) const { return true; }
  PoppedValue pop(Index item)
  {
    this->noteBorder();
    const Index vertex = this->vertexOf(item);
    const double value = this->key(vertex);
    if (!this->isNotice(item))
    {
      VertexState state = this->state(vertex);
      if (this->QueuesAgain && !state.isQueued())
      {
        return { NoIndex, nullptr, 0.0 };
      }
      this->notePopped({ vertex, 0 }, value);
      state.setQueued(false);
      this->setState(vertex, state);
    }
    return { vertex, &this->Only, value };
  }

  // See ThreadFront.

  template <Way way>
  void lower(const LabelAtVertex& place, double key)
  {
    this->Context.queues.goBackIfFar(this->groupOf(place.vertex), key);
    this->template propose<way>(this->Only, place.vertex, key);
  }
  void updateRound(const LabelAtVertex& place)
  {
    FrontGroup& group = this->groupOf(place.vertex);
    this->putBack(group, group.best, place.vertex | SharedValues::Notice, this->key(place.vertex));
  }
  void take(Index vertex)
  {
    FrontGroup& group = this->groupOf(vertex);
    this->putBack(group, group.best, vertex, this->key(vertex));
  }

private:
  FrontGroup& groupOf(Index vertex) const
  {
    return this->Context.queues.group(this->Context.queues.groupOfVertex(vertex));
  }

  /** Stores a value of a vertex that this thread owns, and queues the vertex. */
  void set(Index vertex, VertexState state, double value)
  {
    this->noteIfFirst(vertex);
    if (state.isQueued())
    {
      this->queueAgain(vertex, value, this->key(vertex));
    }
    this->setDistance(vertex, this->Only.distance(value));
    if (!state.isQueued())
    {
      state.setQueued(true);
      this->setState(vertex, state);
      this->groupOf(vertex).best.push(vertex, value);
    }
  }

  /** As FieldValues::queueAgain(). */
  GEODESIC_INLINED void queueAgain(Index vertex, double value, double before)
  {
    if (this->QueuesAgain && this->Context.queues.comesSooner(value, before)) [[unlikely]]
    {
      this->groupOf(vertex).best.push(vertex, value);
    }
  }

  SourceFront Only;
  bool QueuesAgain;
};

}

#endif
