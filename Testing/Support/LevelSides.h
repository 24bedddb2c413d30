// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_LevelSides_h
#define geodesic_testing_LevelSides_h

#include "path/PathPoint.h"

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace geodesic::testing
{

/** The curves along which a function on a manifold surface is zero, each closed or from border to
 * border, and what their sides are by a flood over the vertices on which the function has one sign.
 */
struct LevelSides
{
  std::vector<SurfacePath> curves;
  /** The sign of each vertex, 0 where no curve is; none if some curve does not separate alone. */
  std::optional<std::vector<std::int8_t>> signs;
};

/**
 * @param values  the function at each vertex, nowhere 0, linear in each face
 * @param random  for the directions of the curves
 */
LevelSides levelSides(
  const TriangleMesh& mesh, std::span<const double> values, std::mt19937& random);

/** A random function: a ball with waves on it, round a vertex. */
std::vector<double> randomLevels(const TriangleMesh& mesh, std::mt19937& random);

}

#endif
