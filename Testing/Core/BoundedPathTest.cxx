// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths of bounded distances: none is longer than the shortest by more than the tolerance.

#include "PathStyles.h"
#include "RandomDraws.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "path/PathFinder.h"
#include "windows/BoundedSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Expects paths between random points to be found where there are any, each within the tolerance
 * of the shortest and known to be so. @return the longest, in parts of the shortest, less 1 */
double expectWithin(const std::shared_ptr<const TriangleMesh>& mesh, int count, unsigned seed,
  double tolerance, const PathStyle& style)
{
  std::mt19937 random(seed);
  ExactSolver exact(mesh);
  BoundedSolver bounded(mesh);
  SolveOptions options;
  options.tolerance = tolerance;
  double most = 0.0;
  for (int i = 0; i < count; ++i)
  {
    std::vector<SurfacePoint> ends{ randomPoint(*mesh, i / 3, random) };
    if (i % 4 == 0)
    {
      ends.push_back(randomPoint(*mesh, i / 4, random));
    }
    const SurfacePoint start = randomPoint(*mesh, i, random);
    PathFinder shortest(exact, ends, {}, Straight);
    shortest.march({ &start, 1 });
    const auto truth = shortest.pathFrom(start);
    PathFinder finder(bounded, ends, options, style);
    finder.march({ &start, 1 });
    const auto path = finder.pathFrom(start);
    EXPECT_EQ(path.has_value(), truth.has_value()) << i;
    if (path && truth)
    {
      const double least = lengthOf(*mesh, *truth);
      const double length = lengthOf(*mesh, *path);
      EXPECT_TRUE(finder.isProvenShortest()) << i;
      EXPECT_GE(length, least * (1.0 - 1e-9)) << i;
      EXPECT_LE(length, least * (1.0 + tolerance) * (1.0 + 1e-9)) << i;
      most = std::max(most, least > 0.0 ? length / least - 1.0 : 0.0);
    }
  }
  return most;
}

}

// Traced down the same distances, 145 paths of these tests went a longer way round, by up to a
// ninth.
TEST(BoundedPath, IsWithinTheToleranceOfTheShortest)
{
  for (const double tolerance : { 1e-1, 1e-3, 1e-5 })
  {
    for (const Surface& surface : { spot(), icosphere(3), planeGrid(20, 20, 1.0, 1.0) })
    {
      expectWithin(meshOf(surface), 120, 1, tolerance, Straight);
    }
  }
}

// The bound holds for the path as it comes from the windows, too. It makes use of the tolerance:
// what is merged is lost.
TEST(BoundedPath, IsWithinTheToleranceBeforeItIsStraightened)
{
  double most = 0.0;
  for (const Surface& surface : { spot(), icosphere(4), torus(60, 30, 1.0, 0.4) })
  {
    most = std::max(most, expectWithin(meshOf(surface), 120, 2, 1e-2, Traced));
  }
  EXPECT_GT(most, 1e-5);
}

// Non-manifold surfaces, needles, holes and parts.
TEST(BoundedPath, IsWithinTheToleranceOnRandomMeshes)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const MeshKind kind = meshKinds()[seed % meshKinds().size()];
    SCOPED_TRACE(nameOf(kind) + " " + std::to_string(seed));
    const auto mesh = meshOf(randomSurface(kind, seed));
    expectWithin(mesh, 20, seed, 1e-3, Straight);
    expectWithin(mesh, 20, seed, 1e-2, Traced);
  }
}

// Round the ends of a wall the way is known.
TEST(BoundedPath, GoesRoundBarriers)
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
  BoundedSolver solver(mesh);
  const Vector3 from{ 0.1137, 0.8519, 0.0 };
  const Vector3 to{ 0.9271, 0.7713, 0.0 };
  const SurfacePoint end = seedNear(mesh, from).points[0];
  const SurfacePoint start = seedNear(mesh, to).points[0];
  PathFinder finder(solver, { &end, 1 }, options, Traced);
  ASSERT_TRUE(finder.march({ &start, 1 }));
  const auto path = finder.pathFrom(start);
  ASSERT_TRUE(path && finder.isProvenShortest());
  const double low = 0.2;
  const double way =
    std::hypot(0.4 - from.x, low - from.y) + 0.2 + std::hypot(to.x - 0.6, low - to.y);
  EXPECT_GE(lengthOf(*mesh, *path), way * (1.0 - 1e-9));
  EXPECT_LE(lengthOf(*mesh, *path), way * 1.001);
}

// The windows that are kept for paths count for the memory limit, and go when no paths are wanted.
TEST(BoundedPath, KeptWindowsCountForTheMemoryLimit)
{
  const auto mesh = meshOf(icosphere(5));
  BoundedSolver solver(mesh);
  const Seed seed = Seed::atPoint(mesh->pointAtVertex(0));
  const SurfacePoint start = mesh->pointAtVertex(mesh->numberOfVertices() - 1);
  SolveOptions options;
  options.memoryLimit = 2'000'000;
  solver.solve({ &seed, 1 }, options);
  options.pathStarts = { &start, 1 };
  EXPECT_NE(errorOf<std::runtime_error>(
              [&] {
                solver.solve({ &seed, 1 }, options);
              })
              .find("memory limit"),
    std::string::npos);
  options.memoryLimit = 0;
  solver.solve({ &seed, 1 }, options);
  EXPECT_TRUE(solver.pathFrom(start));
}
