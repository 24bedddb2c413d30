// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The core's paths: how long beside the truth, and in what time.
//   PathBenchmark [--tiny] [--surfaces=FOLDER] [Google Benchmark's options]
// The surfaces and the pairs of points are written to the folder, for the peers: see path_peers.py.
// To be run on one core; path_suite.py does so and makes the document.

#include "ExactPath.h"
#include "Measuring.h"
#include "PathStyles.h"
#include "PathSurfaces.h"
#include "path/PathFinder.h"
#include "solve/DijkstraSolver.h"
#include "survey/LandmarkOrder.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr int SourcesASurface = 10;
constexpr std::size_t TargetsASource = 20;

// Pairs of points

/** A source and points of the input, with their true distances from it. */
struct Fan
{
  SurfacePoint source;
  std::vector<Index> targets;
  std::vector<double> exact;
};

SurfacePoint pointAt(const TriangleMesh& mesh, Index point)
{
  return mesh.pointAtVertex(mesh.vertexOfPoint(point));
}

/** Targets other than the source that can be reached from it. */
Fan fanFrom(Subject& s, const SurfacePoint& source)
{
  const std::vector<double> exact = s.truth(onSurface(*s.mesh, source));
  Fan fan{ source, {}, {} };
  while (fan.targets.size() < TargetsASource)
  {
    const Index target = s.mesh->pointOfVertex(s.random() % s.mesh->numberOfVertices());
    if (exact[target] > 0.0)
    {
      fan.targets.push_back(target);
      fan.exact.push_back(exact[target]);
    }
  }
  return fan;
}

enum class Sources
{
  AtVertices,
  InFaces
};

/** Made when first asked for: the truth takes CGAL seconds a source. */
const std::vector<Fan>& fansOf(const std::string& name, Sources sources)
{
  static std::map<std::pair<std::string, Sources>, std::vector<Fan>> known;
  std::vector<Fan>& fans = known[{ name, sources }];
  if (fans.empty())
  {
    Subject& s = pathSubject(name);
    s.random.seed(1);
    for (int i = 0; i < SourcesASurface; ++i)
    {
      const SurfacePoint source = sources == Sources::InFaces
        ? s.pointAt(s.randomPosition())
        : s.mesh->pointAtVertex(s.random() % s.mesh->numberOfVertices());
      fans.push_back(fanFrom(s, source));
    }
  }
  return fans;
}

// Lengths

double quantile(std::vector<double> values, double part)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/** Excess over the exact length, in parts of it. */
struct Excess
{
  void add(double length, double exact) { this->values.push_back(length / exact - 1.0); }
  void report(benchmark::State& state, const std::string& of) const
  {
    state.counters[of + "_least"] = quantile(this->values, 0.0);
    state.counters[of + "_median"] = quantile(this->values, 0.5);
    state.counters[of + "_p95"] = quantile(this->values, 0.95);
    state.counters[of + "_most"] = quantile(this->values, 1.0);
  }

  std::vector<double> values;
};

/** +infinity where there is no path, which no excess hides. */
double lengthBetween(
  FrontSolver& solver, const SurfacePoint& from, const SurfacePoint& to, const PathStyle& style)
{
  const auto path = shortestPath(solver, from, to, {}, style);
  return path ? lengthOf(solver.mesh(), *path) : DistanceField::Unreached;
}

/** All ways of making a path, against the truth and against Dijkstra's. */
void lengths(benchmark::State& state, const std::string& name, Sources sources)
{
  Subject& s = pathSubject(name);
  const TriangleMesh& mesh = *s.mesh;
  DijkstraSolver dijkstra(s.mesh);
  for (auto _ : state)
  {
    Excess straight;
    Excess traced;
    Excess alongEdges;
    std::vector<double> times;
    int straightLonger = 0;
    int tracedLonger = 0;
    for (const Fan& fan : fansOf(name, sources))
    {
      for (std::size_t i = 0; i < TargetsASource; ++i)
      {
        const SurfacePoint target = pointAt(mesh, fan.targets[i]);
        // The field is another one from the other end.
        for (const auto& [from, to] : { std::pair{ fan.source, target }, { target, fan.source } })
        {
          double length = 0.0;
          times.push_back(seconds([&] { length = lengthBetween(s.solver, from, to, Straight); }));
          const double byTrace = lengthBetween(s.solver, from, to, Traced);
          const double byEdges = lengthBetween(dijkstra, from, to, AlongEdges);
          straight.add(length, fan.exact[i]);
          traced.add(byTrace, fan.exact[i]);
          alongEdges.add(byEdges, fan.exact[i]);
          // Sums of many edges differ in their last digits.
          const double bound = byEdges * (1.0 + 1e-13);
          straightLonger += length > bound ? 1 : 0;
          tracedLonger += byTrace > bound ? 1 : 0;
        }
      }
    }
    straight.report(state, "straight");
    traced.report(state, "traced");
    alongEdges.report(state, "edges");
    state.counters["paths"] = static_cast<double>(times.size());
    state.counters["straight_longer"] = straightLonger;
    state.counters["traced_longer"] = tracedLonger;
    state.counters["points"] = mesh.numberOfVertices();
    state.counters["path_ms"] = 1e3 * quantile(times, 0.5);
    state.SetIterationTime(quantile(times, 0.5));
  }
}

/** The largest change of a length, in parts of it, when the surface is scaled. */
void scaled(benchmark::State& state, const std::string& name, double scale)
{
  Subject& s = pathSubject(name);
  Surface surface = s.surface;
  for (Vector3& p : surface.points)
  {
    p = scale * p;
  }
  FastMarchingSolver other(setUp(surface).mesh);
  for (auto _ : state)
  {
    double change = 0.0;
    for (const Fan& fan : fansOf(name, Sources::AtVertices))
    {
      const Index source = s.mesh->pointOfVertex(s.vertexNear(fan.source));
      for (Index target : fan.targets)
      {
        const double length =
          lengthBetween(s.solver, fan.source, pointAt(*s.mesh, target), Straight);
        const double there = lengthBetween(
          other, pointAt(other.mesh(), source), pointAt(other.mesh(), target), Straight);
        change = std::max(change, std::abs(there / scale / length - 1.0));
      }
    }
    state.counters["change"] = change;
    state.SetIterationTime(1.0);
  }
}

// Queries

/** Where a user moves a waypoint to: anywhere in a face at a vertex. */
Vector3 positionBy(Subject& s, Index vertex)
{
  const double part = std::uniform_real_distribution<double>(0.0, 1.0)(s.random);
  return s.mesh->positionOf(
    { s.mesh->pointAtVertex(vertex).triangle, { 0.4, 0.6 * part, 0.6 * (1.0 - part) } });
}

const DistanceField& fieldFrom(
  Subject& s, const Vector3& position, double maximumDistance = DistanceField::Unreached)
{
  const Seed seed = s.seedAt(position);
  SolveOptions options;
  options.maximumDistance = maximumDistance;
  return s.solver.solve({ &seed, 1 }, options);
}

/** Some vertices at the end of a way that is a part of the box's diagonal long, or two edges. */
std::vector<Index> verticesAway(
  Subject& s, const Vector3& position, double partOfDiagonal, std::size_t count)
{
  const Box box = boxOf(*s.mesh);
  const double way =
    std::max(partOfDiagonal * norm(box.high - box.low), 2.0 * s.mesh->longestEdgeLength());
  const DistanceField& field = fieldFrom(s, position, way);
  std::vector<Index> vertices;
  while (vertices.size() < count)
  {
    const Index vertex = field.reached()[s.random() % field.reached().size()];
    if (field.distance(vertex) >= 0.9 * field.largestDistance())
    {
      vertices.push_back(vertex);
    }
  }
  return vertices;
}

/** From position to position, both looked up in the time measured. */
double querySeconds(Subject& s, const Vector3& from, const Vector3& to)
{
  return seconds(
    [&]
    {
      benchmark::DoNotOptimize(
        shortestPath(s.solver, s.pointAt(from), s.pointAt(to), {}, Straight));
    });
}

/** One waypoint moved, to where the way is a part of the box's diagonal long. */
void query(benchmark::State& state, const std::string& name, double part)
{
  constexpr std::size_t moves = 20;
  Subject& s = pathSubject(name);
  for (auto _ : state)
  {
    const Vector3 from = s.randomPosition();
    std::vector<double> times;
    for (Index vertex : verticesAway(s, from, part, moves))
    {
      times.push_back(querySeconds(s, from, positionBy(s, vertex)));
    }
    state.SetIterationTime(quantile(times, 0.5));
    state.counters["query_ms"] = 1e3 * quantile(times, 0.5);
    state.counters["slowest_ms"] = 1e3 * quantile(times, 1.0);
  }
}

/** To the farthest point of all and to a random one, in the time of the whole field. */
void across(benchmark::State& state, const std::string& name)
{
  Subject& s = pathSubject(name);
  for (auto _ : state)
  {
    const Vector3 from = s.randomPosition();
    std::span<const double> distances;
    const double whole = seconds([&] { distances = fieldFrom(s, from).distances(); });
    const auto farthest = std::max_element(distances.begin(), distances.end());
    const Vector3 end = s.mesh->position(static_cast<Index>(farthest - distances.begin()));
    const double time = querySeconds(s, from, end);
    state.SetIterationTime(time);
    state.counters["across_ms"] = 1e3 * time;
    state.counters["solve_ms"] = 1e3 * whole;
    state.counters["ratio"] = time / whole;
    state.counters["random_ratio"] = querySeconds(s, from, s.randomPosition()) / whole;
  }
}

/** The lengths between all pairs of landmarks, anywhere in faces, in the time of the whole field.
 */
void matrix(benchmark::State& state, const std::string& name)
{
  const std::size_t count = areSubjectsTiny() ? 5 : 100;
  Subject& s = subject(name);
  for (auto _ : state)
  {
    std::vector<Vector3> positions;
    std::generate_n(std::back_inserter(positions), count, [&] { return s.randomPosition(); });
    std::vector<SurfacePoint> landmarks;
    for (const std::size_t number : landmarkOrder(positions))
    {
      landmarks.push_back(s.pointAt(positions[number]));
    }
    std::vector<double> solves;
    for (const SurfacePoint& landmark : std::span(landmarks).first(5))
    {
      const Seed seed = Seed::atPoint(landmark);
      solves.push_back(seconds([&] { s.solver.solve({ &seed, 1 }, {}); }));
    }
    const double solve = quantile(solves, 0.5);
    double marches = 0.0;
    double paths = 0.0;
    const SolveOptions options;
    for (std::size_t i = 0; i + 1 < count; ++i)
    {
      PathFinder finder(s.solver, { &landmarks[i], 1 }, options, Straight);
      const auto others = std::span(landmarks).subspan(i + 1);
      marches += seconds([&] { finder.march(others); });
      paths += seconds(
        [&]
        {
          for (const SurfacePoint& other : others)
          {
            benchmark::DoNotOptimize(lengthOf(*s.mesh, *finder.pathFrom(other)));
          }
        });
    }
    state.counters["solve_ms"] = 1e3 * solve;
    state.counters["marches"] = marches / solve;
    state.counters["ratio"] = (marches + paths) / solve;
    state.SetIterationTime(marches + paths);
  }
}

/** CGAL's exact paths, and ours between the same points. */
void exactPath(benchmark::State& state, const std::string& name)
{
  constexpr std::size_t sources = 3;
  Subject& s = pathSubject(name);
  for (auto _ : state)
  {
    std::vector<double> setups;
    std::vector<double> times;
    std::vector<double> ours;
    Excess excess;
    for (const Fan& fan : std::span(fansOf(name, Sources::AtVertices)).first(sources))
    {
      std::unique_ptr<ExactPath> paths;
      const Index source = s.mesh->pointOfVertex(s.vertexNear(fan.source));
      setups.push_back(seconds([&] { paths = std::make_unique<ExactPath>(s.surface, source); }));
      for (std::size_t i = 0; i < TargetsASource; ++i)
      {
        std::vector<Vector3> path;
        times.push_back(seconds([&] { path = paths->to(fan.targets[i]); }));
        double length = 0.0;
        for (std::size_t j = 1; j < path.size(); ++j)
        {
          length += norm(path[j] - path[j - 1]);
        }
        excess.add(length, fan.exact[i]);
        const SurfacePoint target = pointAt(*s.mesh, fan.targets[i]);
        ours.push_back(seconds([&] { lengthBetween(s.solver, fan.source, target, Straight); }));
      }
    }
    excess.report(state, "exact");
    state.counters["setup_ms"] = 1e3 * quantile(setups, 0.5);
    state.counters["path_ms"] = 1e3 * quantile(times, 0.5);
    state.counters["ours_ms"] = 1e3 * quantile(ours, 0.5);
    state.SetIterationTime(quantile(setups, 0.5));
  }
}

// For the peers

template <class Value>
void write(const std::string& file, const std::vector<Value>& values)
{
  std::ofstream stream(file, std::ios::binary);
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  stream.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(Value)));
}

struct Pair
{
  double source;
  double target;
  /** 0 where it is not known. */
  double exact;
};

void writeSurface(
  const std::string& folder, const std::string& name, const std::vector<Pair>& pairs)
{
  const Subject& s = pathSubject(name);
  write(folder + "/" + name + ".points", s.surface.points);
  write(folder + "/" + name + ".triangles", s.surface.triangles);
  write(folder + "/" + name + ".pairs", pairs);
}

std::vector<Pair> pairsOf(const std::string& name)
{
  const Subject& s = pathSubject(name);
  std::vector<Pair> pairs;
  for (const Fan& fan : fansOf(name, Sources::AtVertices))
  {
    const double source = s.mesh->pointOfVertex(s.vertexNear(fan.source));
    for (std::size_t i = 0; i < TargetsASource; ++i)
    {
      pairs.push_back({ source, static_cast<double>(fan.targets[i]), fan.exact[i] });
    }
  }
  return pairs;
}

/** One waypoint stays, the other moves about 5 % of the box's diagonal away from it. */
std::vector<Pair> nearPairsOf(const std::string& name)
{
  Subject& s = pathSubject(name);
  constexpr std::size_t moves = 9;
  s.random.seed(1);
  const Index source = s.random() % s.mesh->numberOfVertices();
  std::vector<Pair> pairs;
  for (Index target : verticesAway(s, s.mesh->position(source), 0.05, moves))
  {
    pairs.push_back({ static_cast<double>(s.mesh->pointOfVertex(source)),
      static_cast<double>(s.mesh->pointOfVertex(target)), 0.0 });
  }
  return pairs;
}

void writeSurfaces(const std::string& folder)
{
  for (const std::string& name : curvedSurfaces())
  {
    writeSurface(folder, name, pairsOf(name));
  }
  for (const std::string& name : largeSurfaces())
  {
    writeSurface(folder, name, nearPairsOf(name));
  }
}

template <class Function, class... Arguments>
benchmark::internal::Benchmark* add(
  const char* what, Function function, const std::string& name, Arguments... arguments)
{
  return benchmark::RegisterBenchmark((std::string(what) + "/" + name).c_str(),
    [=](benchmark::State& state) { function(state, name, arguments...); })
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
}

void addAll()
{
  for (const std::string& name : curvedSurfaces())
  {
    add("Lengths", lengths, name, Sources::AtVertices);
    add("LengthsFromFaces", lengths, name, Sources::InFaces);
    add("ScaledDown", scaled, name, 1e-6);
    add("ScaledUp", scaled, name, 1e6);
    add("Exact", exactPath, name);
  }
  for (const std::string& name : flatSurfaces())
  {
    add("LengthsFromFaces", lengths, name, Sources::InFaces);
  }
  for (const std::string& name : largeSurfaces())
  {
    add("Query1", query, name, 0.01)->Repetitions(7);
    add("Query5", query, name, 0.05)->Repetitions(7);
    add("Across", across, name)->Repetitions(7);
  }
  for (const char* name : { "icosphere 160k", "Delaunay plane 160k", "Bunny 35k" })
  {
    add("Matrix", matrix, name)->Repetitions(3);
  }
}

/** Takes a word that begins like this out of the command line: what follows, none where missing. */
std::optional<std::string> taken(int& argc, char** argv, std::string_view beginning)
{
  char** const end = argv + argc;
  char** const found = std::find_if(
    argv + 1, end, [&](const char* word) { return std::string_view(word).starts_with(beginning); });
  if (found == end)
  {
    return std::nullopt;
  }
  const std::string rest = *found + beginning.size();
  std::copy(found + 1, end, found);
  --argc;
  return rest;
}

}

int main(int argc, char** argv)
{
  if (taken(argc, argv, "--tiny"))
  {
    useTinySubjects();
  }
  const auto folder = taken(argc, argv, "--surfaces=");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  addAll();
  benchmark::RunSpecifiedBenchmarks();
  if (folder)
  {
    writeSurfaces(*folder);
  }
  return 0;
}
