// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_ClosedTwins_h
#define geodesic_testing_ClosedTwins_h

#include "Solving.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace geodesic::testing
{

/** Two squares in a row, of which the second one's triangles lie there twice. Where one of each two
 * is closed, the far side is out of reach, whichever of the two it is. */
template <class Solver>
void expectClosedTwins()
{
  const Surface strip = planeGrid(3, 1, 3.0, 1.0);
  for (const bool isFirstClosed : { true, false })
  {
    Surface twice = strip;
    for (std::size_t t = 2; t < 4; ++t)
    {
      const Triangle& corners = strip.triangles[t];
      twice.triangles.push_back({ corners[1], corners[2], corners[0] });
    }
    const auto mesh = meshOf(twice);
    std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
    for (Index t = 0; t < closed.size(); ++t)
    {
      const auto source = mesh->sourceOfTriangle(t);
      closed[t] = isFirstClosed ? source == 2 || source == 3 : source >= 6;
    }
    SolveOptions options;
    options.closedTriangles = closed;
    const std::vector<double> found = distances<Solver>(mesh, { seedAt(*mesh, 0) }, options);
    EXPECT_FALSE(std::isfinite(found[3])) << isFirstClosed;
    EXPECT_FALSE(std::isfinite(found[7])) << isFirstClosed;
    EXPECT_NEAR(found[1], 1.0, 1e-12);
    EXPECT_NEAR(found[5], std::sqrt(2.0), 1e-12);
  }
}

}

#endif
