// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Time, memory, errors and limits of the methods, Exact and Bounded above all:
//   ExactBenchmark [--tiny] CASE [ARGUMENT...]
// Prints the name and number of all that is measured, a pair a line. Each case is to be run in a
// process of its own on one core; exact_suite.py does so and makes the document.

#include "BenchmarkCases.h"
#include "ExactDistances.h"
#include "HeapMeter.h"
#include "Measuring.h"
#include "PathStyles.h"
#include "Subject.h"
#include "WorstSeeds.h"
#include "base/Interruption.h"
#include "base/WorkCount.h"
#include "methods/SolverTable.h"
#include "path/PathFinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr Index Sources = 3;
/** Of errors: on a surface one source in several has a shadow behind a saddle, and others have
 * none. */
constexpr Index ErrorSources = 8;
constexpr double Mega = 1e6;
constexpr double Giga = 1e9;

/** The surfaces of a name and a factor: itself, or made flat along each of the axes. */
std::vector<Surface> surfacesOf(const CaseArguments& arguments, std::size_t i)
{
  const Surface surface = arguments.surface(i).surface;
  const double factor = arguments.number(i + 1);
  if (factor == 1.0)
  {
    return { surface };
  }
  return { flattened(surface, &Vector3::x, factor), flattened(surface, &Vector3::y, factor),
    flattened(surface, &Vector3::z, factor) };
}

double medianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Seed seedOf(const TriangleMesh& mesh, Index vertex)
{
  return Seed::atPoint(mesh.pointAtVertex(vertex));
}

/** The longest time without a report of progress. */
class Silence
{
public:
  bool report()
  {
    const double now = processorSeconds();
    this->Longest = std::max(this->Longest, now - this->Last);
    this->Last = now;
    return true;
  }
  double longest()
  {
    this->report();
    return this->Longest;
  }

private:
  double Last = processorSeconds();
  double Longest = 0.0;
};

/** Time and memory of fields, beside Dijkstra's algorithm from the same vertices; of surfaces made
 * flat the slowest: SURFACE FACTOR METHOD. */
void time(const CaseArguments& arguments)
{
  double ratio = 0.0;
  double bytes = 0.0;
  for (const Surface& surface : surfacesOf(arguments, 0))
  {
    const auto mesh = meshOf(surface);
    HeapDijkstra dijkstra(*mesh);
    const HeapMeter meter;
    const auto solver = solverOfName(arguments.word(2)).make(mesh);
    std::mt19937 random(2);
    const std::vector<Index> sources = randomVertices(*mesh, Sources, random);
    // The first runs are not warm.
    Seed seed = seedOf(*mesh, sources[0]);
    solver->solve({ &seed, 1 }, {});
    const double peak = static_cast<double>(meter.peak());
    dijkstra.solve(sources[0]);
    std::vector<double> ratios;
    std::vector<double> times;
    const std::size_t steps = WorkCount::steps();
    for (const Index source : sources)
    {
      seed = seedOf(*mesh, source);
      const double along = seconds([&] { dijkstra.solve(source); });
      times.push_back(seconds([&] { solver->solve({ &seed, 1 }, {}); }));
      ratios.push_back(times.back() / along);
    }
    const double points = mesh->numberOfVertices();
    bytes = std::max(bytes, peak / points);
    if (medianOf(ratios) > ratio)
    {
      ratio = medianOf(ratios);
      print("points", points);
      print("seconds", medianOf(times));
      print("dijkstras", ratio);
      print("windows", static_cast<double>(WorkCount::steps() - steps) / (Sources * points));
    }
  }
  print("bytes", bytes);
}

/** Errors of a field against exact distances: by CGAL, or by the method Exact: SURFACE FACTOR
 * METHOD TRUTH. */
void error(const CaseArguments& arguments)
{
  double ofLargest = 0.0;
  double ofOwn = 0.0;
  double tooSmall = 0.0;
  double mean = 0.0;
  double unreached = 0.0;
  for (const Surface& surface : surfacesOf(arguments, 0))
  {
    const auto mesh = meshOf(surface);
    const auto solver = solverOfName(arguments.word(2)).make(mesh);
    const auto exact = solverOfName("Exact").make(mesh);
    double sumOfMeans = 0.0;
    double sources = 0.0;
    std::mt19937 random(1);
    // Points that no triangle has are no vertices of the mesh.
    for (const Index source :
      randomVertices(*mesh, arguments.word(3) == "CGAL" ? 1 : ErrorSources, random))
    {
      const Seed seed = seedOf(*mesh, source);
      std::vector<double> truth;
      if (arguments.word(3) == "CGAL")
      {
        const std::vector<double> found = exactDistances(surface, { mesh->pointOfVertex(source) });
        for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
        {
          truth.push_back(found[mesh->pointOfVertex(vertex)]);
        }
      }
      else
      {
        const DistanceField& field = exact->solve({ &seed, 1 }, {});
        for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
        {
          truth.push_back(field.distance(vertex));
        }
      }
      const double largest = *std::max_element(truth.begin(), truth.end());
      const DistanceField& found = solver->solve({ &seed, 1 }, {});
      double sum = 0.0;
      for (Index vertex = 0; vertex < truth.size(); ++vertex)
      {
        const double distance = found.distance(vertex);
        if (!std::isfinite(distance))
        {
          ++unreached;
        }
        else if (truth[vertex] > 0.0)
        {
          const double off = distance - truth[vertex];
          ofLargest = std::max(ofLargest, std::abs(off) / largest);
          ofOwn = std::max(ofOwn, off / truth[vertex]);
          tooSmall = std::max(tooSmall, -off / truth[vertex]);
          sum += std::abs(off) / largest;
        }
      }
      sumOfMeans += sum / static_cast<double>(truth.size());
      ++sources;
    }
    mean = std::max(mean, sumOfMeans / sources);
    print("points", mesh->numberOfVertices());
  }
  print("largest", ofLargest);
  print("too_large", ofOwn);
  print("too_small", tooSmall);
  print("mean", mean);
  print("unreached", unreached);
}

/** How many times as long CGAL takes for the field of one point: SURFACE METHOD. */
void cgal(const CaseArguments& arguments)
{
  const Surface surface = arguments.surface(0).surface;
  const auto mesh = meshOf(surface);
  const auto solver = solverOfName(arguments.word(1)).make(mesh);
  std::mt19937 random(2);
  std::vector<double> ratios;
  for (Index i = 0; i < Sources; ++i)
  {
    const Index source = static_cast<Index>(random() % surface.points.size());
    const Seed seed = seedAt(*mesh, source);
    const double theirs = seconds([&] { exactDistances(surface, { source }); });
    ratios.push_back(theirs / seconds([&] { solver->solve({ &seed, 1 }, {}); }));
  }
  print("points", mesh->numberOfVertices());
  print("times", medianOf(ratios));
}

/** A path to a point about a part of the box's diagonal away: SURFACE PART METHOD. */
void path(const CaseArguments& arguments)
{
  const auto mesh = meshOf(arguments.surface(0).surface);
  const auto solver = solverOfName(arguments.word(2)).make(mesh);
  const Box box = boxOf(*mesh);
  const double reach = arguments.number(1) * norm(box.high - box.low);
  std::mt19937 random(3);
  std::vector<double> times;
  double proven = 0.0;
  const std::size_t paths = arguments.tiny ? 3 : 60;
  while (times.size() < paths)
  {
    const SurfacePoint from = randomPoint(*mesh, random);
    const Vector3 start = mesh->positionOf(from);
    SurfacePoint to = from;
    double off = reach;
    for (int tries = 0; tries < 5000; ++tries)
    {
      const SurfacePoint other = randomPoint(*mesh, random);
      const double miss = std::abs(norm(mesh->positionOf(other) - start) - reach);
      if (miss < off)
      {
        off = miss;
        to = other;
      }
    }
    if (off > 0.3 * reach)
    {
      continue;
    }
    times.push_back(seconds(
      [&]
      {
        PathFinder finder(*solver, { &from, 1 }, {}, Straight);
        if (finder.march({ &to, 1 }) && finder.pathFrom(to))
        {
          proven += finder.isProvenShortest() ? 1.0 : 0.0;
        }
      }));
  }
  print("points", mesh->numberOfVertices());
  print("first", times.front());
  std::sort(times.begin(), times.end());
  print("median", times[times.size() / 2]);
  print("most", times.back());
  print("proven", proven / static_cast<double>(times.size()));
}

/** Many random points as seeds: SURFACE COUNT METHOD. */
void many(const CaseArguments& arguments)
{
  const auto mesh = meshOf(arguments.surface(0).surface);
  std::mt19937 random(1);
  std::vector<Seed> seeds;
  for (Index i = 0; i < arguments.count(1); ++i)
  {
    seeds.push_back(
      arguments.count(1) == 1 ? seedOf(*mesh, 0) : Seed::atPoint(randomPoint(*mesh, random)));
  }
  print("points", mesh->numberOfVertices());
  const HeapMeter meter;
  const auto solver = solverOfName(arguments.word(2)).make(mesh);
  Silence silence;
  SolveOptions options;
  options.onProgress = [&](std::size_t) { return silence.report(); };
  print("seconds",
    seconds([&]
      { print("reached", static_cast<double>(solver->solve(seeds, options).reached().size())); }));
  print("silence", silence.longest());
  print("megabytes", static_cast<double>(meter.peak()) / Mega);
}

/** What a run really takes that must not take more than some gigabytes: SURFACE METHOD GIGABYTES.
 */
void limit(const CaseArguments& arguments)
{
  const auto mesh = meshOf(arguments.surface(0).surface);
  const HeapMeter meter;
  const auto solver = solverOfName(arguments.word(1)).make(mesh);
  const Seed seed = seedOf(*mesh, mesh->numberOfVertices() / 2);
  SolveOptions options;
  options.memoryLimit = static_cast<std::size_t>(Giga * arguments.number(2));
  std::string message = "none";
  try
  {
    solver->solve({ &seed, 1 }, options);
  }
  catch (const std::runtime_error& error)
  {
    message = error.what();
  }
  print("points", mesh->numberOfVertices());
  print("gigabytes", static_cast<double>(meter.peak()) / Giga);
  std::printf("message %s\n", message.c_str());
}

/** How soon a run can be stopped: SURFACE METHOD SECONDS, after which it is. */
void abort(const CaseArguments& arguments)
{
  const auto mesh = meshOf(arguments.surface(0).surface);
  print("points", mesh->numberOfVertices());
  std::unique_ptr<DistanceSolver> solver;
  {
    Silence silence;
    const Interruption interruption([&] { return silence.report(); });
    solver = solverOfName(arguments.word(1)).make(mesh);
    print("silence_of_set_up", silence.longest());
  }
  const SurfacePoint from = mesh->pointAtVertex(mesh->numberOfVertices() / 2);
  const SurfacePoint to = mesh->pointAtVertex(mesh->numberOfVertices() / 7);
  for (const bool isPath : { false, true })
  {
    Silence silence;
    double stopped = 0.0;
    const double start = processorSeconds();
    SolveOptions options;
    options.onProgress = [&](std::size_t)
    {
      silence.report();
      stopped = processorSeconds();
      return stopped - start < arguments.number(2);
    };
    if (isPath)
    {
      PathFinder finder(*solver, { &from, 1 }, options, Straight);
      if (finder.march({ &to, 1 }))
      {
        finder.pathFrom(to);
      }
    }
    else
    {
      const Seed seed = Seed::atPoint(from);
      solver->solve({ &seed, 1 }, options);
    }
    const std::string what = isPath ? "_of_path" : "_of_field";
    print("silence" + what, silence.longest());
    print("end" + what, processorSeconds() - stopped);
    print("seconds" + what, processorSeconds() - start);
  }
}

const BenchmarkCases Cases{
  { "time", time },
  { "error", error },
  { "cgal", cgal },
  { "path", path },
  { "many", many },
  { "limit", limit },
  { "abort", abort },
};

}

int main(int argc, char** argv)
{
  return runCase(Cases, argc, argv);
}
