// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Stops, exclusion, progress and requests that have no answer, for both solvers.

#include "ExactDistances.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

Triangle atVertex(Index vertex)
{
  return { vertex, vertex, vertex };
}

}

template <class Solver>
class Request : public ::testing::Test
{
protected:
  std::vector<double> solve(const std::vector<Seed>& seeds, const SolveOptions& options)
  {
    return distances<Solver>(this->mesh, seeds, options);
  }

  /** What is not farther than the limit is as in the whole field, the rest unreached. */
  void expectCutAt(const std::vector<double>& d, const std::vector<double>& whole, double limit)
  {
    for (std::size_t i = 0; i < d.size(); ++i)
    {
      if (whole[i] <= limit)
      {
        EXPECT_NEAR(d[i], whole[i], 1e-10);
      }
      else
      {
        EXPECT_FALSE(std::isfinite(d[i]));
      }
    }
  }

  std::string messageOf(const std::vector<Seed>& seeds, const SolveOptions& options = {})
  {
    try
    {
      this->solve(seeds, options);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  }

  const Surface surface = spot();
  const std::shared_ptr<const TriangleMesh> mesh = meshOf(surface);
  const std::vector<Seed> oneSeed{ seedAt(*mesh, 10) };
  const std::vector<Seed> seeds{ seedAt(*mesh, 10), seedAt(*mesh, 1500), seedAt(*mesh, 2900) };
};

using Solvers = ::testing::Types<FastMarchingSolver, DijkstraSolver, ExactSolver>;
TYPED_TEST_SUITE(Request, Solvers);

TYPED_TEST(Request, MaximumDistanceCutsTheField)
{
  for (const auto& seeds : { this->oneSeed, this->seeds })
  {
    const auto whole = this->solve(seeds, {});
    for (double limit : { 0.0, 0.01, 0.1, 0.5 })
    {
      SolveOptions options;
      options.maximumDistance = limit;
      this->expectCutAt(this->solve(seeds, options), whole, limit);
    }
  }
}

TYPED_TEST(Request, TargetsEndTheField)
{
  const std::vector<Triangle> targets{ atVertex(this->mesh->vertexOfPoint(200)),
    atVertex(this->mesh->vertexOfPoint(2000)), atVertex(this->mesh->vertexOfPoint(1200)) };
  for (const auto& seeds : { this->oneSeed, this->seeds })
  {
    const auto whole = this->solve(seeds, {});
    SolveOptions options;
    options.targets = targets;
    options.targetMode = TargetMode::Any;
    const double nearest = std::min({ whole[200], whole[2000], whole[1200] });
    this->expectCutAt(this->solve(seeds, options), whole, nearest);
    options.targetMode = TargetMode::All;
    const double farthest = std::max({ whole[200], whole[2000], whole[1200] });
    this->expectCutAt(this->solve(seeds, options), whole, farthest);
    options.maximumDistance = 0.5 * farthest;
    this->expectCutAt(this->solve(seeds, options), whole, 0.5 * farthest);
  }
}

TYPED_TEST(Request, StopReasonSaysWhatHappened)
{
  TypeParam solver(this->mesh);
  EXPECT_EQ(solver.solve(this->oneSeed).stopReason(), StopReason::Exhausted);
  SolveOptions options;
  options.maximumDistance = 0.2;
  EXPECT_EQ(solver.solve(this->oneSeed, options).stopReason(), StopReason::MaximumDistance);
  const Triangle beside = atVertex(this->mesh->ring(this->mesh->vertexOfPoint(10))[0].neighbour());
  options.targets = { &beside, 1 };
  EXPECT_EQ(solver.solve(this->oneSeed, options).stopReason(), StopReason::Targets);
}

// The second run finds the workspace of the first: it must give what a new solver gives.
TYPED_TEST(Request, ASolverCanBeUsedAgain)
{
  TypeParam solver(this->mesh);
  SolveOptions bounded;
  bounded.maximumDistance = 0.1;
  solver.solve(this->seeds);
  solver.solve(this->oneSeed, bounded);
  solver.solve(this->seeds, bounded);
  const DistanceField& again = solver.solve(this->oneSeed);
  const auto fresh = this->solve(this->oneSeed, {});
  for (Index i = 0; i < fresh.size(); ++i)
  {
    EXPECT_EQ(again.distance(this->mesh->vertexOfPoint(i)), fresh[i]);
  }
  EXPECT_EQ(again.reached().size(), fresh.size());
}

TYPED_TEST(Request, AClosedLoopOfExcludedVerticesConfinesTheFront)
{
  const Surface plane = planeGrid(20, 20, 20.0, 20.0);
  const auto mesh = meshOf(plane);
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices(), 0);
  const auto onLoop = [](const Vector3& p)
  { return std::max(std::abs(p.x - 10.0), std::abs(p.y - 10.0)) == 5.0; };
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    excluded[mesh->vertexOfPoint(i)] = onLoop(plane.points[i]);
  }
  SolveOptions options;
  options.excluded = excluded;
  const auto d = distances<TypeParam>(mesh, { seedAt(*mesh, 220) }, options);
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const Vector3& p = plane.points[i];
    const bool isInside = std::max(std::abs(p.x - 10.0), std::abs(p.y - 10.0)) < 5.0;
    EXPECT_EQ(std::isfinite(d[i]), isInside);
  }
}

TYPED_TEST(Request, ProgressIsReportedAndCancels)
{
  TypeParam solver(this->mesh);
  SolveOptions options;
  options.progressInterval = 50;
  std::vector<std::size_t> counts;
  options.onProgress = [&](std::size_t count)
  {
    counts.push_back(count);
    return true;
  };
  EXPECT_EQ(solver.solve(this->oneSeed, options).stopReason(), StopReason::Exhausted);
  ASSERT_GT(counts.size(), 50u);
  EXPECT_EQ(counts.front(), 50u);
  EXPECT_EQ(counts[1], 100u);
  options.onProgress = [](std::size_t count) { return count < 200; };
  EXPECT_EQ(solver.solve(this->oneSeed, options).stopReason(), StopReason::Cancelled);
  const auto whole = this->solve(this->oneSeed, {});
  const DistanceField& after = solver.solve(this->oneSeed);
  EXPECT_EQ(after.distance(this->mesh->vertexOfPoint(99)), whole[99]);
}

TYPED_TEST(Request, NoSeedIsAnError)
{
  EXPECT_NE(this->messageOf({}).find("no seed"), std::string::npos);
}

TYPED_TEST(Request, ASeedOffTheMeshIsNamed)
{
  EXPECT_NE(
    this->messageOf({ this->oneSeed[0], Seed::atPoint({ 999999, { 1, 0, 0 } }) }).find("Seed 1"),
    std::string::npos);
  EXPECT_NE(
    this->messageOf({ Seed::atPoint({ 0, { 0.5, 0.6, 0.0 } }) }).find("Seed 0"), std::string::npos);
  EXPECT_NE(
    this->messageOf({ Seed::atPoint({ 0, { 1, 0, 0 } }, -1.0) }).find("Seed 0"), std::string::npos);
}

TYPED_TEST(Request, AnExcludedSeedIsNamed)
{
  std::vector<std::uint8_t> excluded(this->mesh->numberOfVertices(), 0);
  excluded[this->mesh->vertexOfPoint(10)] = 1;
  SolveOptions options;
  options.excluded = excluded;
  EXPECT_NE(this->messageOf(this->oneSeed, options).find("point 10"), std::string::npos);
}

TYPED_TEST(Request, OptionsThatDoNotFitAreErrors)
{
  SolveOptions options;
  options.maximumDistance = -1.0;
  EXPECT_NE(this->messageOf(this->oneSeed, options), "");
  options.maximumDistance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(this->messageOf(this->oneSeed, options), "");
  options = {};
  const std::vector<std::uint8_t> shortMask(5, 0);
  options.excluded = shortMask;
  EXPECT_NE(this->messageOf(this->oneSeed, options), "");
  options = {};
  const std::vector<Triangle> targets{ atVertex(999999) };
  options.targets = targets;
  EXPECT_NE(this->messageOf(this->oneSeed, options), "");
}
