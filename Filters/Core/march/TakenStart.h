// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TakenStart_h
#define geodesic_TakenStart_h

#include "solve/DistanceField.h"
#include "solve/SeedFront.h"
#include "solve/StartValue.h"

#include <algorithm>
#include <span>

namespace geodesic
{

/**
 * Gives a vertex the distance of a label that starts there, if it is less than its own. Of seeds
 * that are equally near the smallest number counts.
 * @return whether the distance is less
 */
inline bool takeStart(const StartValue& start, std::span<const Label> labels, DistanceField& field)
{
  constexpr double rounding = 1.0 + 1e-10;
  const Label& label = labels[start.label];
  const double distance = start.value + label.value;
  const double known = field.distance(start.vertex);
  if (distance < known)
  {
    field.setDistance(start.vertex, distance);
  }
  if (distance * rounding < known)
  {
    field.setNearestSeed(start.vertex, label.seed);
  }
  else if (distance <= known * rounding)
  {
    field.setNearestSeed(start.vertex, std::min(field.nearestSeed(start.vertex), label.seed));
  }
  return distance < known;
}

}

#endif
