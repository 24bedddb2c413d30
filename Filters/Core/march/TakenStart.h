// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TakenStart_h
#define geodesic_TakenStart_h

#include "base/Index.h"
#include "solve/DistanceField.h"

#include <algorithm>

namespace geodesic
{

/**
 * Gives a vertex the distance of a seed that starts there, if it is less than its own. Of seeds
 * that are equally near the smallest number counts.
 * @return whether the distance is less
 */
inline bool takeStart(DistanceField& field, Index vertex, Index seed, double distance)
{
  constexpr double rounding = 1.0 + 1e-10;
  const double known = field.distance(vertex);
  if (distance < known)
  {
    field.setDistance(vertex, distance);
  }
  if (distance * rounding < known)
  {
    field.setNearestSeed(vertex, seed);
  }
  else if (distance <= known * rounding)
  {
    field.setNearestSeed(vertex, std::min(field.nearestSeed(vertex), seed));
  }
  return distance < known;
}

}

#endif
