// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Fast marching over intrinsic triangles within barriers, from several seeds, with stops: what a
// request may have.

#include "OnIntrinsic.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/IntrinsicMarchingSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

// As pieces on several ranks have copies of each other's triangles.
TEST(Intrinsic, TrianglesThatLieOnOthersCountOnce)
{
  for (const bool hasBarriers : { false, true })
  {
    const Surface surface = stretchedPlane(1000, 30.0);
    Surface doubled = surface;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3)
    {
      const auto& [a, b, c] = surface.triangles[t];
      doubled.triangles.push_back({ b, c, a });
    }
    std::vector<double> found[2];
    for (const bool isDoubled : { false, true })
    {
      const auto mesh = meshOf(isDoubled ? doubled : surface);
      std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
      for (Index t = 0; hasBarriers && t < closed.size(); ++t)
      {
        const std::size_t source = mesh->sourceOfTriangle(t);
        const std::size_t count = surface.triangles.size();
        // One of two is enough, whichever it is.
        const bool isCopy = source >= count;
        const std::size_t original = isCopy ? 3 * (source - count) : source;
        const bool isOfBoth = isDoubled && original % 3 == 0;
        const bool isClosed = original % 21 == 0;
        closed[t] = isClosed && (!isOfBoth || isCopy == (original % 2 == 0)) ? 1 : 0;
      }
      SolveOptions options;
      options.closedTriangles = closed;
      found[isDoubled ? 1 : 0] = intrinsicDistances(mesh, { seedAt(*mesh, 0) }, options);
    }
    EXPECT_LT(largestDifference(found[0], found[1]), 1e-9 * largestOf(found[0]));
  }
}

TEST(Intrinsic, KeepsWithinBarriers)
{
  // A wall of closed triangles, and one of excluded vertices, each with a gap at one end.
  const Surface surface = stretchedPlane(3000, 20.0);
  const auto mesh = meshOf(surface);
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
  for (Index t = 0; t < closed.size(); ++t)
  {
    const Vector3 middle = mesh->positionOf({ t, { 0.4, 0.3, 0.3 } });
    closed[t] = std::abs(middle.x - 8.0) < 0.6 && middle.y > 0.2 ? 1 : 0;
  }
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices());
  for (Index v = 0; v < excluded.size(); ++v)
  {
    const Vector3& position = mesh->position(v);
    excluded[v] = std::abs(position.x - 14.0) < 0.6 && position.y < 0.8 ? 1 : 0;
  }
  SolveOptions options;
  options.closedTriangles = closed;
  options.excluded = excluded;
  const Seed seed = seedNear(mesh, { 1.0, 0.5, 0.0 });
  const std::vector<double> exact = distances<ExactSolver>(mesh, { seed }, options);
  const std::vector<double> found = intrinsicDistances(mesh, { seed }, options);
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(found[i]), std::isfinite(exact[i]));
    if (std::isfinite(exact[i]))
    {
      ASSERT_NEAR(found[i], exact[i], 0.02 * exact[i] + 1e-9);
    }
  }
  // Other barriers, and then the first ones again, with one solver.
  IntrinsicMarchingSolver solver(mesh);
  const std::vector seeds{ seed };
  solver.solve(seeds, intrinsicOptions(options));
  const double withoutBarriers =
    solver.solve(seeds, intrinsicOptions()).distance(mesh->vertexOfPoint(2));
  EXPECT_NEAR(withoutBarriers, norm(surface.points[2] - Vector3{ 1.0, 0.5, 0.0 }), 1e-6);
  // On the faces, and then again with what that run had.
  solver.solve(seeds, options);
  SolveOptions kept = intrinsicOptions(options);
  kept.keepsSurface = true;
  const DistanceField& again = solver.solve(seeds, kept);
  for (Index i = 0; i < mesh->numberOfPoints(); ++i)
  {
    ASSERT_EQ(again.distance(mesh->vertexOfPoint(i)), found[i]);
  }
}

TEST(Intrinsic, NearestSeedsAreThoseOfTheLeastField)
{
  const Surface surface = flattenedSphere(4, 20.0);
  const auto mesh = meshOf(surface);
  std::vector<Seed> seeds;
  std::vector<std::vector<double>> single;
  for (const Index point : { 3u, 700u, 1500u, 2200u })
  {
    seeds.push_back(seedAt(*mesh, point));
    single.push_back(intrinsicDistances(mesh, { seeds.back() }));
  }
  IntrinsicMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(seeds, intrinsicOptions());
  const double tolerance = 1e-4 * field.largestDistance();
  for (Index i = 0; i < mesh->numberOfPoints(); ++i)
  {
    const Index vertex = mesh->vertexOfPoint(i);
    double least = DistanceField::Unreached;
    for (const auto& distances : single)
    {
      least = std::min(least, distances[i]);
    }
    ASSERT_NEAR(field.distance(vertex), least, tolerance);
    ASSERT_NEAR(single[field.nearestSeed(vertex)][i], least, tolerance);
  }
}

TEST(Intrinsic, StopsAsOnFaces)
{
  const Surface surface = flattenedSphere(4, 50.0);
  const auto mesh = meshOf(surface);
  const std::vector<double> whole = intrinsicDistances(mesh, { seedAt(*mesh, 3) });
  SolveOptions options;
  options.maximumDistance = 0.7;
  const std::vector<double> near = intrinsicDistances(mesh, { seedAt(*mesh, 3) }, options);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(near[i]), whole[i] <= 0.7);
    ASSERT_TRUE(whole[i] > 0.7 || std::abs(near[i] - whole[i]) < 1e-9);
  }
  const Index target = mesh->vertexOfPoint(1200);
  const std::vector<Triangle> targets{ { target, target, target } };
  options = intrinsicOptions();
  options.targets = targets;
  IntrinsicMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(std::vector{ seedAt(*mesh, 3) }, options);
  EXPECT_EQ(field.stopReason(), StopReason::Targets);
  EXPECT_NEAR(field.distance(target), whole[1200], 1e-9);
  EXPECT_LE(field.largestDistance(), whole[1200] * (1.0 + 1e-12));
}

TEST(Intrinsic, EndsWhereverItIsCancelled)
{
  const Surface surface = flattenedSphere(4, 50.0);
  const auto mesh = meshOf(surface);
  const std::vector seeds{ seedAt(*mesh, 3) };
  IntrinsicMarchingSolver whole(mesh);
  std::size_t calls = 0;
  SolveOptions options = intrinsicOptions();
  options.onProgress = [&](std::size_t)
  {
    ++calls;
    return true;
  };
  const double largest = whole.solve(seeds, options).largestDistance();
  for (std::size_t end = 0; end < calls; end += 1 + calls / 40)
  {
    IntrinsicMarchingSolver solver(mesh);
    std::size_t count = 0;
    options.onProgress = [&](std::size_t) { return count++ < end; };
    EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
    EXPECT_EQ(solver.solve(seeds, intrinsicOptions()).largestDistance(), largest);
  }
}

TEST(Intrinsic, IsTheSameOnThreads)
{
  const Surface surface = flattenedSphere(6, 20.0);
  const auto mesh = meshOf(surface);
  const std::vector<double> one = intrinsicDistances(mesh, { seedAt(*mesh, 3) });
  SolveOptions options;
  options.threads = 3;
  options.verticesOfThread = 1;
  const std::vector<double> three = intrinsicDistances(mesh, { seedAt(*mesh, 3) }, options);
  EXPECT_LT(largestDifference(one, three), 1e-9 * largestOf(one));
}

TEST(Intrinsic, OtherRequestsAreOnFacesOrAnError)
{
  const auto mesh = meshOf(stretchedPlane(300, 30.0));
  const std::vector seeds{ seedAt(*mesh, 3) };
  const std::vector<double> cost(mesh->numberOfVertices(), 2.0);
  SolveOptions options;
  options.cost = cost;
  EXPECT_EQ(distances<IntrinsicMarchingSolver>(mesh, seeds, options),
    distances<FastMarchingSolver>(mesh, seeds, options));
  EXPECT_FALSE(IntrinsicMarchingSolver::canMarchIntrinsically(seeds, options));
  IntrinsicMarchingSolver solver(mesh);
  EXPECT_FALSE(solver.solve(seeds, options).isIntrinsic());
  EXPECT_TRUE(solver.solve(seeds, intrinsicOptions()).isIntrinsic());
  EXPECT_FALSE(solver.solve(seeds).isIntrinsic());
  EXPECT_NE(errorOf([&] { intrinsicDistances(mesh, seeds, options); }), "");
}

TEST(Intrinsic, SeedsOfVerticesAreThere)
{
  for (const unsigned number : { 5u, 7u, 8u, 23u })
  {
    for (const MeshKind kind : { MeshKind::NonManifold, MeshKind::Graded, MeshKind::Careless })
    {
      Surface surface = randomSurface(kind, number);
      for (Vector3& point : surface.points)
      {
        point.x *= 1000.0;
      }
      const auto mesh = meshOf(surface);
      IntrinsicMarchingSolver solver(mesh);
      for (Index vertex = 0; vertex < mesh->numberOfVertices(); vertex += 29)
      {
        const std::vector seeds{ Seed::atPoint(mesh->pointAtVertex(vertex)) };
        ASSERT_EQ(solver.solve(seeds, intrinsicOptions()).distance(vertex), 0.0);
      }
    }
  }
}

}
