// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NeighbourValues_h
#define geodesic_NeighbourValues_h

#include "base/Index.h"
#include "base/Lanes.h"

#include <array>

namespace geodesic
{

/** How an update comes to a vertex: along an edge, or across the one opposite to the vertex. */
enum class Way
{
  Along,
  Across
};

/** The value of one label at a vertex, as an update of the vertex needs it. */
struct NeighbourValue
{
  /** The distance without the value of the label's seed; +infinity if the label has none there. */
  double value;
  /** Only new values below this one count. It is at most the value, and less if the vertex would
   * drop a value of this label between the two (see labelMargin()). */
  double ceiling;
  /** Whether the value waits in the queue. */
  bool isQueued;
};

/**
 * The best values of two or four vertices, which may be of different labels, read for an update for
 * one label. In a mask, bit i belongs to vertex i.
 */
template <class Real>
struct BestValues
{
  /** The distances less the value of the seed of the update's label; +infinity if there is none. */
  Real values;
  /** Mask of vertices whose best value is of another label. What they have for the update's label
   * must be looked up apart. */
  unsigned areOther;
  /** Mask of the other vertices whose values wait in the queue. */
  unsigned areQueued;
};

/** A NeighbourValue for each of two or four vertices; bit i of areQueued is isQueued of vertex i.
 */
template <class Real>
struct NeighbourValues
{
  Real values;
  Real ceilings;
  unsigned areQueued;
};

/** The numbers of vertices, as many as a Real has lanes. */
template <class Real>
using Indices = std::array<Index, lanes<Real>>;

struct SourceFront;

/** A value that was taken from the queue. */
struct PoppedValue
{
  /** The vertex of the value; NoIndex if the value is out of date or not kept any more, and there
   * is nothing to do. */
  Index vertex;
  /** The label of the value, if there is a vertex. */
  const SourceFront* label;
  /** The distance without the value of the label's seed. */
  double value;
};

}

#endif
