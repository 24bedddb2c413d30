// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Cases that cost the core more than those of the benchmarks:
//   WorstCases [--tiny] CASE [ARGUMENT...]
// Prints the name and number of all that is measured, a pair a line, as soon as it is known: a case
// may not end. worst_suite.py runs them all and makes the document. To be run on one core.

#include "BenchmarkCases.h"
#include "FieldError.h"
#include "PathStyles.h"
#include "Solving.h"
#include "Trial.h"
#include "WorstSeeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <span>
#include <stdexcept>
#include <string>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

void printCost(const RunCost& cost)
{
  print("seconds", cost.seconds);
  print("silence", cost.silence);
  if (cost.reached > 0)
  {
    print("updates", static_cast<double>(cost.updates) / static_cast<double>(cost.reached));
    print("reached", static_cast<double>(cost.reached));
  }
}

/** What one seed and Dijkstra's algorithm take on the surface. */
void printUnits(Trial& trial)
{
  print("points", trial.mesh().numberOfVertices());
  print("one_seed", trial.secondsOfOneSeed());
  print("dijkstra", trial.secondsOfDijkstra());
}

/** The same where the surface is itself the case: one seed is on a hilly grid of as many points. */
void printUnitsOfOrdinarySurface(const Trial& trial)
{
  print("points", trial.mesh().numberOfVertices());
  print("one_seed", Trial(ordinarySurface(trial.mesh().numberOfVertices())).secondsOfOneSeed());
  print("dijkstra", trial.secondsOfDijkstra());
}

/** What many seeds take, and how far their field is from the least of their single fields. */
void printManySeeds(Trial& trial, const std::vector<Seed>& seeds, const SolveOptions& options = {})
{
  print("items", static_cast<double>(seeds.size()));
  printCost(trial.solve(seeds, options));
  const DifferenceToLeast difference = differenceToLeast(trial.sharedMesh(), seeds, options);
  print("difference_mean", difference.mean);
  print("difference_largest", difference.largest);
}

std::vector<Seed> seedsAtRandom(Trial& trial, Index count)
{
  std::vector<Seed> list;
  for (Index vertex : randomVertices(trial.mesh(), count, trial.random()))
  {
    list.push_back(Seed::atPoint(trial.mesh().pointAtVertex(vertex)));
  }
  return list;
}

/** Seeds that crowd in some triangles next to each other. */
std::vector<Seed> seedsInTriangles(Trial& trial, Index count, Index triangles)
{
  const std::vector<Index> nearest =
    trianglesRound(trial.mesh(), trial.mesh().numberOfTriangles() / 2, triangles);
  std::vector<Seed> list;
  for (Index i = 0; i < count; ++i)
  {
    SurfacePoint point = randomPoint(trial.mesh(), trial.random());
    point.triangle = nearest[i % nearest.size()];
    list.push_back(Seed::atPoint(point));
  }
  return list;
}

/** Random vertices as seeds: SURFACE COUNT. */
void seeds(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  printManySeeds(trial, seedsAtRandom(trial, arguments.count(1)));
}

/** The same where their single fields would take too long: SURFACE COUNT. */
void seedsOnHub(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  const std::vector<Seed> list = seedsAtRandom(trial, arguments.count(1));
  print("items", static_cast<double>(list.size()));
  printCost(trial.solve(list));
}

/** Seeds that crowd: SURFACE COUNT TRIANGLES. */
void crowd(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  printManySeeds(trial, seedsInTriangles(trial, arguments.count(1), arguments.count(2)));
}

/** Any number of seeds inside one face: SURFACE COUNT. */
void seedsOfOneFace(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  const std::vector<Seed> list = seedsInTriangles(trial, arguments.count(1), 1);
  print("items", static_cast<double>(list.size()));
  printCost(trial.solve(list));
}

std::vector<Segment> sliceOf(const TriangleMesh& mesh)
{
  const Box box = boxOf(mesh);
  const double size = box.high.x - box.low.x;
  // Not through any vertex, and steep enough to cross edges of all directions.
  return segmentsAtZero(mesh, [&](const Vector3& p) { return p.y + 0.7431 * p.x - 0.8713 * size; });
}

/** Segments of lines, each a seed, as the filter solves them. @param word "numbered" if it is to
 * tell the nearest seed */
void printLooseSegments(Trial& trial, const std::vector<Segment>& segments, const std::string& word)
{
  SolveOptions options;
  options.numbersSeeds = word == "numbered";
  printManySeeds(trial, looseSeeds(segments), options);
}

/** The line of a slice across a hilly grid: CELLS loose|numbered|curve. */
void slice(const CaseArguments& arguments)
{
  const Index cells = arguments.count(0);
  Trial trial(hillyGrid(cells, cells));
  printUnits(trial);
  const std::vector<Segment> segments = sliceOf(trial.mesh());
  if (arguments.word(1) != "curve")
  {
    printLooseSegments(trial, segments, arguments.word(1));
    return;
  }
  print("items", static_cast<double>(segments.size()));
  printCost(trial.solve({ seedAlong(trial.mesh(), segments) }));
}

/** All boundary edges, each for itself: SURFACE loose|numbered. */
void border(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  printLooseSegments(trial, boundarySegments(trial.mesh()), arguments.word(1));
}

/** The segments of a contour of z, each for itself: SURFACE Z loose|numbered. */
void contour(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  const double level = arguments.number(1);
  printLooseSegments(trial,
    segmentsAtZero(trial.mesh(), [&](const Vector3& p) { return p.z - level; }), arguments.word(2));
}

/** Edges at random, each for itself: SURFACE COUNT loose|numbered. */
void edges(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  printLooseSegments(
    trial, randomEdges(trial.mesh(), arguments.count(1), trial.random()), arguments.word(2));
}

/** Vertices on a random walk along edges. @param steps from each to the next */
std::vector<SurfacePoint> randomWalk(Trial& trial, Index count, int steps)
{
  const TriangleMesh& mesh = trial.mesh();
  Index vertex = mesh.numberOfVertices() / 2;
  std::vector<SurfacePoint> points;
  for (Index i = 0; i < count; ++i)
  {
    points.push_back(mesh.pointAtVertex(vertex));
    for (int step = 0; step < steps; ++step)
    {
      const std::span<const RingEntry> ring = mesh.ring(vertex);
      vertex = ring[trial.random()() % ring.size()].neighbour();
    }
  }
  return points;
}

/** One curve that wanders from vertex to vertex and crosses itself: SURFACE BENDS. */
void wanderingCurve(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  const Index bends = arguments.count(1);
  print("items", bends);
  printCost(trial.solve({ Seed::alongCurve(randomWalk(trial, bends, 1)) }));
}

/** Paths through waypoints, each some edges from the one before: SURFACE WAYPOINTS. */
void waypoints(const CaseArguments& arguments)
{
  constexpr int edges = 20;
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  const std::vector<SurfacePoint> points = randomWalk(trial, arguments.count(1), edges);
  print("items", static_cast<double>(points.size()));
  printCost(trial.run(
    [&](const SolveOptions& options)
    {
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        shortestPath(trial.solver(), points[i - 1], points[i], options, Straight);
        // As a caller would between paths.
        options.onProgress(0);
      }
    }));
}

/** Triangles apart, some of them with a seed: TRIANGLES SEEDS. */
void parts(const CaseArguments& arguments)
{
  Trial trial(trianglesApart(arguments.count(0)));
  print("points", trial.mesh().numberOfVertices());
  std::vector<Seed> list;
  for (Index i = 0; i < arguments.count(1); ++i)
  {
    list.push_back(Seed::atPoint(randomPoint(trial.mesh(), trial.random())));
  }
  print("items", static_cast<double>(list.size()));
  printCost(trial.solve(list));
}

/** Log-normal costs at random: SURFACE SIGMA SEEDS. A single seed is at the middle vertex. */
void cost(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  std::normal_distribution<double> logarithm(0.0, arguments.number(1));
  std::vector<double> costs(trial.mesh().numberOfVertices());
  std::generate(costs.begin(), costs.end(), [&] { return std::exp(logarithm(trial.random())); });
  print("points", trial.mesh().numberOfVertices());
  print("one_seed", trial.secondsOfOneSeed());
  print("dijkstra", trial.secondsOfDijkstra(costs));
  SolveOptions options;
  options.cost = costs;
  const auto count = static_cast<Index>(arguments.number(2));
  std::vector<Index> vertices{ trial.mesh().numberOfVertices() / 2 };
  if (count > 1)
  {
    vertices = randomVertices(trial.mesh(), count, trial.random());
  }
  std::vector<Seed> seeds;
  for (const Index vertex : vertices)
  {
    seeds.push_back(Seed::atPoint(trial.mesh().pointAtVertex(vertex)));
  }
  printCost(trial.solve(seeds, options));
}

/** The field of one seed: SURFACE POINT. */
void field(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnitsOfOrdinarySurface(trial);
  printCost(trial.solve({ seedAt(trial.mesh(), static_cast<Index>(arguments.number(1))) }));
}

/** A field as far as random vertices, with a seed at one vertex: SURFACE TARGETS. */
void targets(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  std::vector<Triangle> list;
  for (Index vertex : randomVertices(trial.mesh(), arguments.count(1), trial.random()))
  {
    list.push_back({ vertex, vertex, vertex });
  }
  print("items", static_cast<double>(list.size()));
  SolveOptions options;
  options.targets = list;
  options.targetMode = TargetMode::All;
  printCost(trial.solve(
    { Seed::atPoint(trial.mesh().pointAtVertex(trial.mesh().numberOfVertices() / 2)) }, options));
}

/** The path between the surface's two points: SURFACE. */
void path(const CaseArguments& arguments)
{
  const WorstSurface surface = arguments.surface(0);
  Trial trial(surface.surface);
  printUnitsOfOrdinarySurface(trial);
  const auto at = [&](Index point)
  { return trial.mesh().pointAtVertex(trial.mesh().vertexOfPoint(point)); };
  printCost(trial.run(
    [&](const SolveOptions& options)
    {
      if (!shortestPath(trial.solver(), at(surface.from), at(surface.to), options, Straight))
      {
        throw std::runtime_error("there is no path");
      }
    }));
}

/** Paths from many points to the nearest of some: SURFACE STARTS ENDS. */
void starts(const CaseArguments& arguments)
{
  Trial trial(arguments.surface(0).surface);
  printUnits(trial);
  const auto points = [&](Index count)
  {
    std::vector<SurfacePoint> list(count);
    std::generate(
      list.begin(), list.end(), [&] { return randomPoint(trial.mesh(), trial.random()); });
    return list;
  };
  const std::vector<SurfacePoint> from = points(arguments.count(1));
  const std::vector<SurfacePoint> to = points(arguments.count(2));
  print("items", static_cast<double>(from.size()));
  printCost(trial.run(
    [&](const SolveOptions& options)
    {
      PathFinder finder(trial.solver(), to, options, Straight);
      finder.march(from);
      for (const std::size_t start : orderInMemory(trial.mesh(), from))
      {
        finder.pathFrom(from[start]);
        // As a caller would between paths.
        options.onProgress(0);
      }
    }));
}

constexpr std::array<double Vector3::*, 3> Axes{ &Vector3::x, &Vector3::y, &Vector3::z };

/** One seed on a surface made flat; of some seeds and all axes the one that takes the most times
 * Dijkstra's algorithm, measured right before it: SURFACE FACTOR METHOD. */
void flat(const CaseArguments& arguments)
{
  constexpr Index sources = 3;
  const Surface surface = arguments.surface(0).surface;
  Trial before(surface);
  print("points", before.mesh().numberOfVertices());
  print("one_seed", before.secondsOfOneSeed());
  double dijkstra = 0.0;
  RunCost worst;
  for (const auto axis : Axes)
  {
    Trial trial(flattened(surface, axis, arguments.number(1)), arguments.word(2));
    for (Index vertex : randomVertices(trial.mesh(), sources, trial.random()))
    {
      const double yardstick = trial.secondsOfDijkstra();
      const RunCost cost = trial.solve({ Seed::atPoint(trial.mesh().pointAtVertex(vertex)) });
      if (dijkstra == 0.0 || cost.seconds * dijkstra > worst.seconds * yardstick)
      {
        worst = cost;
        dijkstra = yardstick;
      }
    }
  }
  print("dijkstra", dijkstra);
  printCost(worst);
}

/** Errors of one seed's field on a surface made flat, the worst of all axes, beside those before:
 * SURFACE FACTOR METHOD. */
void flatError(const CaseArguments& arguments)
{
  const Surface surface = arguments.surface(0).surface;
  print("points", static_cast<double>(surface.points.size()));
  const FieldError before = errorOn(surface, arguments.word(2));
  FieldError worst;
  for (const auto axis : Axes)
  {
    const FieldError error =
      errorOn(flattened(surface, axis, arguments.number(1)), arguments.word(2));
    worst.tooSmall = std::max(worst.tooSmall, error.tooSmall);
    worst.mean = std::max(worst.mean, error.mean);
  }
  print("too_small_before", before.tooSmall);
  print("mean_error_before", before.mean);
  print("too_small", worst.tooSmall);
  print("mean_error", worst.mean);
}

const BenchmarkCases Cases{
  { "seeds", seeds },
  { "seeds-on-hub", seedsOnHub },
  { "seeds-of-one-face", seedsOfOneFace },
  { "crowd", crowd },
  { "slice", slice },
  { "border", border },
  { "contour", contour },
  { "edges", edges },
  { "wandering-curve", wanderingCurve },
  { "parts", parts },
  { "cost", cost },
  { "field", field },
  { "targets", targets },
  { "path", path },
  { "starts", starts },
  { "waypoints", waypoints },
  { "flat", flat },
  { "flat-error", flatError },
};

}

int main(int argc, char** argv)
{
  return runCase(Cases, argc, argv);
}
