// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Loose segments of lines, as a slice gives them, that are solved as one line where nobody asks
// which of them is the nearest.
#include "solve/JoinedCurves.h"
#include "Solving.h"
#include "Surfaces.h"
#include "march/FastMarchingSolver.h"
#include "mesh/TriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace geodesic::testing
{
namespace
{

/** Edges along a row of a grid of squares, each a seed, in any order and direction. */
std::vector<Seed> edgesOfRow(const TriangleMesh& mesh, Index cells, Index row)
{
  std::vector<Seed> seeds;
  for (Index i = 0; i < cells; ++i)
  {
    const auto pointAt = [&](Index column)
    { return mesh.pointAtVertex(mesh.vertexOfPoint(row * (cells + 1) + column)); };
    seeds.push_back(i % 3 == 0 ? Seed::alongCurve({ pointAt(i + 1), pointAt(i) })
                               : Seed::alongCurve({ pointAt(i), pointAt(i + 1) }));
  }
  std::shuffle(seeds.begin(), seeds.end(), std::mt19937(3));
  return seeds;
}

constexpr Index Cells = 40;

}

TEST(JoinedCurves, ALooseLineIsOne)
{
  // Up and down the hills, but straight seen from above.
  const auto mesh = meshOf(hillyGrid(Cells, Cells));
  std::vector<Seed> seeds = edgesOfRow(*mesh, Cells, Cells / 2);
  seeds.push_back(seeds[5]);
  std::swap(seeds.back().points[0], seeds.back().points[1]);
  const auto joined = joinedCurves(*mesh, seeds, [] { return true; });
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].seed, 0u);
  EXPECT_EQ(joined[0].numberOfSeeds, Cells);
  ASSERT_EQ(joined[0].points.size(), Cells + 1u);
  const double first = mesh->positionOf(joined[0].points[0]).x;
  for (Index i = 0; i <= Cells; ++i)
  {
    EXPECT_EQ(std::abs(mesh->positionOf(joined[0].points[i]).x - first), i);
  }
}

TEST(JoinedCurves, WhereTheyBendOrMeetOthersTheyStayApart)
{
  const auto mesh = meshOf(planeGrid(Cells, Cells, Cells, Cells));
  const auto pointAt = [&](Index column, Index row)
  { return mesh->pointAtVertex(mesh->vertexOfPoint(row * (Cells + 1) + column)); };
  // A right angle, a closed square, a point where three meet, and another value.
  std::vector<Seed> seeds{ Seed::alongCurve({ pointAt(1, 1), pointAt(2, 1) }),
    Seed::alongCurve({ pointAt(2, 1), pointAt(2, 2) }),
    Seed::alongCurve({ pointAt(10, 1), pointAt(11, 1), pointAt(11, 2) }),
    Seed::alongCurve({ pointAt(11, 2), pointAt(10, 2), pointAt(10, 1) }),
    Seed::alongCurve({ pointAt(20, 1), pointAt(21, 1) }),
    Seed::alongCurve({ pointAt(21, 1), pointAt(22, 1) }),
    Seed::alongCurve({ pointAt(21, 1), pointAt(21, 2) }),
    Seed::alongCurve({ pointAt(30, 1), pointAt(31, 1) }),
    Seed::alongCurve({ pointAt(31, 1), pointAt(32, 1) }), Seed::atPoint(pointAt(32, 1)) };
  seeds[8].value = 0.5;
  const auto joined = joinedCurves(*mesh, seeds, [] { return true; });
  ASSERT_EQ(joined.size(), 9u);
  for (std::size_t i = 0; i < joined.size(); ++i)
  {
    EXPECT_EQ(joined[i].seed, i);
    EXPECT_EQ(joined[i].numberOfSeeds, 1u);
    EXPECT_EQ(joined[i].points, seeds[i].points);
  }
}

TEST(JoinedCurves, TheFieldIsAsExactAndTakesFewerUpdates)
{
  const auto mesh = meshOf(planeGrid(Cells, Cells, Cells, Cells));
  const std::vector<Seed> seeds = edgesOfRow(*mesh, Cells, Cells / 2);
  FastMarchingSolver solver(mesh);
  SolveOptions options;
  std::size_t reports = 0;
  options.progressInterval = 1;
  options.onProgress = [&](std::size_t)
  {
    ++reports;
    return true;
  };
  solver.solve(seeds, options);
  const std::size_t numbered = std::exchange(reports, 0);
  options.numbersSeeds = false;
  const DistanceField& field = solver.solve(seeds, options);
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    EXPECT_NEAR(field.distance(v), std::abs(mesh->position(v).y - Cells / 2), 1e-12);
    EXPECT_LT(field.nearestSeed(v), seeds.size());
  }
  EXPECT_LT(reports, numbered);
  EXPECT_LE(reports, 2 * mesh->numberOfVertices());
}

}
