// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedFieldValues_h
#define geodesic_SharedFieldValues_h

#include "base/SharedNumber.h"
#include "march/FieldValues.h"
#include "threads/SharedMarch.h"

#include <cstring>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * What the values of a march on several threads have in common: a field and states that all threads
 * share (see SharedMarch). What waits at a vertex waits in the queue of its owner: the queues are
 * not by value. Keys of the queue are distances less that of key 0.
 */
template <class Cost>
class SharedFieldValues
{
public:
  /** An item of the queue from here on is a notice, which stands for an update round a vertex of
   * another thread. */
  static constexpr Index Notice = 0x80000000u;
  static bool isNotice(Index item) { return (item & Notice) != 0; }

  /** To how many vertices this thread gave their first value. */
  std::size_t numberOfReached() const { return this->Reached.size(); }

  /** Calls visit(LabelAtVertex, key) for each value that was popped since the last call, of this
   * thread's vertices beside vertices of other threads, and for a few more. */
  template <class Visit>
  void visitAtBorder(const Visit& visit)
  {
    this->noteBorder();
    for (const Popped& popped : this->AtBorder)
    {
      visit(popped.place, popped.key);
    }
    this->AtBorder.clear();
  }

protected:
  /** @param firstDistance  the distance of key 0
   * @param reached  gets the vertices that this thread gives their first value */
  SharedFieldValues(const MarchContext<Cost>& context, double firstDistance,
    SharedMarch::Share& share, std::vector<Index>& reached)
    : Context(context)
    , Share(share)
    , FirstDistance(firstDistance)
    , Reached(reached)
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
      return sharedLanesOf<Real>(
        [&](int lane) -> const double& { return this->Distances[vertices[lane]]; });
    }
    template <class Real>
    GEODESIC_INLINED BitsOf<Real> states(const Indices<Real>& vertices) const
    {
      return sharedBitsWith<Real>(
        [&](int lane) -> const VertexState& { return this->States[vertices[lane]]; });
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

  GEODESIC_INLINED void prefetchRing(Index vertex) const
  {
    this->Context.mesh.prefetch(vertex);
    this->Context.bounds.prefetch(this->Context.mesh.rings().firstEntry(vertex));
  }

  /** To be called before a value is popped: notes the one before, once its neighbours have been
   * read, if some of them are other threads'. */
  void noteBorder()
  {
    if (this->AreOthers != 0)
    {
      if (this->Last.place.vertex != NoIndex)
      {
        this->AtBorder.push_back(this->Last);
      }
      this->AreOthers = 0;
    }
    this->Last.place.vertex = NoIndex;
  }
  /** To be called once a value of this thread was popped. */
  void notePopped(const LabelAtVertex& place, double key) { this->Last = { place, key }; }

  double distance(Index vertex) const { return readShared(this->Distances[vertex]); }
  double key(Index vertex) const { return this->distance(vertex) - this->FirstDistance; }
  void setDistance(Index vertex, double distance)
  {
    writeShared(this->Distances[vertex], distance);
  }
  VertexState state(Index vertex) const { return readShared(this->Context.states[vertex]); }
  void setState(Index vertex, VertexState state)
  {
    writeShared(this->Context.states[vertex], state);
  }
  /** To be called before a distance of a vertex is stored that may be its first one. */
  void noteIfFirst(Index vertex)
  {
    if (!(this->distance(vertex) < DistanceField::Unreached))
    {
      this->Reached.push_back(vertex);
    }
  }

  /** Puts an item into a queue of a group, and goes back to its key if need be. */
  void putBack(FrontGroup& group, BucketQueue& queue, Index item, double key)
  {
    this->Context.queues.goBackIfFar(group, key);
    queue.push(item, key);
  }

  const MarchContext<Cost>& Context;
  SharedMarch::Share& Share;
  double FirstDistance;

private:
  struct Popped
  {
    LabelAtVertex place{ NoIndex, 0 };
    double key = 0.0;
  };

  std::vector<Index>& Reached;
  std::span<double> Distances;
  /** The value that was popped last, if its vertex is this thread's. */
  Popped Last;
  /** Not 0 if vertices of other threads were read since then. */
  unsigned AreOthers = 0;
  std::vector<Popped> AtBorder;
};

}

#endif
