// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchingFront_h
#define geodesic_MarchingFront_h

#include "base/Index.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

/**
 * A march that can stop and go on: what a Partition needs of the solver on a piece. As the march is
 * label correcting, values may be lowered from outside at any time between two advances.
 */
class MarchingFront
{
public:
  using Visit = std::function<void(Index label, double value)>;

  virtual ~MarchingFront() = default;

  /** Takes from the queue what lies below a distance, and what that adds, until nothing does. */
  virtual void advance(double limit) = 0;
  /** No distance that waits in the queue is less; infinity where none does. */
  virtual double nextDistance() const = 0;
  /** What an edge of TriangleMesh::meanLongestEdge() adds to a distance; 0 on a piece without
   * edges, or any number. */
  virtual double meanLongestEdge() const = 0;
  /** How many vertices were taken from the queue so far. */
  virtual std::size_t numberOfUpdates() const = 0;
  virtual bool isCancelled() const = 0;
  /** The values that a vertex keeps, without those of the seeds themselves. */
  virtual void visitValues(Index vertex, const Visit& visit) const = 0;
  /** Takes a value over where it counts; see visitValues. */
  virtual void lower(Index vertex, Index label, double value) = 0;
};

}

#endif
