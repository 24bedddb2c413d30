// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestSeed_h
#define geodesic_NearestSeed_h

#include "base/Index.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <span>

namespace geodesic
{

/**
 * The smallest number of a seed whose value at a vertex equals the best one, to 1e-10.
 * @param secondary  SecondaryValues or SharedSecondaryValues
 * @param distance   of the vertex
 * @param seed       that of the best value
 */
template <class Secondary>
Index nearestSeedOf(const Secondary& secondary, std::span<const Label> labels, Index vertex,
  double distance, Index seed)
{
  constexpr double rounding = 1.0 + 1e-10;
  secondary.visitSecondary(vertex,
    [&](const auto& value)
    {
      if (value.distance <= distance * rounding)
      {
        seed = std::min(seed, labels[value.state.label()].seed);
      }
    });
  return seed;
}

}

#endif
