// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Strip_h
#define geodesic_Strip_h

#include "base/Index.h"
#include "base/PlanePoint.h"
#include "mesh/TriangleMesh.h"
#include "path/PathPoint.h"

#include <span>
#include <vector>

namespace geodesic
{

/** The edge by which a face of a strip is entered, laid flat. */
struct Portal
{
  PlanePoint left;
  PlanePoint right;
};

/** A face of a strip: the edge by which it is entered, as seen on a walk along the strip, and the
 * corner beyond that edge. The first face of a strip is not entered, so that its order means
 * nothing. */
struct StripFace
{
  Index left;
  Index right;
  Index apex;
  /** All faces of a strip lie in one plane. */
  Portal entry{};

  constexpr bool hasCorner(Index vertex) const
  {
    return vertex == this->left || vertex == this->right || vertex == this->apex;
  }
  constexpr bool isEnteredBy(Index a, Index b) const
  {
    return (a == this->left && b == this->right) || (a == this->right && b == this->left);
  }
  Triangle corners() const { return { this->left, this->right, this->apex }; }
};

/** Consecutive faces share an edge. No face is left by the edge by which it was entered. */
using Strip = std::vector<StripFace>;

/** Appends a face that shares an edge with the last one, or is the last one, and lays it flat.
 * Where the strip would turn back on itself, it becomes shorter instead. */
void appendFace(const TriangleMesh& mesh, Strip& strip, const Triangle& face);

/** The face beyond an edge of a face that is not the one by which that face is entered.
 * @param flatApex  of @p last
 * @param side  the end of the edge that is not the apex: last.left or last.right
 * @param apex  the corner of the new face that is not on the edge */
inline StripFace faceBeyond(
  const StripFace& last, const PlanePoint& flatApex, Index side, Index apex)
{
  // The side stays where it is, and the corner of the last face is the other one.
  return side == last.left ? StripFace{ side, last.apex, apex, { last.entry.left, flatApex } }
                           : StripFace{ last.apex, side, apex, { flatApex, last.entry.right } };
}

/** Appends all faces of a strip, as appendFace(). What is flat is moved as a whole. Time O(number
 * of its faces). */
void appendStrip(const TriangleMesh& mesh, Strip& strip, const Strip& other);

/** The place in the plane of the corner beyond the edge by which a face is entered. */
PlanePoint flatApex(const TriangleMesh& mesh, const StripFace& face);

/** The place in the plane of a point of the first or of the last of some faces. @pre two faces at
 * least */
PlanePoint flatInFirst(
  const TriangleMesh& mesh, std::span<const StripFace> strip, const PathPoint& point);
PlanePoint flatInLast(
  const TriangleMesh& mesh, std::span<const StripFace> strip, const PathPoint& point);

}

#endif
