// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What a path costs, by which paths through varying cost are compared.

#include "PathStyles.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** A strip of two triangles: their common edge goes from point 0 to point 2. */
const Surface square{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
  { { 0, 1, 2 }, { 0, 2, 3 } } };

double costOnSquare(const std::vector<double>& cost, const SurfacePath& path)
{
  const auto mesh = meshOf(square);
  SolveOptions options;
  options.cost = cost;
  SearchProgress progress(options);
  return costOf(WeightedMesh(*mesh, options, progress), path);
}

}

TEST(PathCost, IsTheLengthWithoutCosts)
{
  const SurfacePath path{ PathPoint::atVertex(1), PathPoint::onEdge(0, 2, 0.5),
    PathPoint::atVertex(3) };
  EXPECT_NEAR(costOnSquare({}, path), std::sqrt(2.0), 1e-14);
}

TEST(PathCost, IsTheSumOfThoseInTheFaces)
{
  // Faces of costs (1 + 4 + 1) / 3 and (1 + 1 + 22) / 3.
  const std::vector<double> cost{ 1.0, 4.0, 1.0, 22.0 };
  const double half = std::sqrt(0.5);
  const SurfacePath across{ PathPoint::atVertex(1), PathPoint::onEdge(0, 2, 0.5),
    PathPoint::atVertex(3) };
  EXPECT_NEAR(costOnSquare(cost, across), 2.0 * half + 8.0 * half, 1e-13);
  // Along their common edge the cheaper one counts, along another edge its own face.
  const SurfacePath along{ PathPoint::atVertex(0), PathPoint::onEdge(0, 2, 0.3),
    PathPoint::atVertex(2), PathPoint::atVertex(3) };
  EXPECT_NEAR(costOnSquare(cost, along), 2.0 * std::sqrt(2.0) + 8.0, 1e-13);
}

// The field's value at the start is what the path from there costs.
TEST(PathCost, IsTheDistanceAtItsStart)
{
  const auto mesh = meshOf(planeGrid(64, 64, 1.0, 1.0));
  std::vector<double> cost(mesh->numberOfVertices());
  for (Index v = 0; v < cost.size(); ++v)
  {
    cost[v] = mesh->position(v).x < 0.5 ? 1.0 : 3.0;
  }
  SolveOptions options;
  options.cost = cost;
  const Index start = mesh->vertexOfPoint(13 * 65 + 6);
  const SurfacePoint from = mesh->pointAtVertex(start);
  const SurfacePoint to = mesh->pointAtVertex(mesh->vertexOfPoint(51 * 65 + 58));
  FastMarchingSolver solver(mesh);
  PathFinder finder(solver, { &to, 1 }, options, Traced);
  ASSERT_TRUE(finder.march({ &from, 1 }));
  const auto path = finder.pathFrom(from);
  ASSERT_TRUE(path);
  const double distance = finder.field().distance(start);
  EXPECT_NEAR(finder.cost(), distance, 5e-3 * distance);
  EXPECT_GT(finder.cost(), 1.3 * lengthOf(*mesh, *path));
}
