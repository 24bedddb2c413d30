// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedFieldValues_h
#define geodesic_SharedFieldValues_h

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
 * What the values of a march on several threads have in common: a field and states that all threads
 * share (see SharedMarch). A vertex waits in the queue of its owner, once: the queues are not by
 * value. Keys of the queue are distances less that of key 0.
 */
template <class Cost>
class SharedFieldValues
{
public:
  /** A mesh must have fewer vertices, as the numbers from there on are those of notices. */
  static constexpr Index MostVertices = 0x80000000u;

  /** The key of a vertex. */
  double key(Index vertex) const { return this->distance(vertex) - this->FirstDistance; }
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
  void queueNotice(Index vertex) { this->queue(vertex | Notice, this->key(vertex)); }
  /** Queues a vertex of this thread that waited in another thread's queue. */
  void takeOver(Index vertex) { this->queue(vertex, this->key(vertex)); }

protected:
  /** @param firstDistance  the distance of key 0
   * @param reached  gets the vertices that this thread gives their first value */
  SharedFieldValues(const MarchContext<Cost>& context, double firstDistance,
    SharedMarch::Share& share, std::vector<Index>& reached)
    : Context(context)
    , Share(share)
    , FirstDistance(firstDistance)
    , Reached(reached)
    , Queue(context.queues.group(0).best)
    , Distances(context.field.sharedDistances())
  {
  }

  /** Reads the distances and states of vertices, and finds which are other threads'. */
  class SharedReader
  {
  public:
    explicit SharedReader(SharedFieldValues& of)
      : Distances(of.Distances.data())
      , States(of.Context.states.data())
      , First(of.Share.first())
      , Last(of.Share.first() + of.Share.count() - 1)
      , AreOthers(of.AreOthers)
    {
    }
    template <class Real>
    GEODESIC_INLINED Real distances(const Indices<Real>& vertices) const
    {
      return readSharedLanes([&](const auto& read)
        { return lanesOf<Real>([&](int lane) { return read(this->Distances[vertices[lane]]); }); });
    }
    template <class Real>
    GEODESIC_INLINED BitsOf<Real> states(const Indices<Real>& vertices) const
    {
      return readSharedLanes(
        [&](const auto& read) {
          return bitsWith<Real>(
            [&](int lane) { return read(this->States[vertices[lane]]).bits(); });
        });
    }
    /** Numbers whose highest bits are set where a vertex is another thread's. */
    template <class Real>
    GEODESIC_INLINED BitsOf<Real> others(const Indices<Real>& vertices) const
    {
      BitsOf<Real> numbers;
      std::memcpy(&numbers, vertices.data(), sizeof numbers);
      const BitsOf<Real> others = (numbers - this->First) | (this->Last - numbers);
      this->AreOthers |= highestBits<Real>(others);
      return others;
    }

  private:
    const double* Distances;
    const VertexState* States;
    Index First;
    Index Last;
    unsigned& AreOthers;
  };

  /** Marks an item as taken from the queue. @return its vertex */
  Index take(Index item)
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
    return vertex;
  }

  double distance(Index vertex) const { return readShared(this->Distances[vertex]); }
  void setDistance(Index vertex, double distance)
  {
    writeShared(this->Distances[vertex], distance);
  }
  VertexState state(Index vertex) const { return readShared(this->Context.states[vertex]); }
  void setState(Index vertex, VertexState state)
  {
    writeShared(this->Context.states[vertex], state);
  }
  /** Stores a distance that may be the first one of its vertex. */
  void setAnyDistance(Index vertex, double distance)
  {
    if (!(this->distance(vertex) < DistanceField::Unreached))
    {
      this->Reached.push_back(vertex);
    }
    this->setDistance(vertex, distance);
  }
  void queue(Index item, double key) { this->Queue.push(item, key); }

  const MarchContext<Cost>& Context;
  SharedMarch::Share& Share;
  /** The distance of the queue's key 0. */
  double FirstDistance;

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

  std::vector<Index>& Reached;
  BucketQueue& Queue;
  std::span<double> Distances;
  /** The vertex that was popped last, if it is this thread's. */
  Index Last = NoIndex;
  /** Not 0 if vertices of other threads were read since then. */
  unsigned AreOthers = 0;
  std::vector<Index> AtBorder;
};

}

#endif
