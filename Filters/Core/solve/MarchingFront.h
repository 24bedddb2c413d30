// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchingFront_h
#define geodesic_MarchingFront_h

#include "base/Index.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace geodesic
{

/**
 * A march that can stop and continue: the interface through which a Partition drives the solver on
 * a piece. As the march is label correcting, the caller may lower values between two calls of
 * advance(). "Distances" here include the seed's own value.
 */
class MarchingFront
{
public:
  using Visit = std::function<void(Index label, double value)>;

  virtual ~MarchingFront() = default;

  /** Takes vertices from the queue, also those added meanwhile, until hardly any has a distance
   * below @p limit or the run is cancelled. If nextDistance() is below @p limit, it takes at least
   * one.
   * @param taken  gets the vertices that were taken, some of them several times; may be null. Each
   * vertex whose value falls waits in the queue then, so that it is taken sooner or later. */
  virtual void advance(double limit, std::vector<Index>* taken) = 0;
  /** A lower bound of all distances in the queue; infinity where the queue is empty. */
  virtual double nextDistance() const = 0;
  /** TriangleMesh::meanLongestEdge() times the mean cost. On a piece without edges 0 or any other
   * finite number. */
  virtual double meanLongestEdge() const = 0;
  /** The same with what most vertices cost at least: far less where costs are spread over orders of
   * magnitude. */
  virtual double typicalEdge() const { return this->meanLongestEdge(); }
  /** The number of vertices taken from the queue so far. */
  virtual std::size_t numberOfUpdates() const = 0;
  virtual bool isCancelled() const = 0;
  /** Calls visit(label, value) for each value that a vertex keeps, in the form that lower() takes.
   * In fast marching a value leaves out the seed's own value. */
  virtual void visitValues(Index vertex, const Visit& visit) const = 0;
  /** Takes over a value of another piece if it is enough below the vertex's own; see visitValues.
   */
  virtual void lower(Index vertex, Index label, double value) = 0;
};

}

#endif
