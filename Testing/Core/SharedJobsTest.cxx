// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Jobs that threads share: each is done once, on as many threads as there may be, with progress
// that never falls, ends and errors as on one thread. And fields of one mesh on several threads.

#include "base/SharedJobs.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "methods/SolverTable.h"
#include "methods/SolverTeam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <latch>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr std::size_t Steps = 1000;

/** A job that counts up its steps. */
void countSteps(const SharedJobs::Turn& turn)
{
  for (std::size_t step = 100; step <= Steps && turn.onProgress(step); step += 100)
  {
  }
}

}

TEST(SharedJobs, DoEachOnceForAnyNumberOfThreads)
{
  for (const std::size_t threads : { 1, 2, 3, 8 })
  {
    for (const std::size_t count : { 0, 1, 2, 500 })
    {
      std::vector<std::atomic<int>> times(count);
      std::vector<std::size_t> reports;
      SharedJobs jobs(threads, Steps, Steps,
        [&](std::size_t steps)
        {
          reports.push_back(steps);
          return true;
        });
      const auto areDone = jobs.run(count,
        [&](const SharedJobs::Turn& turn)
        {
          EXPECT_LT(turn.thread, threads);
          EXPECT_EQ(turn.isShared, threads > 1);
          ++times[turn.number];
          countSteps(turn);
        });
      EXPECT_EQ(areDone, std::vector<bool>(count, true));
      EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int t) { return t == 1; }));
      EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
      EXPECT_TRUE(reports.empty() || reports.back() <= count * Steps);
    }
  }
}

// With all jobs waiting for each other, they end only if all threads work at a time.
TEST(SharedJobs, UseAllThreadsOnceThereIsEnoughToDo)
{
  std::latch allAreAtWork(3);
  SharedJobs jobs(3, Steps, Steps, {});
  jobs.run(3,
    [&](const SharedJobs::Turn& turn)
    {
      countSteps(turn);
      allAreAtWork.arrive_and_wait();
    });
}

TEST(SharedJobs, StayOnTheCallersThreadIfTheyAreSmall)
{
  const auto caller = std::this_thread::get_id();
  SharedJobs jobs(4, 100 * Steps, Steps, {});
  jobs.run(99,
    [&](const SharedJobs::Turn& turn)
    {
      EXPECT_EQ(turn.thread, 0u);
      EXPECT_EQ(std::this_thread::get_id(), caller);
      countSteps(turn);
    });
}

TEST(SharedJobs, ReportOnTheCallersThreadOnly)
{
  const auto caller = std::this_thread::get_id();
  SharedJobs jobs(3, 0, Steps,
    [&](std::size_t)
    {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return true;
    });
  jobs.run(200, countSteps);
}

TEST(SharedJobs, EndOnAllThreadsOnceTheyAreCancelled)
{
  for (const std::size_t threads : { 1, 2, 3, 8 })
  {
    SharedJobs jobs(threads, 0, Steps, [](std::size_t steps) { return steps < 20 * Steps; });
    // From this number on jobs go on until they are ended.
    constexpr std::size_t endless = 25;
    const auto areDone = jobs.run(1000,
      [&](const SharedJobs::Turn& turn)
      {
        countSteps(turn);
        while (turn.number >= endless && turn.onProgress(Steps))
        {
        }
      });
    const auto done = std::count(areDone.begin(), areDone.end(), true);
    EXPECT_GE(done, threads == 1 ? 19 : 1);
    EXPECT_LE(done, static_cast<std::ptrdiff_t>(endless));
    EXPECT_EQ(std::find(areDone.begin() + endless, areDone.end(), true), areDone.end());
  }
}

// Which thread comes to a bad job first is chance; the error is that of the first bad job.
TEST(SharedJobs, FailAsOnOneThread)
{
  for (const std::size_t threads : { 1, 2, 3, 8 })
  {
    const std::string error = errorOf(
      [&]
      {
        SharedJobs jobs(threads, 0, Steps, {});
        jobs.run(100,
          [](const SharedJobs::Turn& turn)
          {
            countSteps(turn);
            if (turn.number == 40 || turn.number == 41 || turn.number == 42)
            {
              throw std::invalid_argument("job " + std::to_string(turn.number));
            }
          });
      });
    EXPECT_EQ(error, "job 40") << threads << " threads";
  }
}

// What fails only for want of memory beside other jobs is done alone.
TEST(SharedJobs, DoAloneWhatFailsBesideOthers)
{
  std::atomic<int> alone = 0;
  SharedJobs jobs(2, 0, Steps, {});
  const auto areDone = jobs.run(50,
    [&](const SharedJobs::Turn& turn)
    {
      if (turn.number == 20 && turn.isShared)
      {
        throw std::runtime_error("too much at a time");
      }
      countSteps(turn);
      alone += turn.isShared ? 0 : 1;
    });
  EXPECT_EQ(areDone, std::vector<bool>(50, true));
  EXPECT_GE(alone, 1);
}

// The fields of many runs with several seeds, costs and barriers, to the bit.
TEST(SharedJobs, GiveTheSameFieldsForAnyNumberOfThreads)
{
  for (unsigned number = 0; number < meshKinds().size(); ++number)
  {
    const auto mesh = meshOf(randomSurface(meshKinds()[number], number));
    std::mt19937 random(number);
    const Index last = mesh->numberOfVertices() - 1;
    std::uniform_int_distribution<Index> anyVertex(0, last);
    std::vector<double> cost(mesh->numberOfVertices());
    std::uniform_real_distribution<double> anyCost(1.0, 3.0);
    std::generate(cost.begin(), cost.end(), [&] { return anyCost(random); });
    std::vector<std::uint8_t> excluded(mesh->numberOfVertices(), 0);
    for (int i = 0; i < 20; ++i)
    {
      excluded[anyVertex(random)] = 1;
    }
    std::vector<std::vector<Seed>> seeds(12);
    for (std::size_t run = 0; run < seeds.size(); ++run)
    {
      while (seeds[run].size() <= run % 3)
      {
        const Index vertex = anyVertex(random);
        if (!excluded[vertex] && !mesh->ring(vertex).empty())
        {
          seeds[run].push_back(Seed::atPoint(mesh->pointAtVertex(vertex)));
        }
      }
    }
    for (const char* method : { "FastMarching", "Dijkstra" })
    {
      std::vector<std::vector<double>> fields;
      for (const std::size_t threads : { 1, 2, 3, 8 })
      {
        SolverTeam solvers;
        solvers.prepare(solverOfName(method), mesh, threads);
        std::vector<std::vector<double>> ofRuns(seeds.size());
        SharedJobs jobs(threads, 0, mesh->numberOfVertices(), {});
        jobs.run(seeds.size(),
          [&](const SharedJobs::Turn& turn)
          {
            SolveOptions options;
            options.cost =
              turn.number % 2 ? std::span<const double>(cost) : std::span<const double>();
            options.excluded = excluded;
            options.onProgress = turn.onProgress;
            const auto distances =
              solvers.ofThread(turn.thread).solve(seeds[turn.number], options).distances();
            ofRuns[turn.number].assign(distances.begin(), distances.end());
          });
        std::vector<double> all;
        for (const std::vector<double>& ofRun : ofRuns)
        {
          all.insert(all.end(), ofRun.begin(), ofRun.end());
        }
        fields.push_back(std::move(all));
        EXPECT_EQ(fields.back(), fields.front()) << method << ", " << threads << " threads";
      }
    }
  }
}
