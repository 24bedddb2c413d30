// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelMargin_h
#define geodesic_LabelMargin_h

#include "base/Lanes.h"

namespace geodesic
{

/** The factor 3 of labelMargin(). */
constexpr double LabelMarginPerSpread = 3.0;

/**
 * The margin that one triangle asks for: how much a label's value at a corner of the triangle may
 * exceed the best value there and be kept; see SecondaryValues. The margin of a vertex is the
 * largest of the triangles round it.
 *
 * If a label has the best value at a point of an edge, its values at the ends of the edge exceed
 * the best ones there by at most twice the edge's length. More is needed, because a value beside
 * one that was dropped is too high. With each update such an error moves sideways to the front, by
 * a part of an edge, nearer to where the label is the best: with a side of length c and a height h
 * its place changes with a variance of up to c² / 4 in a step of at least h. A detour over places
 * where values are wrong by e is then as rare as exp(-e / (c² / h)), with a constant factor in the
 * exponent. So the margin is proportional to c² / h.
 *
 * The factor 3, and for thin triangles the bound of 6 longest sides, leave an error of at most
 * 1e-9 of a distance at single points of icospheres, tori and regular grids. A part of it depends
 * on the order of the march, at most 1e-10 in 42 fields of a hundred seeds. On random triangles
 * that are stretched the bound leaves more: stretched three times, 1e-6 at single points.
 * @tparam Real  double, or Pair or Quad for several triangles at once
 * @return the margin for cost 1, in mesh length units
 */
template <class Real>
GEODESIC_INLINED Real labelMargin(Real longestSide, Real leastHeight)
{
  constexpr double mostSides = 6.0;
  return longestSide * least(LabelMarginPerSpread * longestSide / leastHeight, Real() + mostSides);
}

/**
 * The inverse of labelMargin(): the least height of a triangle with a longest side and a margin. If
 * the margin is the bound of 6 longest sides it returns half of the longest side, which is more
 * than the height; 0 for a margin of 0.
 */
inline double heightOfMargin(double longestSide, double margin)
{
  return margin > 0.0 ? LabelMarginPerSpread * longestSide * longestSide / margin : 0.0;
}

}

#endif
