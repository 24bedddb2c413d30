// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What takes long with very many seeds before, between and after the marches reports progress, and
// may be cancelled.
#include "Solving.h"
#include "Surfaces.h"
#include "march/FastMarchingSolver.h"
#include "mesh/TriangleMesh.h"
#include "solve/DistanceField.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace geodesic::testing
{
namespace
{

/** Edges from random vertices, each a seed. */
std::vector<Seed> randomEdgesOf(const TriangleMesh& mesh, int count)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<Index> any(0, mesh.numberOfVertices() - 1);
  std::vector<Seed> seeds;
  for (int i = 0; i < count; ++i)
  {
    const Index vertex = any(random);
    seeds.push_back(Seed::alongCurve(
      { mesh.pointAtVertex(vertex), mesh.pointAtVertex(mesh.ring(vertex)[0].neighbour()) }));
  }
  return seeds;
}

}

TEST(SeedProgress, ARunMayBeCancelledWhileItsFrontsAreMade)
{
  const auto mesh = meshOf(hillyGrid(79, 79));
  FastMarchingSolver solver(mesh);
  std::vector<std::size_t> reports;
  SolveOptions options;
  options.onProgress = [&](std::size_t count)
  {
    reports.push_back(count);
    return false;
  };
  const DistanceField& field = solver.solve(randomEdgesOf(*mesh, 5000), options);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_LT(reports[0], options.progressInterval);
  EXPECT_EQ(field.stopReason(), StopReason::Cancelled);
  EXPECT_TRUE(field.reached().empty());
}

// What a solver keeps of its last run is not that of one that was cancelled before it marched.
TEST(SeedProgress, NothingIsKeptOfRunsBeforeACancelledOne)
{
  const auto mesh = meshOf(hillyGrid(79, 79));
  const std::vector<Seed> many = randomEdgesOf(*mesh, 5000);
  const std::vector<Seed> one{ seedAt(*mesh, 40) };
  const std::vector<double> cheap(mesh->numberOfVertices(), 1.5);
  const std::vector<double> dear(mesh->numberOfVertices(), 6.0);
  SolveOptions options;
  const auto solve = [&](DistanceSolver& solver, const std::vector<Seed>& seeds, bool isCancelled)
  {
    options.onProgress = [=](std::size_t) { return !isCancelled; };
    return solver.solve(seeds, options).largestDistance();
  };
  FastMarchingSolver fast(mesh);
  options.cost = cheap;
  solve(fast, one, false);
  options.cost = dear;
  solve(fast, many, true);
  options.keepsSurface = true;
  const double kept = solve(fast, one, false);
  FastMarchingSolver another(mesh);
  EXPECT_EQ(kept, solve(another, one, false));

  options = {};
  const SurfacePoint start{ 2000, { 0.2, 0.3, 0.5 } };
  options.pathStarts = { &start, 1 };
  ExactSolver exact(mesh);
  solve(exact, one, false);
  EXPECT_TRUE(exact.pathFrom(start));
  solve(exact, many, true);
  EXPECT_FALSE(exact.pathFrom(start));
}

TEST(SeedProgress, AnyReportMayCancel)
{
  const auto mesh = meshOf(hillyGrid(79, 79));
  const std::vector<Seed> seeds = randomEdgesOf(*mesh, 5000);
  const auto whole = distances<FastMarchingSolver>(mesh, seeds);
  FastMarchingSolver solver(mesh);
  std::size_t last = 0;
  bool isCancelled = true;
  while (isCancelled)
  {
    ++last;
    std::size_t reports = 0;
    std::size_t counted = 0;
    SolveOptions options;
    options.progressInterval = 2000;
    options.onProgress = [&](std::size_t count)
    {
      EXPECT_GE(count, counted);
      counted = count;
      return ++reports < last;
    };
    isCancelled = solver.solve(seeds, options).stopReason() == StopReason::Cancelled;
    ASSERT_EQ(reports, isCancelled ? last : last - 1);
  }
  EXPECT_GT(last, 20u);
  // Nothing is left of a cancelled run.
  const DistanceField& again = solver.solve(seeds);
  for (Index i = 0; i < whole.size(); ++i)
  {
    ASSERT_EQ(again.distance(mesh->vertexOfPoint(i)), whole[i]);
  }
}

}
