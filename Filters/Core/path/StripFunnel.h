// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StripFunnel_h
#define geodesic_StripFunnel_h

#include "path/PathPoint.h"
#include "path/Strip.h"
#include "path/WeightedMesh.h"

#include <vector>

namespace geodesic
{

/** A part of a path that is straight when the faces it crosses are laid flat. */
struct StraightPiece
{
  PathPoint start;
  PathPoint end;
  /** The faces that the piece crosses, with the crossings; none if it runs along one edge. */
  Strip strip;
  /** In mesh length units. */
  double length = 0.0;

  /** The point of the path after start, and the one before end. */
  PathPoint second() const
  {
    return this->strip.size() < 2 ? this->end : this->strip[1].crossingPoint();
  }
  PathPoint lastButOne() const
  {
    return this->strip.size() < 2 ? this->start : this->strip.back().crossingPoint();
  }
};

/**
 * The shortest path from @p start to @p end inside a strip of faces. The strip is laid flat and
 * searched by a funnel: D. T. Lee, F. P. Preparata, Euclidean shortest paths in the presence of
 * rectilinear barriers, Networks 14 (1984).
 * @param strip at least one face; the first contains start, the last end
 * @return straight pieces that join at vertices of the strip. No piece begins and ends at the same
 *         vertex; there is no piece if start and end are the same vertex.
 * @throws SearchCancelled
 * Time O(number of faces).
 */
std::vector<StraightPiece> shortestInStrip(
  const WeightedMesh& surface, const PathPoint& start, const PathPoint& end, const Strip& strip);

}

#endif
