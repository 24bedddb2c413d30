// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Arrival_h
#define geodesic_Arrival_h

#include "base/Index.h"

namespace geodesic
{

/** How the shortest path to a point comes there. */
struct Arrival
{
  enum class Kind
  {
    /** From its seed, straight within one triangle. */
    FromSeed,
    /** From a vertex, straight within one triangle or along an edge. */
    FromVertex,
    /** Across the edge of a half-edge of the point's triangle. */
    AcrossEdge
  };

  Kind kind = Kind::FromSeed;
  /** The seed, the vertex, or the half-edge. */
  Index number = NoIndex;
  /** Across an edge, in the plane of the half-edge (see Window): the place on the edge, the source
   * of the straight line, and the distance there. */
  double place = 0.0;
  double x = 0.0;
  double y = 0.0;
  double offset = 0.0;

  static Arrival fromSeed(Index seed) { return { Kind::FromSeed, seed, 0, 0, 0, 0 }; }
  static Arrival fromVertex(Index vertex) { return { Kind::FromVertex, vertex, 0, 0, 0, 0 }; }
};

}

#endif
