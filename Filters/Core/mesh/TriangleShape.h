// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleShape_h
#define geodesic_TriangleShape_h

#include <algorithm>
#include <cmath>

namespace geodesic
{

/**
 * Four times the area of a triangle, by the lengths of its sides. Accurate for needles too, and 0
 * for lengths that rounding made longer than the other two together.
 * W. Kahan, Miscalculating area and angles of a needle-like triangle (2014).
 */
inline double fourAreas(double a, double b, double c)
{
  const double most = std::max({ a, b, c });
  const double least = std::min({ a, b, c });
  const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
  const double square = (most + (middle + least)) * (least - (most - middle)) *
    (least + (most - middle)) * (most + (middle - least));
  return square > 0.0 ? std::sqrt(square) : 0.0;
}

/** Twice the product of the sides a and b and the cosine of the angle between them, for a third
 * side c. */
inline double twiceDot(double a, double b, double c)
{
  // Exact where the sides are near each other.
  return (a - c) * (a + c) + b * b;
}

}

#endif
