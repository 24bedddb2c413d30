// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PieceWeights_h
#define geodesic_PieceWeights_h

#include "path/PathPoint.h"

#include <array>

namespace geodesic
{

/**
 * The weights of a point of a triangle with respect to a smaller triangle inside it.
 * @param inner    corners of the smaller triangle
 * @param outer    corners of the larger one
 * @param weights  of the point in the larger one
 * @return some of them are negative if the point is outside the smaller one; -1 each if that has no
 *         area
 */
inline std::array<double, 3> weightsIn(const std::array<PathPoint, 3>& inner, const Triangle& outer,
  const std::array<double, 3>& weights)
{
  // Two of the barycentric weights are affine coordinates in the triangle.
  const auto x = [&](int i) { return weightOf(inner[i], outer[1]); };
  const auto y = [&](int i) { return weightOf(inner[i], outer[2]); };
  const double determinant = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
  if (determinant == 0.0)
  {
    return { -1.0, -1.0, -1.0 };
  }
  const double px = weights[1] - x(0);
  const double py = weights[2] - y(0);
  const double second = (px * (y(2) - y(0)) - (x(2) - x(0)) * py) / determinant;
  const double third = ((x(1) - x(0)) * py - px * (y(1) - y(0))) / determinant;
  return { 1.0 - second - third, second, third };
}

}

#endif
