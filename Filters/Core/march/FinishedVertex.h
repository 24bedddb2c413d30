// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FinishedVertex_h
#define geodesic_FinishedVertex_h

#include "march/FieldValues.h"
#include "march/LabelBounds.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <span>

namespace geodesic
{

/** The smallest number of a seed whose value at a vertex equals the best one, to 1e-10.
 * @param secondary  SecondaryValues or SharedSecondaryValues
 * @param seed       that of the best value */
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

/**
 * Sets the nearest seed of a vertex in the field after a march of several labels, and removes the
 * vertex's values. @param bounds of the values that count; null if there are none
 * @pre the vertex has values
 * @return whether its nearest label may end before a neighbour, see LabelBounds
 */
template <class Cost, class Secondary>
bool finishVertex(const MarchContext<Cost>& context, std::span<const Label> labels,
  Secondary& secondary, const LabelBounds* bounds, Index vertex)
{
  VertexState& state = context.states[vertex];
  const Index label = state.label();
  const Label& nearest = labels[label];
  const double distance = context.field.distance(vertex);
  context.field.setNearestSeed(
    vertex, nearestSeedOf(secondary, labels, vertex, distance, nearest.seed));
  if (secondary.hasSecondary(vertex))
  {
    secondary.clear(vertex);
  }
  state = {};
  return bounds && bounds->mayEnd(label, distance - nearest.value + context.cost.reach(vertex));
}

}

#endif
