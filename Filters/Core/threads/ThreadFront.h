// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadFront_h
#define geodesic_ThreadFront_h

#include "base/Index.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

/** A label at a vertex, which may have a value of it. */
struct LabelAtVertex
{
  Index vertex;
  /** The number of the label; 0 if there is one only. */
  Index label;
};

/** A thread's part of the front of a march, as SharedMarch drives it. The items of its queue stand
 * for values of vertices, at most one for each label. Their keys are distances, less that of key 0.
 */
class ThreadFront
{
public:
  virtual ~ThreadFront() = default;

  /** Takes items from this thread's queue as MarchingFront::advance() does, as long as @p mayGoOn
   * returns true, which is asked again after a few items and may put others into the queue. */
  virtual void advanceWhile(double limit, const std::function<bool()>& mayGoOn) = 0;
  /** Calls visit(place, key) for each value that was taken since the last call, of this thread's
   * vertices that have neighbours of other threads; for some others too, and for some several
   * times. */
  virtual void visitAtBorder(
    const std::function<void(const LabelAtVertex& place, double key)>& visit) = 0;
  /** A lower bound of all keys in the queue; infinity where it is empty. */
  virtual double next() const = 0;
  /** How many items wait in the queue. */
  virtual std::size_t waiting() const = 0;
  /** Calls visit(vertex) for each item that waits for a vertex of this thread. */
  virtual void visitWaiting(const std::function<void(Index vertex)>& visit) const = 0;
  /** To how many vertices this thread gave their first value, and how many values it gave to
   * vertices that had none of the label. */
  virtual std::size_t reached() const = 0;
  virtual std::size_t numberOfValues() const = 0;
  /** The number of items taken from the queue so far. */
  virtual std::size_t numberOfUpdates() const = 0;
  /** TriangleMesh::meanLongestEdge() times the mean cost. */
  virtual double meanLongestEdge() const = 0;

  // These go back in the queue where a key is less than those it has come to.
  /** Gives a vertex a value of a label if it is lower. @param isAlong  whether the value comes
   * along an edge, or else across a triangle */
  virtual void lower(const LabelAtVertex& place, double key, bool isAlong) = 0;
  /** Updates the neighbours of a vertex of another thread when the front next advances. */
  virtual void updateRound(const LabelAtVertex& place) = 0;
  /** Puts an item into the queue that waited in another thread's. */
  virtual void take(Index item) = 0;
  /** Removes the items for vertices that this thread does not own any more from the queue, and
   * calls give(item, vertex) for each. */
  virtual void giveUp(const std::function<void(Index item, Index vertex)>& give) = 0;
};

}

#endif
