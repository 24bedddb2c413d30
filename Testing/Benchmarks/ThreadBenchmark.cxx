// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What one field of fast marching takes on several threads:
//   ThreadBenchmark SURFACE THREADS RUNS [SEEDS]
// For SURFACE see NamedSurface.h. Each run has other seeds, one if it is not said how many. Prints
// the name and number of all that is measured or counted, a pair a line: times are medians in
// milliseconds of the clock. thread_suite.py makes tables.

#include "NamedSurface.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

double median(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

/** Milliseconds of the clock. */
template <class Work>
double timeOf(const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

void measure(const std::string& surface, std::size_t threads, int runs, std::size_t numberOfSeeds)
{
  const auto mesh = meshOf(namedSurface(surface));
  FastMarchingSolver alone(mesh);
  FastMarchingSolver shared(mesh);
  std::mt19937 random(1);
  std::vector<double> ones;
  std::vector<double> severals;
  std::vector<double> ratios;
  double difference = 0.0;
  ThreadWork work;
  for (int run = 0; run <= runs; ++run)
  {
    std::vector<Seed> seeds;
    while (seeds.size() < numberOfSeeds)
    {
      seeds.push_back(Seed::atPoint(
        mesh->pointAtVertex(static_cast<Index>(random() % mesh->numberOfVertices()))));
    }
    SolveOptions options;
    const double one = timeOf([&] { alone.solve(seeds, options); });
    options.threads = threads;
    options.verticesOfThread =
      std::min<std::size_t>(options.verticesOfThread, mesh->numberOfVertices() / threads);
    const double several = timeOf([&] { shared.solve(seeds, options); });
    const DistanceField& expected = alone.solve(seeds);
    const DistanceField& field = shared.solve(seeds, options);
    for (const Index vertex : expected.reached())
    {
      difference = std::max(difference,
        std::abs(field.distance(vertex) - expected.distance(vertex)) / expected.largestDistance());
    }
    if (run == 0)
    {
      std::printf("first_alone %.2f\nfirst %.2f\n", one, several);
      continue;
    }
    ones.push_back(one);
    severals.push_back(several);
    ratios.push_back(one / several);
    work.updates += shared.threadWork().updates;
    work.longestChain += shared.threadWork().longestChain;
    work.rounds += shared.threadWork().rounds;
    work.sent += shared.threadWork().sent;
  }
  // One thread takes hardly more than one update a vertex.
  const double vertices = mesh->numberOfVertices();
  const double all = vertices * runs;
  std::printf("vertices %.0f\nalone %.2f\ntime %.2f\nratio %.3f\ndifference %.2g\n", vertices,
    median(ones), median(severals), median(ratios), difference);
  std::printf("updates %.3f\nrounds %.0f\nsent %.4f\nbalance %.3f\nspeed %.3f\n",
    static_cast<double>(work.updates) / all, static_cast<double>(work.rounds) / runs,
    static_cast<double>(work.sent) / all,
    static_cast<double>(work.updates) / static_cast<double>(work.longestChain),
    all / static_cast<double>(work.longestChain));
}

}

int main(int count, char** words)
{
  if (count < 4 || count > 5)
  {
    std::fprintf(stderr, "usage: ThreadBenchmark SURFACE THREADS RUNS [SEEDS]\n");
    return 1;
  }
  try
  {
    measure(
      words[1], std::stoul(words[2]), std::stoi(words[3]), count > 4 ? std::stoul(words[4]) : 1);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "ThreadBenchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
