// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedValues_h
#define geodesic_SharedValues_h

#include "base/SharedNumber.h"
#include "march/FieldValues.h"
#include "threads/SharedMarch.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * The values of a march of one label on several threads, for one of them: as OneLabelValues, in a
 * field that all threads share (see SharedMarch). A vertex waits in the queue of its owner, once:
 * the queues are not by value.
 */
template <class Cost>
class SharedValues
{
public:
  /** @param reached  gets the vertices that this thread gives their first value */
  SharedValues(const MarchContext<Cost>& context, const Label& label, SharedMarch::Share& share,
    std::vector<Index>& reached)
    : Context(context)
    , Share(share)
    , Reached(reached)
    , Only(label, 0, context.cost.smallest())
    , Distances(context.field.sharedDistances())
  {
    this->Only.group = &context.queues.group(0);
  }

  static constexpr bool hasOtherLabels = false;
  /** A mesh must have fewer vertices, as the numbers from there on are those of notices. */
  static constexpr Index MostVertices = 0x80000000u;
  /** The only label. */
  const SourceFront& label() const { return this->Only; }

  /** Reads the values of vertices. */
  class Reader
  {
  public:
    explicit Reader(SharedValues& of)
      : Distances(of.Distances.data())
      , States(of.Context.states.data())
      , SeedValue(of.Only.seedValue)
      , First(of.Share.first())
      , Last(of.Share.first() + of.Share.count() - 1)
      , AreOthers(of.AreOthers)
    {
    }
    /** Counts only what waits in this thread's queue as waiting: what waits elsewhere may have been
     * taken meanwhile. */
    template <class Real>
    GEODESIC_INLINED BestValues<Real> look(const Indices<Real>& vertices) const
    {
      const auto values = readSharedLanes([&](const auto& read)
        { return lanesOf<Real>([&](int lane) { return read(this->Distances[vertices[lane]]); }); });
      const auto states = readSharedLanes(
        [&](const auto& read) {
          return bitsWith<Real>(
            [&](int lane) { return read(this->States[vertices[lane]]).bits(); });
        });
      BitsOf<Real> numbers;
      std::memcpy(&numbers, vertices.data(), sizeof numbers);
      // The highest bit of each is set where the vertex is another thread's.
      const BitsOf<Real> others = (numbers - this->First) | (this->Last - numbers);
      this->AreOthers |= highestBits<Real>(others);
      return { values - this->SeedValue, 0, highestBits<Real>(states & ~others) };
    }

  private:
    const double* Distances;
    const VertexState* States;
    double SeedValue;
    Index First;
    Index Last;
    unsigned& AreOthers;
  };
  Reader reader(const SourceFront&) { return Reader(*this); }

  template <Way way>
  NeighbourValue propose(const SourceFront&, Index vertex, double value)
  {
    value = this->Only.leastOf.raised(value, this->Context.mesh.position(vertex));
    const VertexState state = this->state(vertex);
    const bool isOwn = this->Share.owns(vertex);
    const double old = this->value(vertex);
    const double ceiling = old * this->Context.control.keptFraction();
    if (isOwn && state.isQueuedFor(0))
    {
      // A processor can't predict whether the value counts, so there is no branch on it.
      const Pair held = select(Pair{ value } < Pair{ ceiling }, Pair{ value }, Pair{ old });
      this->setValue(vertex, held[0]);
      return { held[0], held[0], true };
    }
    const bool isFixed = !(Cost::isUnit && way == Way::Along) && state.isFinal();
    if (!(value < ceiling) || isFixed || this->Context.options.isExcluded(vertex))
    {
      return { old, old, isOwn && state.isQueued() };
    }
    if (!isOwn)
    {
      this->Share.send(vertex, value);
      return { old, old, false };
    }
    this->set(vertex, state, value);
    return { value, value, true };
  }

  double value(Index vertex) const
  {
    return readShared(this->Distances[vertex]) - this->Only.seedValue;
  }
  /** How many vertices have a value, those of other threads as far as is known. */
  std::size_t numberOfValues() const
  {
    return this->Share.reachedByOthers() + this->Reached.size();
  }
  /** To how many of them this thread gave it. */
  std::size_t numberOfReached() const { return this->Reached.size(); }

  // An item of the queue is a vertex, or stands for an update round a vertex of another thread.

  static bool isNotice(Index item) { return (item & Notice) != 0; }
  Index vertexOf(Index item) const { return item & ~Notice; }
  GEODESIC_INLINED void prefetch(Index item) const
  {
    const Index vertex = this->vertexOf(item);
    this->Context.mesh.prefetch(vertex);
    this->Context.bounds.prefetch(this->Context.mesh.rings().firstEntry(vertex));
  }
  PoppedValue pop(Index item)
  {
    this->noteBorder();
    const Index vertex = this->vertexOf(item);
    if (!isNotice(item))
    {
      this->Last = vertex;
      VertexState state = this->state(vertex);
      state.setQueued(false);
      this->setState(vertex, state);
    }
    return { vertex, &this->Only, this->value(vertex) };
  }

  /** Calls visit(vertex) for each of this thread's vertices that was popped since the last call and
   * is beside vertices of other threads, and for a few more. */
  template <class Visit>
  void visitAtBorder(const Visit& visit)
  {
    this->noteBorder();
    std::for_each(this->AtBorder.begin(), this->AtBorder.end(), visit);
    this->AtBorder.clear();
  }

  /** Queues an update round a vertex of another thread. */
  void queueNotice(Index vertex) { this->queue(vertex | Notice, this->value(vertex)); }
  /** Queues a vertex of this thread that waited in another thread's queue. */
  void takeOver(Index vertex) { this->queue(vertex, this->value(vertex)); }

private:
  static constexpr Index Notice = MostVertices;

  /** Notes the vertex that was popped last, once its neighbours have been read, if some of them are
   * other threads'. */
  void noteBorder()
  {
    if (this->AreOthers != 0)
    {
      if (this->Last != NoIndex)
      {
        this->AtBorder.push_back(this->Last);
      }
      this->AreOthers = 0;
    }
    this->Last = NoIndex;
  }

  VertexState state(Index vertex) const { return readShared(this->Context.states[vertex]); }
  void setState(Index vertex, VertexState state)
  {
    writeShared(this->Context.states[vertex], state);
  }
  void setValue(Index vertex, double value)
  {
    writeShared(this->Distances[vertex], value + this->Only.seedValue);
  }
  void setFirst(Index vertex, double value)
  {
    if (!(this->value(vertex) < DistanceField::Unreached))
    {
      this->Reached.push_back(vertex);
    }
    this->setValue(vertex, value);
  }
  /** Stores a value of a vertex that this thread owns, and queues the vertex. */
  void set(Index vertex, VertexState state, double value)
  {
    this->setFirst(vertex, value);
    if (!state.isQueued())
    {
      state.setQueued(true);
      this->setState(vertex, state);
      this->queue(vertex, value);
    }
  }
  void queue(Index item, double value) { this->Only.group->best.push(item, value); }

  const MarchContext<Cost>& Context;
  SharedMarch::Share& Share;
  std::vector<Index>& Reached;
  SourceFront Only;
  std::span<double> Distances;
  /** The vertex that was popped last, if it is this thread's. */
  Index Last = NoIndex;
  /** Not 0 if vertices of other threads were read since then. */
  unsigned AreOthers = 0;
  std::vector<Index> AtBorder;
};

}

#endif
