// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trial.h"

#include "WorstSeeds.h"
#include "march/IntrinsicMarchingSolver.h"
#include "mesh/ThinTriangles.h"
#include "methods/SolverTable.h"

#include <algorithm>

namespace geodesic::testing
{
namespace
{

/** Runs of what is measured several times. */
constexpr Index Runs = 5;
/** Seconds; what takes longer is run once. */
constexpr double Short = 2.0;

double medianOf(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

std::vector<Index> someVertices(const TriangleMesh& mesh)
{
  std::mt19937 random(2);
  return randomVertices(mesh, Runs, random);
}

template <class Solve>
double medianFrom(const std::vector<Index>& sources, Solve solve)
{
  std::vector<double> times;
  for (Index source : sources)
  {
    times.push_back(seconds([&] { solve(source); }));
  }
  return medianOf(times);
}

/** What a run's reports of progress tell. */
class ProgressMeter
{
public:
  ProgressMeter()
    : Last(processorSeconds())
  {
  }

  bool report(std::size_t count)
  {
    this->Updates = count;
    const double now = processorSeconds();
    this->Silence = std::max(this->Silence, now - this->Last);
    this->Last = now;
    return true;
  }
  std::size_t updates() const { return this->Updates; }
  double silence() const { return std::max(this->Silence, processorSeconds() - this->Last); }

private:
  double Last;
  double Silence = 0.0;
  std::size_t Updates = 0;
};

}

Trial::Trial(const Surface& surface, const std::string& method)
  : Made(setUp(surface))
  , Solver(solverOfName(method).make(this->Made.mesh))
  , NeedsOthers(countThinTriangles(*this->Made.mesh).needOthers())
  , Random(1)
{
}

double Trial::secondsOfOneSeed()
{
  const auto solve = [&](Index source)
  {
    const Seed seed = Seed::atPoint(this->mesh().pointAtVertex(source));
    this->Solver->solve({ &seed, 1 }, this->asUsersRun({ &seed, 1 }, {}));
  };
  const std::vector<Index> sources = someVertices(this->mesh());
  // The first run is not warm.
  solve(sources.front());
  return medianFrom(sources, solve);
}

SolveOptions Trial::asUsersRun(std::span<const Seed> seeds, SolveOptions options) const
{
  options.isIntrinsic =
    this->NeedsOthers && IntrinsicMarchingSolver::canMarchIntrinsically(seeds, options);
  return options;
}

double Trial::secondsOfDijkstra(std::span<const double> cost) const
{
  HeapDijkstra dijkstra(this->mesh(), cost);
  return medianFrom(someVertices(this->mesh()), [&](Index source) { dijkstra.solve(source); });
}

RunCost Trial::solve(const std::vector<Seed>& seeds, const SolveOptions& options)
{
  std::size_t reached = 0;
  RunCost cost = this->run([&](const SolveOptions& watched)
    { reached = this->Solver->solve(seeds, watched).reached().size(); },
    this->asUsersRun(seeds, options));
  cost.reached = reached;
  return cost;
}

RunCost Trial::run(
  const std::function<void(const SolveOptions&)>& work, const SolveOptions& options)
{
  RunCost cost;
  std::vector<double> times;
  do
  {
    ProgressMeter meter;
    SolveOptions watched = options;
    watched.progressInterval = 256;
    watched.onProgress = [&](std::size_t count) { return meter.report(count); };
    times.push_back(seconds([&] { work(watched); }));
    cost.silence = std::max(cost.silence, meter.silence());
    cost.updates = meter.updates();
  } while (times.front() < Short && times.size() < Runs);
  cost.seconds = medianOf(times);
  return cost;
}

}
