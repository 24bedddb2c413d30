// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadFront_h
#define geodesic_ThreadFront_h

#include "base/Index.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

/** A thread's part of the front of a march, as SharedMarch drives it. Values here leave out the
 * seed's own value. */
class ThreadFront
{
public:
  virtual ~ThreadFront() = default;

  /** Takes vertices from this thread's queue as MarchingFront::advance() does. */
  virtual void advance(double limit) = 0;
  /** The same, as long as @p mayGoOn returns true, which is asked again after a few vertices. */
  virtual void advanceWhile(double limit, const std::function<bool()>& mayGoOn) = 0;
  /** Calls visit(vertex) for each of this thread's vertices that was taken since the last call and
   * has neighbours of other threads; for some others too, and for some several times. */
  virtual void visitAtBorder(const std::function<void(Index vertex)>& visit) = 0;
  /** A lower bound of all values in the queue; infinity where it is empty. */
  virtual double next() const = 0;
  /** How many vertices wait in the queue. */
  virtual std::size_t waiting() const = 0;
  /** Calls visit(vertex) for each vertex that waits as this thread's. */
  virtual void visitWaiting(const std::function<void(Index vertex)>& visit) const = 0;
  /** To how many vertices this thread gave their first value. */
  virtual std::size_t reached() const = 0;
  /** The number of vertices taken from the queue so far. */
  virtual std::size_t numberOfUpdates() const = 0;
  /** TriangleMesh::meanLongestEdge() times the mean cost. */
  virtual double meanLongestEdge() const = 0;
  virtual double value(Index vertex) const = 0;

  /** Goes back in the queue, so that vertices of values from there on have their places in it. To
   * be called before the functions below. */
  virtual void goBackTo(double value) = 0;
  /** Gives a vertex a value if it is lower. */
  virtual void lower(Index vertex, double value) = 0;
  /** Updates the neighbours of a vertex of another thread when the front next advances. */
  virtual void updateRound(Index vertex) = 0;
  /** Puts a vertex into the queue that waited in another thread's. */
  virtual void take(Index vertex) = 0;
  /** Removes the vertices that this thread does not own any more from the queue, and calls
   * give(vertex) for each. */
  virtual void giveUp(const std::function<void(Index vertex)>& give) = 0;
};

}

#endif
