// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StripFunnel_h
#define geodesic_StripFunnel_h

#include "path/PathPoint.h"

#include <vector>

namespace geodesic
{

/** A part of a path that is straight when the faces it crosses are laid flat. */
struct StraightPiece
{
  PathPoint start;
  PathPoint end;
  /** One at least; consecutive ones share an edge. */
  std::vector<Triangle> faces;
  /** Where the piece crosses from each face to the next. */
  std::vector<PathPoint> crossings;
  double length = 0.0;

  const PathPoint& second() const
  {
    return this->crossings.empty() ? this->end : this->crossings.front();
  }
  const PathPoint& lastButOne() const
  {
    return this->crossings.empty() ? this->start : this->crossings.back();
  }
};

/** Appends a face to a strip; a strip that turns back on itself becomes one that does not. */
void appendFace(std::vector<Triangle>& faces, const Triangle& face);

/**
 * The shortest way from @p start to @p end inside a strip of faces, as straight pieces that join
 * at vertices of the strip. The strip is laid flat and searched by a funnel: D. T. Lee,
 * F. P. Preparata, Euclidean shortest paths in the presence of rectilinear barriers, Networks 14
 * (1984).
 * No piece begins and ends in the same vertex; there is none where start and end are one.
 * @param faces consecutive ones share an edge; the first contains start, the last end
 * Time O(number of faces) but for contrived strips.
 */
std::vector<StraightPiece> shortestInStrip(const TriangleMesh& mesh, const PathPoint& start,
  const PathPoint& end, const std::vector<Triangle>& faces);

}

#endif
