// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One march on several threads gives the field of one thread. Without vector extensions there are
// no marches on threads (see Platform.h).

#include "base/Platform.h"

#if GEODESIC_HAS_LANES

#include "RandomMeshes.h"
#include "Solving.h"
#include "Surfaces.h"
#include "base/CallsTogether.h"
#include "march/FastMarchingSolver.h"
#include "threads/SharedMarch.h"
#include "threads/ThreadFront.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

SolveOptions onThreads(std::size_t threads, SolveOptions options = {})
{
  options.threads = threads;
  options.verticesOfThread = 1;
  return options;
}

/** Largest difference between two fields, in parts of the largest distance. */
double difference(const DistanceField& a, const DistanceField& b)
{
  double most = 0.0;
  for (Index v = 0; v < a.distances().size(); ++v)
  {
    if (a.isReached(v) != b.isReached(v))
    {
      return DistanceField::Unreached;
    }
    most = a.isReached(v) ? std::max(most, std::abs(a.distance(v) - b.distance(v))) : most;
  }
  return most / std::max(a.largestDistance(), 1e-300);
}

void expectSameField(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options = {}, bool isShared = true)
{
  FastMarchingSolver one(mesh);
  FastMarchingSolver several(mesh);
  const DistanceField& expected = one.solve(seeds, options);
  for (const std::size_t threads : { 2, 3, 5 })
  {
    // A second run has what the first one has left.
    for (int run = 0; run < 2; ++run)
    {
      const DistanceField& field = several.solve(seeds, onThreads(threads, options));
      EXPECT_LE(difference(expected, field), 1e-9) << threads << " threads, run " << run;
      EXPECT_EQ(field.reached().size(), expected.reached().size());
      EXPECT_EQ(field.stopReason(), expected.stopReason());
      EXPECT_EQ(several.threadWork().rounds > 1, isShared);
      for (Index v = 0; v < mesh->numberOfVertices(); ++v)
      {
        ASSERT_EQ(field.nearestSeed(v), expected.nearestSeed(v)) << "vertex " << v;
      }
    }
  }
}

/** Expects each report to be of more updates than the last one, which it notes. */
std::function<bool(std::size_t)> expectMoreThan(std::size_t& last)
{
  return [&](std::size_t taken)
  {
    EXPECT_GT(taken, last);
    last = taken;
    return true;
  };
}

/** A front that has a vertex left for ever, and counts what it is asked to do. */
class EndlessFront final : public ThreadFront
{
public:
  void advanceWhile(double, const std::function<bool()>&) override { ++this->Advances; }
  void visitAtBorder(const std::function<void(const LabelAtVertex&, double)>&) override {}
  double next() const override { return 1.0; }
  std::size_t waiting() const override { return 1; }
  void visitWaiting(const std::function<void(Index)>&) const override {}
  std::size_t reached() const override { return 1; }
  std::size_t numberOfValues() const override { return 1; }
  std::size_t numberOfUpdates() const override { return 0; }
  double meanLongestEdge() const override { return 1.0; }
  void lower(const LabelAtVertex&, double, bool) override {}
  void updateRound(const LabelAtVertex&) override {}
  void take(Index) override {}
  void giveUp(const std::function<void(Index, Index)>&) override {}

  std::size_t numberOfAdvances() const { return this->Advances; }

private:
  std::size_t Advances = 0;
};

std::vector<double> randomCosts(Index count, double sigma, unsigned number)
{
  std::mt19937 random(number);
  std::normal_distribution<double> normal(0.0, sigma);
  std::vector<double> costs(count);
  std::generate(costs.begin(), costs.end(), [&] { return std::exp(normal(random)); });
  return costs;
}

}

TEST(MarchOnThreads, HasTheFieldOfOneThread)
{
  for (const auto& mesh : { meshOf(icosphere(5)), meshOf(torus(120, 60, 3.0, 1.0)),
         meshOf(jitteredGrid(90, 90, 1.0, 1.0, 0.3, 1)) })
  {
    for (const Index point : { 0u, 700u, 2500u })
    {
      expectSameField(mesh, { seedAt(*mesh, point) });
    }
  }
}

TEST(MarchOnThreads, HasTheFieldOfOneThreadFromRegionsAndSeveralSeeds)
{
  const auto mesh = meshOf(jitteredGrid(90, 90, 1.0, 1.0, 0.3, 2));
  Seed shifted = seedAt(*mesh, 4000);
  shifted.value = 0.3;
  expectSameField(mesh, { shifted });
  expectSameField(mesh, { seedAt(*mesh, 5), shifted });
  expectSameField(mesh, { seedAt(*mesh, 5), shifted, seedAt(*mesh, 4010), seedAt(*mesh, 7000) });
  // With dense labels there is a first march of all together.
  std::vector<Seed> many;
  for (Index point = 3; point < 8000; point += 20)
  {
    many.push_back(seedAt(*mesh, point));
  }
  expectSameField(mesh, many);
  std::vector<Index> region;
  for (Index point = 2000; point < 6000; ++point)
  {
    region.push_back(mesh->vertexOfPoint(point));
  }
  expectSameField(mesh, { Seed::onRegion(region) });
}

TEST(MarchOnThreads, MarchesWithVeryManyValuesAtAVertexStayOnOneThread)
{
  const auto mesh = meshOf(jitteredGrid(90, 90, 1.0, 1.0, 0.3, 2));
  const std::vector<double> costs = randomCosts(mesh->numberOfVertices(), 0.5, 3);
  SolveOptions options;
  options.cost = costs;
  expectSameField(mesh, { seedAt(*mesh, 5), seedAt(*mesh, 4000), seedAt(*mesh, 7000) }, options);
  // Under a cost each of them has a value at each vertex beside them.
  const std::vector<Seed> together(60, seedAt(*mesh, 4000));
  expectSameField(mesh, together, options, false);
}

TEST(MarchOnThreads, HeedsCostsAndBarriers)
{
  const auto mesh = meshOf(torus(120, 60, 3.0, 1.0));
  const std::vector<double> costs = randomCosts(mesh->numberOfVertices(), 0.5, 3);
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices());
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
  std::mt19937 random(5);
  std::generate(excluded.begin(), excluded.end(), [&] { return random() % 10 == 0 ? 1 : 0; });
  std::generate(closed.begin(), closed.end(), [&] { return random() % 10 == 0 ? 1 : 0; });
  excluded[mesh->vertexOfPoint(17)] = 0;
  SolveOptions options;
  options.cost = costs;
  expectSameField(mesh, { seedAt(*mesh, 17) }, options);
  // So far apart that vertices are taken strictly by their values: on one thread.
  const std::vector<double> spread = randomCosts(mesh->numberOfVertices(), 4.0, 4);
  options.cost = spread;
  expectSameField(mesh, { seedAt(*mesh, 17) }, options, false);
  options.cost = costs;
  options.excluded = excluded;
  options.closedTriangles = closed;
  expectSameField(mesh, { seedAt(*mesh, 17) }, options);
}

TEST(MarchOnThreads, HasTheFieldOfOneThreadInRandomCases)
{
  for (unsigned number = 0; number < 200; ++number)
  {
    const RandomCase random = randomCase(number, { .mostSeeds = number % 2 == 0 ? 1u : 5u });
    FastMarchingSolver one(random.mesh);
    FastMarchingSolver several(random.mesh);
    const DistanceField& expected = one.solve(random.seeds, random.options());
    const DistanceField& field =
      several.solve(random.seeds, onThreads(2 + number % 4, random.options()));
    // Where it settles only roughly it depends on the order.
    if (expected.raisedGain() == 0.0 && field.raisedGain() == 0.0)
    {
      EXPECT_LE(difference(expected, field), 1e-9) << random.description();
    }
  }
}

TEST(MarchOnThreads, ThreadsTakeShares)
{
  const auto mesh = meshOf(icosphere(6));
  FastMarchingSolver solver(mesh);
  for (const Index point : { 5u, 20000u, 40000u })
  {
    solver.solve(std::vector<Seed>{ seedAt(*mesh, point) }, onThreads(3));
    const ThreadWork& work = solver.threadWork();
    EXPECT_LT(work.updates, 2.0 * mesh->numberOfVertices());
    EXPECT_LT(work.longestChain, 0.6 * work.updates);
    EXPECT_GT(work.sent, 0);
  }
}

// What crosses a border is taken within a round. When it waited for the next one there were 80
// rounds. Beside busy programs there are up to 60.
TEST(MarchOnThreads, LettersSaveRounds)
{
  if (std::thread::hardware_concurrency() < 2)
  {
    GTEST_SKIP() << "One processor: threads take turns.";
  }
  const auto mesh = meshOf(icosphere(6));
  FastMarchingSolver solver(mesh);
  auto least = std::numeric_limits<std::size_t>::max();
  for (int run = 0; run < 10; ++run)
  {
    solver.solve(std::vector<Seed>{ seedAt(*mesh, 5) }, onThreads(2));
    least = std::min<std::size_t>(least, solver.threadWork().rounds);
  }
  EXPECT_GT(least, 0u);
  EXPECT_LT(least, 50u);
}

TEST(MarchOnThreads, MayBeMoreThanThereAreProcessors)
{
  const auto mesh = meshOf(icosphere(4));
  FastMarchingSolver one(mesh);
  FastMarchingSolver several(mesh);
  const std::vector<Seed> seeds{ seedAt(*mesh, 5) };
  EXPECT_LE(difference(one.solve(seeds), several.solve(seeds, onThreads(100))), 1e-9);
}

TEST(MarchOnThreads, LeavesOtherPartsUnreached)
{
  const auto mesh = meshOf(joined(icosphere(4), torus(120, 60, 3.0, 1.0)));
  expectSameField(mesh, { seedAt(*mesh, 0) });
}

TEST(MarchOnThreads, EndsWhereAllPointsAreOnePlace)
{
  Surface surface = icosphere(3);
  std::fill(surface.points.begin(), surface.points.end(), Vector3{ 1.0, 2.0, 3.0 });
  expectSameField(meshOf(surface), { seedAt(*meshOf(surface), 0) }, {}, false);
}

TEST(MarchOnThreads, HasTheFieldOfOneThreadRoundAPointOfVeryManyTriangles)
{
  // One thread goes on alone, as all points of a fan wait at once.
  const auto fan = meshOf(disc(100000));
  expectSameField(fan, { seedAt(*fan, 0) }, {}, false);
  expectSameField(fan, { seedAt(*fan, 50000) }, {}, false);
  // With another part, which is left to reach, it does not.
  const auto mesh = meshOf(joined(disc(30000), icosphere(6)));
  expectSameField(mesh, { seedAt(*mesh, 0) });
  expectSameField(mesh, { seedAt(*mesh, 15000) });
}

TEST(MarchOnThreads, OneThreadGoesOnAloneWhereTheFrontIsShort)
{
  // A strip: its front has a few vertices everywhere.
  const auto mesh = meshOf(planeGrid(3, 20000, 3.0, 20000.0));
  FastMarchingSolver solver(mesh);
  SolveOptions options;
  options.threads = 3;
  options.verticesOfThread = 10000;
  const std::vector<Seed> seeds{ seedAt(*mesh, 0) };
  const DistanceField& field = solver.solve(seeds, options);
  EXPECT_EQ(solver.threadWork().rounds, 0);
  FastMarchingSolver one(mesh);
  EXPECT_LE(difference(one.solve(seeds), field), 1e-9);
}

TEST(MarchOnThreads, SmallPartsStayOnOneThread)
{
  // A thousand spheres.
  const Surface sphere = icosphere(3);
  Surface all;
  for (int part = 0; part < 1000; ++part)
  {
    const auto first = static_cast<Index>(all.points.size());
    all.points.insert(all.points.end(), sphere.points.begin(), sphere.points.end());
    for (const Triangle& t : sphere.triangles)
    {
      all.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
  }
  const auto mesh = meshOf(all);
  FastMarchingSolver solver(mesh);
  SolveOptions options;
  options.threads = 2;
  solver.solve(std::vector<Seed>{ seedAt(*mesh, 0) }, options);
  EXPECT_EQ(solver.threadWork().rounds, 0);
}

TEST(MarchOnThreads, ProgressGoesOnWhereOneThreadBeginsAgain)
{
  // Needles on which vertices lower each other again and again.
  Surface flat = torus(200, 200, 1.0, 0.4);
  for (Vector3& point : flat.points)
  {
    point.x *= 1e-3;
  }
  const auto mesh = meshOf(flat);
  FastMarchingSolver solver(mesh);
  std::size_t last = 0;
  SolveOptions options = onThreads(3);
  options.onProgress = expectMoreThan(last);
  const std::vector<Seed> seeds{ seedAt(*mesh, 15000) };
  solver.solve(seeds, options);
  EXPECT_EQ(solver.threadWork().rounds, 0);
  options.onProgress = [](std::size_t) { return false; };
  EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
}

TEST(MarchOnThreads, BeginsAgainOnOneThreadWithSeveralSeeds)
{
  Surface flat = torus(120, 120, 1.0, 0.4);
  for (Vector3& point : flat.points)
  {
    point.x *= 1e-3;
  }
  const auto mesh = meshOf(flat);
  for (const Index step : { 5000, 36 })
  {
    std::vector<Seed> seeds;
    for (Index point = 7; point < mesh->numberOfVertices(); point += step)
    {
      seeds.push_back(seedAt(*mesh, point));
    }
    FastMarchingSolver one(mesh);
    FastMarchingSolver several(mesh);
    const DistanceField& expected = one.solve(seeds);
    for (int run = 0; run < 2; ++run)
    {
      const DistanceField& field = several.solve(seeds, onThreads(3));
      EXPECT_LE(difference(expected, field), 1e-6) << seeds.size() << " seeds, run " << run;
      EXPECT_EQ(field.raisedGain(), expected.raisedGain()) << seeds.size() << " seeds, run " << run;
      EXPECT_EQ(field.reached().size(), expected.reached().size());
    }
    // A front of few seeds goes too far where needles lower each other.
    EXPECT_EQ(several.threadWork().rounds == 0, seeds.size() < 10);
    SolveOptions options = onThreads(3);
    options.onProgress = [](std::size_t taken) { return taken < 5000; };
    EXPECT_EQ(several.solve(seeds, options).stopReason(), StopReason::Cancelled);
    EXPECT_LE(difference(expected, several.solve(seeds, onThreads(3))), 1e-6);
  }
}

TEST(MarchOnThreads, MovesItsSeedsFromRunToRun)
{
  const auto mesh = meshOf(icosphere(4));
  FastMarchingSolver one(mesh);
  FastMarchingSolver several(mesh);
  for (Index point = 0; point < 2500; point += 100)
  {
    const std::vector<Seed> seeds{ seedAt(*mesh, point) };
    const DistanceField& expected = one.solve(seeds);
    EXPECT_LE(difference(expected, several.solve(seeds, onThreads(2 + point / 100 % 3))), 1e-9);
  }
}

TEST(MarchOnThreads, ReportsProgressOfAllAndEndsWhenCancelled)
{
  const auto mesh = meshOf(icosphere(5));
  FastMarchingSolver solver(mesh);
  std::size_t last = 0;
  SolveOptions options = onThreads(3);
  options.onProgress = expectMoreThan(last);
  const std::vector<Seed> seeds{ seedAt(*mesh, 0) };
  solver.solve(seeds, options);
  EXPECT_GT(last, mesh->numberOfVertices() / 2);
  options.onProgress = [](std::size_t taken) { return taken < 2000; };
  EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
  FastMarchingSolver one(mesh);
  EXPECT_LE(difference(one.solve(seeds), solver.solve(seeds, onThreads(3))), 1e-9);
}

// Before the threads are made, until they run, and later.
TEST(MarchOnThreads, EndsAtAnyMoment)
{
  // The larger part goes on while the smaller one ends.
  const auto mesh = meshOf(joined(icosphere(5), torus(60, 30, 3.0, 1.0)));
  const Index onTorus = 10242;
  FastMarchingSolver one(mesh);
  FastMarchingSolver solver(mesh);
  SolveOptions options;
  options.threads = 3;
  options.verticesOfThread = 1024;
  options.progressInterval = 1;
  for (std::size_t last = 900; last < 2400; last += 29)
  {
    const std::vector<Seed> seeds{ seedAt(*mesh, last % 2 == 0 ? 0 : onTorus) };
    // How many updates a run on threads takes differs from run to run.
    const bool mayBeOver = last % 2 != 0 && last > 1800;
    bool hasEnded = false;
    options.onProgress = [&](std::size_t taken)
    {
      EXPECT_FALSE(hasEnded) << last;
      hasEnded = taken >= last;
      return !hasEnded;
    };
    const StopReason reason = solver.solve(seeds, options).stopReason();
    EXPECT_EQ(reason, hasEnded ? StopReason::Cancelled : StopReason::Exhausted) << last;
    EXPECT_TRUE(hasEnded || mayBeOver) << last;
    options.onProgress = nullptr;
    EXPECT_LE(difference(one.solve(seeds), solver.solve(seeds, options)), 1e-9) << last;
    FastMarchingSolver failing(mesh);
    bool hasThrown = false;
    options.onProgress = [&](std::size_t taken)
    {
      hasThrown = taken >= last;
      return hasThrown ? throw std::runtime_error("a test") : true;
    };
    bool isCaught = false;
    try
    {
      failing.solve(seeds, options);
    }
    catch (const std::runtime_error&)
    {
      isCaught = true;
    }
    EXPECT_EQ(isCaught, hasThrown) << last;
    EXPECT_TRUE(hasThrown || mayBeOver) << last;
  }
}

TEST(MarchOnThreads, NothingIsDoneOnceItWasCancelled)
{
  const auto mesh = meshOf(icosphere(1));
  const SolveOptions options;
  SharedMarch march(*mesh, 2, 1, options);
  std::vector<EndlessFront> fronts(2);
  callTogether(
    2, [&](const auto&) { march.begin(10, 10, 10, true); },
    [&](std::size_t thread)
    {
      SharedMarch::Share share(march, thread);
      EXPECT_FALSE(share.march(fronts[thread]));
    });
  EXPECT_EQ(fronts[0].numberOfAdvances() + fronts[1].numberOfAdvances(), 0);
}

TEST(MarchOnThreads, PassesAnErrorOn)
{
  const auto mesh = meshOf(icosphere(5));
  FastMarchingSolver solver(mesh);
  SolveOptions options = onThreads(3);
  options.onProgress = [](std::size_t taken) -> bool
  {
    if (taken > 3000)
    {
      throw std::runtime_error("a test");
    }
    return true;
  };
  EXPECT_THROW(solver.solve(std::vector<Seed>{ seedAt(*mesh, 0) }, options), std::runtime_error);
}

TEST(MarchOnThreads, SmallSurfacesAndBoundedRunsStayOnOneThread)
{
  const auto mesh = meshOf(icosphere(4));
  FastMarchingSolver solver(mesh);
  const std::vector<Seed> seeds{ seedAt(*mesh, 0) };
  SolveOptions options;
  options.threads = 8;
  solver.solve(seeds, options);
  EXPECT_EQ(solver.threadWork().rounds, 0);
  options = onThreads(8);
  options.maximumDistance = 0.5;
  solver.solve(seeds, options);
  EXPECT_EQ(solver.threadWork().rounds, 0);
}

#endif
