// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelMargin_h
#define geodesic_LabelMargin_h

#include "base/Lanes.h"

namespace geodesic
{

/** See labelMargin(). */
constexpr double LabelMarginPerSpread = 2.5;

/**
 * How much more than a vertex's best value a value of another label may be there to be kept, as far
 * as a triangle round the vertex asks for it; see SecondaryValues.
 *
 * Where a seed wins at a point of an edge, its value at the ends of the edge exceeds the best one
 * there by at most twice the edge's length. More is needed, as a value beside one that was dropped
 * is too high. From update to update what is wrong comes a part of an edge nearer to where the seed
 * wins, sideways to its way: over a side of length c and a height h with a variance of up to
 * c^2 / 4 in a step of at least h. A detour over where values are wrong by e is then as rare as
 * exp(-e / (c^2 / h)), times a constant in the exponent. So the margin goes with c^2 / h. 2.5 of
 * it leave, with a part that depends on the order of the march, at most 5e-8 of a distance at
 * single points of icospheres, tori and regular grids, as 5 longest sides do for their thinner
 * triangles. Where random triangles are stretched, those 5 leave more: three times, 2e-4 at single
 * points and 2e-8 on the mean; ten times, 6e-3 and 5e-5.
 * @tparam Real  double, or Pair or Quad for several triangles at once
 */
template <class Real>
GEODESIC_INLINED Real labelMargin(Real longestSide, Real leastHeight)
{
  constexpr double mostSides = 5.0;
  return longestSide * least(LabelMarginPerSpread * longestSide / leastHeight, Real() + mostSides);
}

/** The least height of which labelMargin() tells; half of the longest side where it is less. */
inline double heightOfMargin(double longestSide, double margin)
{
  return margin > 0.0 ? LabelMarginPerSpread * longestSide * longestSide / margin : 0.0;
}

}

#endif
