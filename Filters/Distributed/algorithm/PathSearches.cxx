// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/PathSearches.h"

#include "base/SharedJobs.h"
#include "mesh/CurveOrder.h"
#include "mesh/TriangleMesh.h"
#include "methods/SolverTeam.h"
#include "path/PathFinder.h"
#include "solve/DijkstraSolver.h"
#include "solve/SolvedField.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** From so many paths on, several ranks seek them piece by piece. Fewer are those of one rank also
 * where two ways are equally long. */
constexpr std::size_t LeastPaths = 16;

/** On several ranks paths from so many starts are found before it is asked whether to go on. */
constexpr std::size_t StartsTogether = 4096;

}

PathSearches::PathSearches(const PathRequest& request, SolverTeam& solvers, IsAborted isAborted)
  : Request(request)
  , Solvers(solvers)
  , IsAbortedNow(std::move(isAborted))
{
}

PathRequest PathSearches::withSolver(DistanceSolver& solver) const
{
  const PathRequest& own = this->Request;
  return { own.ranks, own.surface, own.gathered, own.split, own.mesh, solver, own.options,
    own.style, own.input, own.whole };
}

std::vector<bool> PathSearches::run(std::size_t count, const Search& search)
{
  if (this->Request.ranks.size() > 1)
  {
    return this->runTogether(count, search);
  }
  if (this->IsAbortedNow())
  {
    return std::vector<bool>(count, false);
  }
  const std::size_t threads = this->Solvers.numberOfThreads();
  SharedJobs jobs(threads, this->Solvers.stepsToMakeOne(), this->Solvers.mesh().numberOfVertices(),
    this->Request.options.onProgress);
  // Cost and barriers are those of all searches.
  std::vector<std::uint8_t> haveMarched(threads);
  return jobs.run(count,
    [&](const SharedJobs::Turn& turn)
    {
      PathRequest own = this->withSolver(this->Solvers.ofThread(turn.thread));
      own.options.keepsSurface = std::exchange(haveMarched[turn.thread], 0) != 0;
      bool isAborted = false;
      own.options.onProgress = [&](std::size_t steps)
      {
        isAborted = !turn.onProgress(steps);
        return !isAborted;
      };
      if (turn.isShared)
      {
        own.options.memoryLimit = this->Solvers.memoryOfEach(own.options.memoryLimit);
      }
      try
      {
        search(turn.number, own, [&] { return isAborted; });
        haveMarched[turn.thread] = isAborted ? 0 : 1;
      }
      catch (...)
      {
        this->Solvers.renew(turn.thread);
        throw;
      }
    });
}

std::vector<bool> PathSearches::runTogether(std::size_t count, const Search& search)
{
  std::vector<bool> areMade(count, false);
  for (std::size_t number = 0; number < count && !this->IsAbortedNow(); ++number)
  {
    PathRequest own = this->withSolver(this->Solvers.first());
    const std::size_t before = number * own.solver.mesh().numberOfVertices();
    own.options.onProgress = [&](std::size_t steps)
    { return this->Request.options.onProgress(before + steps); };
    search(number, own, this->IsAbortedNow);
    areMade[number] = !this->IsAbortedNow();
  }
  return areMade;
}

std::optional<TracedPath> PathSearches::between(
  const PathRequest& request, const GlobalPoint& from, const GlobalPoint& to, bool fromBothEnds)
{
  std::size_t steps = 0;
  const auto search = [&](const GlobalPoint& end, const GlobalPoint& start)
  {
    PathRequest own = request;
    const std::size_t before = steps;
    own.options.onProgress = [&](std::size_t more)
    {
      steps = before + more;
      return request.options.onProgress(steps);
    };
    DistributedPathFinder finder(own, { end });
    auto path = finder.march({ &start, 1 }) ? finder.pathFrom(start) : std::nullopt;
    this->count(finder);
    return path;
  };
  auto path = search(from, to);
  if (!path)
  {
    return std::nullopt;
  }
  std::reverse(path->path.begin(), path->path.end());
  if (fromBothEnds && !path->isProvenShortest)
  {
    auto other = search(to, from);
    if (other && costsLess(other->cost, path->cost))
    {
      other->end = path->end;
      path = std::move(other);
    }
  }
  return path;
}

std::vector<PathSearches::Outcome> PathSearches::betweenAll(
  std::span<const PointPair> pairs, bool fromBothEnds)
{
  std::vector<Outcome> outcomes(pairs.size());
  if (pairs.size() >= LeastPaths && PiecewisePaths::suit(this->Request))
  {
    this->findPiecewise(pairs, fromBothEnds, outcomes);
  }
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (!outcomes[i].isMade)
    {
      left.push_back(i);
    }
  }
  const std::vector<bool> areMade = this->run(left.size(),
    [&](std::size_t number, const PathRequest& request, const IsAborted&)
    {
      const auto& [from, to] = pairs[left[number]];
      outcomes[left[number]].path = this->between(request, from, to, fromBothEnds);
    });
  for (std::size_t number = 0; number < left.size(); ++number)
  {
    outcomes[left[number]].isMade = areMade[number];
  }
  return outcomes;
}

void PathSearches::findPiecewise(
  std::span<const PointPair> pairs, bool fromBothEnds, std::span<Outcome> outcomes)
{
  PiecewisePaths search(this->Request, fromBothEnds);
  const std::vector<FoundPath> found = search.find(pairs);
  if (this->IsAbortedNow())
  {
    return;
  }
  std::vector<std::optional<TracedPath>> paths = search.onInput(found);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    outcomes[i] = { found[i].isKnown, std::move(paths[i]) };
  }
  this->LargestCorridor = std::max(this->LargestCorridor, search.largestCorridor());
}

std::vector<PathSearches::Outcome> PathSearches::fromStarts(
  std::span<const GlobalPoint> starts, const std::vector<GlobalPoint>& ends)
{
  std::vector<Outcome> found(starts.size());
  const std::vector<std::size_t> order = this->orderOf(starts);
  std::vector<GlobalPoint> ordered;
  std::transform(order.begin(), order.end(), std::back_inserter(ordered),
    [&](std::size_t i) { return starts[i]; });
  std::vector<Outcome> foundInOrder(starts.size());
  this->findFromStarts(ordered, ends, foundInOrder);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    found[order[i]] = std::move(foundInOrder[i]);
  }
  return found;
}

std::vector<std::size_t> PathSearches::orderOf(std::span<const GlobalPoint> starts)
{
  if (this->Request.ranks.size() > 1)
  {
    std::vector<Vector3> positions;
    std::transform(starts.begin(), starts.end(), std::back_inserter(positions),
      [](const GlobalPoint& start) { return start.position; });
    const std::vector<Index> order = orderAlongCurve(positions);
    return { order.begin(), order.end() };
  }
  std::vector<SurfacePoint> points;
  std::transform(starts.begin(), starts.end(), std::back_inserter(points),
    [](const GlobalPoint& start) { return start.local[0]; });
  return orderInMemory(this->Solvers.first().mesh(), points);
}

void PathSearches::findFromStarts(std::span<const GlobalPoint> starts,
  const std::vector<GlobalPoint>& ends, std::vector<Outcome>& found)
{
  std::size_t stepsOfMarch = 0;
  PathRequest own = this->withSolver(this->Solvers.first());
  own.options.onProgress = [&](std::size_t steps)
  {
    stepsOfMarch = std::max(stepsOfMarch, steps);
    return this->Request.options.onProgress(steps);
  };
  DistributedPathFinder finder(own, ends);
  if (!finder.march(starts))
  {
    return;
  }
  if (this->Request.ranks.size() == 1 && own.style.order == PathOrder::Vertices &&
    own.options.cost.empty() && own.solver.crossesFaces())
  {
    this->findAlongEdges(starts, ends, finder, own, found);
  }
  if (this->Request.ranks.size() == 1 && this->Solvers.numberOfThreads() > 1)
  {
    this->shareStarts(starts, ends, finder.fieldOfOneRank(), stepsOfMarch, found);
  }
  const std::size_t together = this->Request.ranks.size() == 1 ? 1 : StartsTogether;
  for (std::size_t i = 0; i < starts.size() && !this->IsAbortedNow(); i += together)
  {
    if (found[i].isMade)
    {
      continue;
    }
    auto paths = finder.pathsFrom(starts.subspan(i, std::min(together, starts.size() - i)));
    const bool areMade = !this->IsAbortedNow();
    for (std::size_t k = 0; k < paths.size(); ++k)
    {
      found[i + k] = { areMade, std::move(paths[k]) };
    }
  }
  this->count(finder);
}

void PathSearches::findAlongEdges(std::span<const GlobalPoint> starts,
  const std::vector<GlobalPoint>& ends, const DistributedPathFinder& finder,
  const PathRequest& request, std::vector<Outcome>& found)
{
  // Fewer are found sooner in the field across faces, which each searches for itself.
  constexpr std::size_t leastStarts = 8;
  std::vector<std::vector<std::size_t>> startsOfEnds(ends.size());
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    if (const Index end = finder.nearestEndOnOneRank(starts[i]); end != NoIndex)
    {
      startsOfEnds[end].push_back(i);
    }
  }
  DijkstraSolver solver(this->Request.mesh.sharedMesh());
  PathRequest own = this->withSolver(solver);
  own.options = request.options;
  for (Index end = 0; end < ends.size() && !this->IsAbortedNow(); ++end)
  {
    const std::vector<std::size_t>& numbers = startsOfEnds[end];
    if (numbers.size() < leastStarts)
    {
      continue;
    }
    std::vector<GlobalPoint> startsOfEnd;
    std::transform(numbers.begin(), numbers.end(), std::back_inserter(startsOfEnd),
      [&](std::size_t i) { return starts[i]; });
    DistributedPathFinder alongEdges(own, { ends[end] });
    // Barriers are those of all ends.
    own.options.keepsSurface = alongEdges.march(startsOfEnd);
    for (std::size_t k = 0; k < numbers.size() && own.options.keepsSurface; ++k)
    {
      auto path = alongEdges.pathFrom(startsOfEnd[k]);
      if (path)
      {
        path->end = end;
      }
      found[numbers[k]] = { !this->IsAbortedNow(), std::move(path) };
    }
  }
}

void PathSearches::shareStarts(std::span<const GlobalPoint> starts,
  const std::vector<GlobalPoint>& ends, const DistanceField& field, std::size_t stepsOfMarch,
  std::vector<Outcome>& found)
{
  // A search from one start takes far longer than as many steps of a march.
  constexpr std::size_t stepsOfStart = 256;
  constexpr std::size_t stepsAlone = 4096;
  constexpr std::size_t chunksOfThread = 16;
  const std::size_t threads = this->Solvers.numberOfThreads();
  const std::size_t size = std::max<std::size_t>(starts.size() / (threads * chunksOfThread), 1);
  SharedJobs jobs(threads, stepsAlone, size * stepsOfStart,
    [&](std::size_t steps) { return this->Request.options.onProgress(stepsOfMarch + steps); });
  jobs.run((starts.size() + size - 1) / size,
    [&](const SharedJobs::Turn& turn)
    {
      const std::size_t first = turn.number * size;
      const auto chunk = starts.subspan(first, std::min(size, starts.size() - first));
      bool isAborted = false;
      SolvedField solved(this->Solvers.first(), field);
      PathRequest own = this->withSolver(solved);
      own.options.onProgress = [&](std::size_t steps)
      {
        isAborted = !turn.onProgress(steps);
        return !isAborted;
      };
      DistributedPathFinder finder(own, ends);
      if (!finder.march(chunk))
      {
        return;
      }
      for (std::size_t i = 0; i < chunk.size() && !isAborted; ++i)
      {
        if (found[first + i].isMade)
        {
          continue;
        }
        try
        {
          found[first + i].path = finder.pathFrom(chunk[i]);
          found[first + i].isMade = !isAborted;
        }
        catch (const FieldTooSmall&)
        {
          // The caller finds this path with the solver itself.
        }
      }
    });
}

void PathSearches::count(const DistributedPathFinder& finder)
{
  // On one rank, where several threads may call this, there are no corridors.
  if (this->Request.ranks.size() > 1)
  {
    this->LargestCorridor = std::max(this->LargestCorridor, finder.largestCorridor());
  }
}

vtkIdType PathSearches::mostPointsOnARank()
{
  const std::size_t own = this->Request.mesh.mesh().numberOfPoints() + this->LargestCorridor;
  return static_cast<vtkIdType>(this->Request.ranks.largest(static_cast<double>(own)));
}

}
