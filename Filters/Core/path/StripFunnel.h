// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StripFunnel_h
#define geodesic_StripFunnel_h

#include "path/PathPoint.h"
#include "path/WeightedMesh.h"

#include <vector>

namespace geodesic
{

/** A part of a path that is straight when the faces it crosses are laid flat. */
struct StraightPiece
{
  PathPoint start;
  PathPoint end;
  /** The faces that the piece crosses, at least one; consecutive ones share an edge. */
  std::vector<Triangle> faces;
  /** The points at which the piece crosses from each face to the next. */
  std::vector<PathPoint> crossings;
  /** In mesh length units. */
  double length = 0.0;

  /** The point of the path after start, and the one before end. */
  const PathPoint& second() const
  {
    return this->crossings.empty() ? this->end : this->crossings.front();
  }
  const PathPoint& lastButOne() const
  {
    return this->crossings.empty() ? this->start : this->crossings.back();
  }
};

/** Appends a face to a strip. If it is the last face but one, the last face is removed instead, so
 * that the strip does not turn back on itself; if it is the last face, nothing changes. */
void appendFace(std::vector<Triangle>& faces, const Triangle& face);

/**
 * The shortest path from @p start to @p end inside a strip of faces. The strip is laid flat and
 * searched by a funnel: D. T. Lee, F. P. Preparata, Euclidean shortest paths in the presence of
 * rectilinear barriers, Networks 14 (1984).
 * @param faces the strip: consecutive faces share an edge; the first contains start, the last end
 * @return straight pieces that join at vertices of the strip. No piece begins and ends at the same
 *         vertex; there is no piece if start and end are the same vertex.
 * @throws SearchCancelled
 * Time O(number of faces) but for contrived strips.
 */
std::vector<StraightPiece> shortestInStrip(const WeightedMesh& surface, const PathPoint& start,
  const PathPoint& end, const std::vector<Triangle>& faces);

}

#endif
