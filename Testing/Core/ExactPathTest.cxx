// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths that the exact solver finds along with its distances: they are as long as these, from
// vertices, edges and faces, and so the shortest of all.

#include "ExactDistances.h"
#include "NastyCases.h"
#include "PathStyles.h"
#include "RandomDraws.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** What is left of paths that are not as long as the exact distance between their ends. */
struct Found
{
  int paths = 0;
  int longer = 0;
  double most = 0.0;
};

/** Paths between random points; the distance from the one as seed to the other, and back. */
Found findPaths(const std::shared_ptr<const TriangleMesh>& mesh, int count, unsigned seed,
  const SolveOptions& options = {})
{
  std::mt19937 random(seed);
  ExactSolver solver(mesh);
  Found found;
  for (int i = 0; i < count; ++i)
  {
    const SurfacePoint end = randomPoint(*mesh, i / 3, random);
    const SurfacePoint start = randomPoint(*mesh, i, random);
    PathFinder there(solver, { &end, 1 }, options, Straight);
    there.march({ &start, 1 });
    const auto path = there.pathFrom(start);
    const bool isProven = there.isProvenShortest();
    PathFinder back(solver, { &start, 1 }, options, Straight);
    back.march({ &end, 1 });
    const auto other = back.pathFrom(end);
    EXPECT_EQ(path.has_value(), other.has_value());
    if (path && other)
    {
      const double length = lengthOf(*mesh, *path);
      const double excess = std::abs(length - lengthOf(*mesh, *other)) / std::max(length, 1e-300);
      ++found.paths;
      found.longer += isProven && back.isProvenShortest() && excess < 1e-9 ? 0 : 1;
      found.most = std::max(found.most, excess);
    }
  }
  return found;
}

}

TEST(ExactPath, IsAsLongAsTheExactDistance)
{
  const auto mesh = meshOf(spot());
  const std::vector<double> exact = exactDistances(spot(), { 100 });
  ExactSolver solver(mesh);
  const SurfacePoint end = mesh->pointAtVertex(mesh->vertexOfPoint(100));
  std::vector<SurfacePoint> starts;
  for (Index point = 0; point < exact.size(); point += 7)
  {
    starts.push_back(mesh->pointAtVertex(mesh->vertexOfPoint(point)));
  }
  PathFinder finder(solver, { &end, 1 }, {}, Straight);
  ASSERT_TRUE(finder.march(starts));
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    const auto path = finder.pathFrom(starts[i]);
    ASSERT_TRUE(path);
    EXPECT_TRUE(finder.isProvenShortest()) << i;
    ASSERT_NEAR(lengthOf(*mesh, *path), exact[7 * i], 1e-9 * exact[7 * i]) << i;
  }
}

// A path of fast marching can go the longer way round; its length tells nothing about that.
TEST(ExactPath, IsNotLongerThanThatOfFastMarching)
{
  const auto mesh = meshOf(spot());
  ExactSolver exact(mesh);
  FastMarchingSolver fast(mesh);
  std::mt19937 random(3);
  int shorter = 0;
  for (int i = 0; i < 60; ++i)
  {
    const SurfacePoint from = randomPoint(*mesh, i, random);
    const SurfacePoint to = randomPoint(*mesh, i / 3, random);
    const double shortest = lengthOf(*mesh, shortestPath(exact, from, to, {}, Straight).value());
    const double other = lengthOf(*mesh, shortestPath(fast, from, to, {}, Straight).value());
    EXPECT_LE(shortest, other * (1.0 + 1e-9)) << i;
    shorter += shortest < other * (1.0 - 1e-6) ? 1 : 0;
  }
  EXPECT_GT(shorter, 0);
}

TEST(ExactPath, IsTheShortestBetweenAnyPoints)
{
  for (const Surface& surface : { spot(), icosphere(3), planeGrid(20, 20, 1.0, 1.0) })
  {
    const Found found = findPaths(meshOf(surface), 120, 1);
    EXPECT_EQ(found.paths, 120);
    EXPECT_EQ(found.longer, 0) << "of " << found.paths << ", worst " << found.most;
  }
}

// Non-manifold surfaces, needles, holes and parts.
TEST(ExactPath, IsTheShortestOnRandomMeshes)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const MeshKind kind = meshKinds()[seed % meshKinds().size()];
    const Found found = findPaths(meshOf(randomSurface(kind, seed)), 20, seed);
    EXPECT_EQ(found.longer, 0) << nameOf(kind) << " " << seed << ": of " << found.paths
                               << ", worst " << found.most;
  }
}

TEST(ExactPath, GoesRoundBarriers)
{
  const auto mesh = meshOf(planeGrid(30, 30, 1.0, 1.0));
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
  for (Index t = 0; t < closed.size(); ++t)
  {
    const Vector3 middle = mesh->positionOf({ t, { 0.3, 0.3, 0.4 } });
    closed[t] = middle.x > 0.4 && middle.x < 0.6 && middle.y > 0.2;
  }
  SolveOptions options;
  options.closedTriangles = closed;
  ExactSolver solver(mesh);
  const auto at = [&](double x, double y) { return seedNear(mesh, { x, y, 0.0 }).points[0]; };
  const Vector3 from{ 0.1137, 0.8519, 0.0 };
  const Vector3 to{ 0.9271, 0.7713, 0.0 };
  PathFinder finder(solver, std::vector{ at(from.x, from.y) }, options, Straight);
  const SurfacePoint start = at(to.x, to.y);
  ASSERT_TRUE(finder.march({ &start, 1 }));
  const auto path = finder.pathFrom(start);
  ASSERT_TRUE(path && finder.isProvenShortest());
  const double low = 0.2;
  const double way =
    std::hypot(0.4 - from.x, low - from.y) + 0.2 + std::hypot(to.x - 0.6, low - to.y);
  EXPECT_NEAR(lengthOf(*mesh, *path), way, 1e-9);
}

// Of two triangles with the same corners one is closed, and so the other is: from neither end of a
// path does anything pass it.
TEST(ExactPath, ATriangleIsClosedWhereOneWithTheSameCornersIs)
{
  const Surface surface{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { -1, 1, 0 }, { 0.5, -1, 0 } },
    { { 0, 1, 2 }, { 0, 3, 2 }, { 1, 0, 4 }, { 0, 2, 1 } } };
  const auto mesh = meshOf(surface);
  const auto vertex = [&](Index point) { return mesh->vertexOfPoint(point); };
  const std::array sameCorners{ vertex(0), vertex(1), vertex(2) };
  const std::vector<Index> same = mesh->trianglesWith(sameCorners);
  ASSERT_EQ(same.size(), 2);
  const std::array side{ vertex(0), vertex(1), vertex(4) };
  SurfacePoint middle{ mesh->trianglesWith(side).at(0), {} };
  for (int i = 0; i < 3; ++i)
  {
    middle.weights[i] = mesh->triangle(middle.triangle)[i] == vertex(4) ? 0.0 : 0.5;
  }
  const SurfacePoint apex = mesh->pointAtVertex(vertex(2));
  const double way = 0.5 + std::hypot(0.5, 1.0);
  for (const Index one : same)
  {
    std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
    closed[one] = 1;
    SolveOptions options;
    options.closedTriangles = closed;
    ExactSolver solver(mesh);
    for (const auto& [from, to] : { std::pair(middle, apex), std::pair(apex, middle) })
    {
      PathFinder finder(solver, { &to, 1 }, options, Straight);
      ASSERT_TRUE(finder.march({ &from, 1 }));
      const auto path = finder.pathFrom(from);
      ASSERT_TRUE(path && finder.isProvenShortest());
      EXPECT_NEAR(lengthOf(*mesh, *path), way, 1e-12);
    }
    const auto field = distances<FastMarchingSolver>(mesh, { Seed::atPoint(middle) }, options);
    EXPECT_NEAR(field[2], way, 1e-12);
    const Seed inside = Seed::atPoint({ same[0] + same[1] - one, { 0.3, 0.3, 0.4 } });
    EXPECT_NE(errorOf(
                [&] {
                  solver.solve({ &inside, 1 }, options);
                })
                .find("barrier"),
      std::string::npos);
  }
}

// A strip whose straight border has vertices in a row: whether the line along it leaves a triangle
// by that border, beyond which nothing is, or by the side that comes from there, is rounding.
TEST(ExactPath, FollowsVerticesInARow)
{
  const NastyCase strip = nastyCase(135583);
  const TriangleMesh& mesh = *strip.mesh;
  ExactSolver solver(strip.mesh);
  ExactSolver ofPath(strip.mesh);
  const SolveOptions options = strip.options();
  const DistanceField& field = solver.solve(strip.seeds, options);
  int compared = 0;
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    if (field.isReached(vertex))
    {
      const auto path = shortestPath(ofPath, mesh.pointAtVertex(vertex), strip.seeds[0].points[0],
        options, { PathOrder::Edges, true });
      ASSERT_TRUE(path);
      EXPECT_NEAR(lengthOf(mesh, *path), field.distance(vertex), 1e-9) << "from " << vertex;
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}
