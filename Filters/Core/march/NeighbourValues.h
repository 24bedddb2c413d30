// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NeighbourValues_h
#define geodesic_NeighbourValues_h

#include "base/Index.h"
#include "base/Lanes.h"

#include <array>

namespace geodesic
{

/** What a front knows of a vertex. */
struct NeighbourValue
{
  /** +infinity where the front has not been. */
  double value;
  /** Nothing at or above it is of interest; at most the value. */
  double ceiling;
  /** The vertex waits to be swept with this value. */
  bool isQueued;
};

/** What it sees of several at a glance, in bits 0, 1 and so on where it is a mask. */
template <class Real>
struct BestValues
{
  /** +infinity where there is none. */
  Real values;
  /** The value is of another label than the one that is swept: what that one has is to be asked
   * for apart. */
  unsigned areOther;
  /** As in NeighbourValue; not of others. */
  unsigned areQueued;
};

/** What a front knows of several, isQueued in bits 0, 1 and so on; see NeighbourValue. */
template <class Real>
struct NeighbourValues
{
  Real values;
  Real ceilings;
  unsigned areQueued;
};

/** As many vertices as a Real has numbers. */
template <class Real>
using Indices = std::array<Index, lanes<Real>>;

struct SourceFront;

/** A value that was taken from the queue. */
struct PoppedValue
{
  /** NoIndex where it is no longer of interest. */
  Index vertex;
  /** Of the value, where that is of interest. */
  const SourceFront* label;
  double value;
};

}

#endif
