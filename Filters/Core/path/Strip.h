// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Strip_h
#define geodesic_Strip_h

#include "base/Index.h"
#include "mesh/TriangleMesh.h"
#include "path/PathPoint.h"

#include <vector>

namespace geodesic
{

/** A face of a strip: the edge by which it is entered, as seen on a walk along the strip, and the
 * corner beyond that edge. The first face of a strip is not entered, so that its order means
 * nothing. */
struct StripFace
{
  Index left;
  Index right;
  Index apex;
  /** Where a straight piece enters, as a fraction of the edge from left to right. */
  double crossing = 0.0;

  constexpr bool hasCorner(Index vertex) const
  {
    return vertex == this->left || vertex == this->right || vertex == this->apex;
  }
  constexpr bool isEnteredBy(Index a, Index b) const
  {
    return (a == this->left && b == this->right) || (a == this->right && b == this->left);
  }
  Triangle corners() const { return { this->left, this->right, this->apex }; }
  PathPoint crossingPoint() const;
};

/** Consecutive faces share an edge. No face is left by the edge by which it was entered. */
using Strip = std::vector<StripFace>;

/** Appends a face that shares an edge with the last one, or is the last one. Where the strip would
 * turn back on itself, it becomes shorter instead. */
void appendFace(Strip& strip, const Triangle& face);

/** Appends all faces of a strip, as appendFace(). Time O(number of its faces). */
void appendStrip(Strip& strip, const Strip& other);

}

#endif
