// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What a path costs, by which paths through varying cost are compared.

#include "PathStyles.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

const Surface square{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
  { { 0, 1, 2 }, { 0, 2, 3 } } };

/** A strip of two triangles, whose common edge goes from point 0 to point 2, with costs. */
class PathCost : public ::testing::Test
{
protected:
  PathPoint at(Index point) const { return PathPoint::atVertex(this->Mesh->vertexOfPoint(point)); }
  PathPoint onDiagonal(double fraction) const
  {
    return PathPoint::onEdge(this->Mesh->vertexOfPoint(0), this->Mesh->vertexOfPoint(2), fraction);
  }
  double costOf(const SurfacePath& path, const std::vector<double>& costOfPoints = {}) const
  {
    std::vector<double> cost(costOfPoints.size());
    for (Index point = 0; point < cost.size(); ++point)
    {
      cost[this->Mesh->vertexOfPoint(point)] = costOfPoints[point];
    }
    SolveOptions options;
    options.cost = cost;
    SearchProgress progress(options);
    return geodesic::costOf(WeightedMesh(*this->Mesh, options, progress), path);
  }

  const std::shared_ptr<const TriangleMesh> Mesh = meshOf(square);
};

}

TEST_F(PathCost, IsTheLengthWithoutCosts)
{
  EXPECT_NEAR(
    this->costOf({ this->at(1), this->onDiagonal(0.5), this->at(3) }), std::sqrt(2.0), 1e-14);
}

TEST_F(PathCost, IsTheSumOfThoseInTheFaces)
{
  // Faces of costs (1 + 4 + 1) / 3 and (1 + 1 + 22) / 3.
  const std::vector<double> cost{ 1.0, 4.0, 1.0, 22.0 };
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(this->costOf({ this->at(1), this->onDiagonal(0.5), this->at(3) }, cost),
    2.0 * half + 8.0 * half, 1e-13);
  // Along their common edge the cheaper one counts, along another edge its own face.
  EXPECT_NEAR(this->costOf({ this->at(0), this->onDiagonal(0.3), this->at(2), this->at(3) }, cost),
    2.0 * std::sqrt(2.0) + 8.0, 1e-13);
}

// The field's value at the start is what the path from there costs.
TEST(PathOfCosts, CostsTheDistanceAtItsStart)
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

// A path along edges of random costs costs what Dijkstra's field says: length times the mean of the
// costs at both ends of each edge.
TEST(PathOfCosts, AlongEdgesIsThatOfDijkstrasField)
{
  const auto mesh = meshOf(jitteredGrid(12, 12, 1.0, 1.0, 0.3, 4));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> magnitude(0.0, 3.0);
  std::vector<double> cost(mesh->numberOfVertices());
  std::generate(cost.begin(), cost.end(), [&] { return std::pow(10.0, magnitude(random)); });
  SolveOptions options;
  options.cost = cost;
  DijkstraSolver solver(mesh);
  const SurfacePoint to = mesh->pointAtVertex(0);
  const std::vector<double> distances =
    geodesic::testing::distances<DijkstraSolver>(mesh, { Seed::atPoint(to) }, options);
  for (Index start = 1; start < mesh->numberOfVertices(); ++start)
  {
    const auto path = shortestPath(solver, mesh->pointAtVertex(start), to, options, AlongEdges);
    ASSERT_TRUE(path);
    double sum = 0.0;
    for (std::size_t i = 1; i < path->size(); ++i)
    {
      const Index a = (*path)[i - 1].carriers()[0];
      const Index b = (*path)[i].carriers()[0];
      sum += 0.5 * (cost[a] + cost[b]) * norm(mesh->position(a) - mesh->position(b));
    }
    const double distance = distances[mesh->pointOfVertex(start)];
    EXPECT_NEAR(sum, distance, 1e-12 * distance) << start;
  }
}
