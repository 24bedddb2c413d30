// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfacePoint_h
#define geodesic_SurfacePoint_h

#include "base/Index.h"

#include <array>

namespace geodesic
{

/**
 * A point on a triangle mesh: a triangle and barycentric weights (each in [0, 1], sum 1) of its
 * three corners. One weight of exactly 0 means that the point is on an edge, two that it is at a
 * vertex.
 */
struct SurfacePoint
{
  Index triangle = NoIndex;
  std::array<double, 3> weights = { 1.0, 0.0, 0.0 };

  friend constexpr bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

/**
 * Returns the point with every weight below @p tolerance set to exactly 0 and the others scaled to
 * the sum 1. A projection gives points that should lie on an edge weights as small as rounding
 * errors, and the eikonal update is badly conditioned for a source so close to an edge but not on
 * it.
 */
inline SurfacePoint snapped(SurfacePoint point, double tolerance = 1e-9)
{
  double sum = 0.0;
  for (double& weight : point.weights)
  {
    weight = weight < tolerance ? 0.0 : weight;
    sum += weight;
  }
  for (double& weight : point.weights)
  {
    weight /= sum;
  }
  return point;
}

}

#endif
