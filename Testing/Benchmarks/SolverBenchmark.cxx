// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The core's times, errors and memory beside Dijkstra's and the heat method's:
//   SolverBenchmark [--tiny] [Google Benchmark's options]
// Every repetition takes another random source and runs what is compared right after each other, so
// that the ratios, of which the medians count, are little disturbed by what else the machine does.
// To be run on one core, but for SetupOnTwoThreads; suite.py does so and makes the document.

#include "HeapMeter.h"
#include "HeatMethod.h"
#include "Measuring.h"
#include "Subject.h"
#include "march/ReferenceSolver.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string_view>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Mean errors over all points whose distance is known: in parts of the largest, and of each own.
 */
struct MeanError
{
  double ofLargest = 0.0;
  double ofOwn = 0.0;
};

template <class DistanceAt>
MeanError meanError(const std::vector<double>& truth, DistanceAt distanceAt)
{
  MeanError error;
  double largest = 0.0;
  std::size_t counted = 0;
  for (Index point = 0; point < truth.size(); ++point)
  {
    if (truth[point] > 0.0)
    {
      const double off = std::abs(distanceAt(point) - truth[point]);
      error.ofLargest += off;
      error.ofOwn += off / truth[point];
      largest = std::max(largest, truth[point]);
      ++counted;
    }
  }
  error.ofLargest /= largest * static_cast<double>(counted);
  error.ofOwn /= static_cast<double>(counted);
  return error;
}

void report(benchmark::State& state, const MeanError& error)
{
  state.counters["error_of_largest"] = error.ofLargest;
  state.counters["error_of_own"] = error.ofOwn;
}

/** One solve from a position, the search for the position's point included. */
struct Run
{
  double time = 0.0;
  /** Valid until the next run. */
  const DistanceField* field = nullptr;
};

Run runFrom(Subject& s, const Vector3& position, const SolveOptions& options = {})
{
  Run run;
  run.time = seconds(
    [&]
    {
      const Seed seed = s.seedAt(position);
      run.field = &s.solver.solve({ &seed, 1 }, options);
    });
  return run;
}

double dijkstraSeconds(Subject& s, const Vector3& position)
{
  const Index source = s.vertexNear(s.pointAt(position));
  return seconds([&] { benchmark::DoNotOptimize(s.dijkstra.solve(source).data()); });
}

/** How often what is compared runs for one repetition: on small surfaces until as many points were
 * passed as the others have. One run there is over in a millisecond, before the processor foresees
 * the program's branches. */
int roundsOn(const Subject& s)
{
  constexpr Index points = 160000;
  constexpr Index most = 16;
  return static_cast<int>(std::clamp<Index>(points / s.mesh->numberOfVertices(), 1, most));
}

double nanosecondsAPoint(const Subject& s, double time)
{
  return 1e9 * time / s.mesh->numberOfVertices();
}

/** The whole field from one seed. */
void solve(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  const int rounds = roundsOn(s);
  for (auto _ : state)
  {
    Vector3 position;
    Run run;
    double dijkstra = 0.0;
    double time = 0.0;
    for (int i = 0; i < rounds; ++i)
    {
      position = s.randomPosition();
      dijkstra += dijkstraSeconds(s, position) / rounds;
      run = runFrom(s, position);
      time += run.time / rounds;
    }
    state.SetIterationTime(time);
    state.counters["points"] = s.mesh->numberOfVertices();
    state.counters["dijkstra_ns"] = nanosecondsAPoint(s, dijkstra);
    state.counters["solve_ns"] = nanosecondsAPoint(s, time);
    state.counters["ratio"] = time / dijkstra;
    if (s.truth)
    {
      report(state,
        meanError(s.truth(onSurface(*s.mesh, s.pointAt(position))),
          [&](Index point) { return run.field->distance(s.mesh->vertexOfPoint(point)); }));
    }
  }
}

/** What is made once for an input. */
void setup(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  const int rounds = roundsOn(s);
  for (auto _ : state)
  {
    double dijkstra = 0.0;
    double time = 0.0;
    for (int i = 0; i < rounds; ++i)
    {
      dijkstra += dijkstraSeconds(s, s.randomPosition()) / rounds;
      // Kept, as by who uses it: to give it back is not measured.
      SetUp made;
      time += seconds([&] { made = setUp(s.surface); }) / rounds;
    }
    state.SetIterationTime(time);
    state.counters["setup_ns"] = nanosecondsAPoint(s, time);
    state.counters["ratio"] = time / dijkstra;
  }
}

/** One thread against two, by the clock on the wall: what threads cost is in no processor time. */
void setupOnTwoThreads(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  const auto wallSeconds = [&](unsigned threads)
  {
    const auto start = std::chrono::steady_clock::now();
    const SetUp made = setUp(s.surface, threads);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (auto _ : state)
  {
    const double one = wallSeconds(1);
    const double two = wallSeconds(2);
    state.SetIterationTime(two);
    state.counters["ratio"] = one / two;
  }
}

/** The other tier: the same field by the scalar solver that the batched one is held to. */
void reference(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  ReferenceSolver solver(s.mesh, s.made.bounds);
  for (auto _ : state)
  {
    const Vector3 position = s.randomPosition();
    const Seed seed = s.seedAt(position);
    const double dijkstra = dijkstraSeconds(s, position);
    const double time = seconds([&] { solver.solve({ &seed, 1 }); });
    state.SetIterationTime(time);
    state.counters["solve_ns"] = nanosecondsAPoint(s, time);
    state.counters["ratio"] = time / dijkstra;
  }
}

void heat(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  for (auto _ : state)
  {
    std::unique_ptr<HeatMethod> method;
    state.counters["setup_ns"] =
      nanosecondsAPoint(s, seconds([&] { method = std::make_unique<HeatMethod>(*s.mesh); }));
    const Vector3 position = s.randomPosition();
    const Index vertex = s.vertexNear(s.pointAt(position));
    const double dijkstra = dijkstraSeconds(s, position);
    std::vector<double> distances;
    const double time = seconds([&] { distances = method->solve(vertex); });
    state.SetIterationTime(time);
    state.counters["solve_ns"] = nanosecondsAPoint(s, time);
    state.counters["ratio"] = time / dijkstra;
    report(state,
      meanError(s.truth(onSurface(*s.mesh, s.mesh->pointAtVertex(vertex))),
        [&](Index point) { return distances[s.mesh->vertexOfPoint(point)]; }));
  }
}

/** A hundred seeds, each with a label of its own, against one of them, the mean of a run before and
 * one after. */
void hundredSeeds(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  for (auto _ : state)
  {
    std::vector<Vector3> positions(100);
    std::generate(positions.begin(), positions.end(), [&] { return s.randomPosition(); });
    const double before = runFrom(s, positions.front()).time;
    const double hundred = seconds(
      [&]
      {
        std::vector<Seed> seeds;
        for (const Vector3& position : positions)
        {
          seeds.push_back(s.seedAt(position));
        }
        s.solver.solve(seeds);
      });
    const double after = runFrom(s, positions.back()).time;
    state.SetIterationTime(hundred);
    state.counters["ratio"] = 2.0 * hundred / (before + after);
  }
}

/** Time a point on the large mesh over that on the small one. */
void growth(benchmark::State& state, const std::string& small, const std::string& large)
{
  Subject& a = subject(small);
  Subject& b = subject(large);
  for (auto _ : state)
  {
    const double onSmall = nanosecondsAPoint(a, runFrom(a, a.randomPosition()).time);
    const double time = runFrom(b, b.randomPosition()).time;
    state.SetIterationTime(time);
    state.counters["ratio"] = nanosecondsAPoint(b, time) / onSmall;
  }
}

/** Within one hundredth of the bounding box's diagonal, the workspace being there. */
void boundedQuery(benchmark::State& state, const std::string& name)
{
  constexpr int queries = 50;
  Subject& s = subject(name);
  const Box box = boxOf(*s.mesh);
  SolveOptions options;
  options.maximumDistance = 0.01 * norm(box.high - box.low);
  for (auto _ : state)
  {
    runFrom(s, s.randomPosition(), options);
    double time = 0.0;
    double reached = 0.0;
    for (int i = 0; i < queries; ++i)
    {
      const Run run = runFrom(s, s.randomPosition(), options);
      time += run.time / queries;
      reached += static_cast<double>(run.field->reached().size()) / queries;
    }
    state.SetIterationTime(time);
    state.counters["query_us"] = 1e6 * time;
    state.counters["reached"] = reached;
  }
}

/** The index of closest points: its making, and queries on the surface and anywhere in its box. */
void closestPoint(benchmark::State& state, const std::string& name)
{
  constexpr int queries = 2000;
  Subject& s = subject(name);
  const Box box = boxOf(*s.mesh);
  const auto between = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(s.random); };
  const auto microseconds = [&](const std::vector<Vector3>& positions)
  {
    const double time = seconds(
      [&]
      {
        for (const Vector3& position : positions)
        {
          benchmark::DoNotOptimize(s.tree.closestPoint(position));
        }
      });
    return 1e6 * time / queries;
  };
  for (auto _ : state)
  {
    std::vector<Vector3> on(queries);
    std::vector<Vector3> off(queries);
    std::generate(on.begin(), on.end(), [&] { return s.randomPosition(); });
    for (Vector3& position : off)
    {
      position.x = between(box.low.x, box.high.x);
      position.y = between(box.low.y, box.high.y);
      position.z = between(box.low.z, box.high.z);
    }
    const double build = seconds([&] { benchmark::DoNotOptimize(ClosestPointTree(s.mesh)); });
    state.SetIterationTime(build);
    state.counters["build_ns"] = 1e9 * build / s.mesh->numberOfTriangles();
    state.counters["on_surface_us"] = microseconds(on);
    state.counters["in_box_us"] = microseconds(off);
  }
}

/** Bytes a point of everything beside the surface itself. */
void memory(benchmark::State& state, const std::string& name)
{
  Subject& s = subject(name);
  const double points = s.mesh->numberOfVertices();
  for (auto _ : state)
  {
    const HeapMeter meter;
    const auto [mesh, bounds] = setUp(s.surface);
    FastMarchingSolver solver(mesh, bounds);
    const Seed byId = Seed::atPoint(mesh->pointAtVertex(0));
    solver.solve({ &byId, 1 });
    state.counters["held"] = static_cast<double>(meter.held()) / points;
    state.counters["peak"] = static_cast<double>(meter.peak()) / points;
    const ClosestPointTree tree(mesh);
    const Seed byPosition = Seed::atPoint(tree.closestPoint(s.randomPosition()).point);
    solver.solve({ &byPosition, 1 });
    state.counters["held_with_index"] = static_cast<double>(meter.held()) / points;
    state.SetIterationTime(1.0);
  }
}

template <class Function, class... Names>
benchmark::internal::Benchmark* add(
  const char* what, Function function, const std::string& name, const Names&... names)
{
  return benchmark::RegisterBenchmark((std::string(what) + "/" + name).c_str(),
    [=](benchmark::State& state) { function(state, name, names...); })
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->Repetitions(7);
}

void addAll()
{
  for (const std::string& name : subjectNames())
  {
    add("Solve", solve, name);
    add("Setup", setup, name);
  }
  add("SetupOnTwoThreads", setupOnTwoThreads, "icosphere 650k");
  for (const char* name : { "icosphere 10k", "Bunny 35k", "icosphere 160k", "Delaunay plane 160k",
         "thin grid 160k", "rounded tube 66k" })
  {
    add("Heat", heat, name)->Repetitions(3);
  }
  for (const char* name : { "icosphere 10k", "Bunny 35k", "icosphere 160k", "Delaunay plane 160k",
         "thin grid 160k", "torus 250k", "icosphere 650k" })
  {
    add("Reference", reference, name)->Repetitions(3);
  }
  add("HundredSeeds", hundredSeeds, "icosphere 160k");
  add("HundredSeeds", hundredSeeds, "Delaunay plane 160k");
  add("Growth", growth, "icosphere 160k", std::string("icosphere 2.6M"));
  add("BoundedQuery", boundedQuery, "icosphere 2.6M");
  add("ClosestPoint", closestPoint, "Bunny 35k");
  add("ClosestPoint", closestPoint, "icosphere 650k");
  add("Memory", memory, "icosphere 650k")->Repetitions(1);
}

}

int main(int argc, char** argv)
{
  char** const end = std::remove(argv + 1, argv + argc, std::string_view("--tiny"));
  if (end != argv + argc)
  {
    useTinySubjects();
    argc = static_cast<int>(end - argv);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  addAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
