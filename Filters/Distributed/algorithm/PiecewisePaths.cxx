// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/PiecewisePaths.h"

#include "gather/Corridor.h"
#include "gather/InputCutter.h"
#include "pieces/DistributedSurface.h"
#include "solve/Detours.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <memory>
#include <unordered_map>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** A rank searches for so long before all tell whether to go on. */
constexpr std::chrono::milliseconds Turn{ 50 };
/** So many paths are sought on a corridor at most, on so many points of all of them and of each. */
constexpr std::size_t MostOnCorridor = 256;
constexpr std::size_t MostPointsOfCorridor = 65536;
constexpr std::size_t MostPointsOfPath = 16384;

/** The radius of balls along the straight line between two points: a part of its length, which the
 * ellipse of the front has (see PathFinder), and some edges. */
constexpr double PartOfLength = 0.3;
constexpr double EdgesOfRadius = 4.0;
/** Corridors are so wide one after the other. */
constexpr std::array Widths{ 1.0, 3.0 };

std::vector<Ball> ballsAlong(const PointPair& pair, double width)
{
  const Vector3 way = pair.to.position - pair.from.position;
  const double length = norm(way);
  const double edge = std::max(pair.from.longestEdge, pair.to.longestEdge);
  const double radius = width * (PartOfLength * length + EdgesOfRadius * edge);
  const double count = length > 0.0 ? std::ceil(length / radius) : 0.0;
  std::vector<Ball> balls;
  for (double i = 0.0; i <= count; i += 1.0)
  {
    const double part = count > 0.0 ? i / count : 0.0;
    balls.push_back({ pair.from.position + part * way, radius });
  }
  return balls;
}

/** A path on a part of the surface as one for all ranks. @param globalOf of a vertex of the part */
template <class GlobalOf>
GlobalPath globalPathOf(const SurfacePath& path, const GlobalOf& globalOf)
{
  GlobalPath global;
  for (const PathPoint& point : path)
  {
    GlobalPathPoint& added = global.emplace_back(GlobalPathPoint{ {}, point.weights });
    std::transform(point.corners.begin(), point.corners.end(), added.corners.begin(), globalOf);
  }
  return global;
}

template <class GlobalOf>
void take(const PartialSearch::Outcome& outcome, const GlobalOf& globalOf, FoundPath& found)
{
  if (outcome.isKnown)
  {
    found = { true, outcome.path.has_value(), outcome.isProvenShortest, outcome.cost,
      outcome.path ? globalPathOf(*outcome.path, globalOf) : GlobalPath{} };
  }
}

std::vector<Index> unknownOf(std::span<const FoundPath> found)
{
  std::vector<Index> numbers;
  for (Index number = 0; number < found.size(); ++number)
  {
    if (!found[number].isKnown)
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

}

/** Searches on this rank's piece. */
class PiecewisePaths::PieceSearch
{
public:
  explicit PieceSearch(PiecewisePaths& paths)
    : Mesh(paths.Request.mesh)
    , FromBothEnds(paths.FromBothEnds)
    , Incomplete(Mesh.mesh().numberOfVertices())
    , Search(Mesh.sharedMesh(), this->options(paths), paths.Request.style, paths.Request.solver)
  {
  }

  void find(const PointPair& pair, FoundPath& found)
  {
    take(
      this->Search.between(pair.from.local[0], pair.to.local[0], this->FromBothEnds),
      [this](Index vertex) { return this->Mesh.shared().globalOf(vertex); }, found);
  }

private:
  SolveOptions options(PiecewisePaths& paths)
  {
    for (const Index vertex : this->Mesh.shared().vertices())
    {
      this->Incomplete[vertex] = 1;
    }
    SolveOptions options = paths.optionsOn(paths.Request.options);
    options.incomplete = this->Incomplete;
    return options;
  }

  const DividedMesh& Mesh;
  bool FromBothEnds;
  std::vector<std::uint8_t> Incomplete;
  PartialSearch Search;
};

bool PiecewisePaths::suit(const PathRequest& request)
{
  if (request.ranks.size() == 1 || request.gathered || request.whole)
  {
    return false;
  }
  const TriangleMesh& mesh = request.mesh.mesh();
  const std::span<const double> cost = request.options.cost;
  bool jumps = false;
  for (Index vertex = 0; vertex < cost.size() && !jumps; ++vertex)
  {
    const std::span<const RingEntry> ring = mesh.ring(vertex);
    jumps = std::any_of(ring.begin(), ring.end(),
      [&](const RingEntry& entry)
      { return Detours::mayBypass(cost[vertex] / cost[entry.neighbour()]); });
  }
  return !request.ranks.isAny(jumps);
}

PiecewisePaths::PiecewisePaths(const PathRequest& request, bool fromBothEnds)
  : Request(request)
  , FromBothEnds(fromBothEnds)
  , HasCost(request.ranks.isAny(!request.options.cost.empty()))
  , Cutter(request.mesh, request.options)
{
}

std::vector<FoundPath> PiecewisePaths::find(std::span<const PointPair> pairs)
{
  RankGroup& ranks = this->Request.ranks;
  std::vector<FoundPath> found(pairs.size());
  std::vector<double> ranksOfPairs;
  for (const auto& [from, to] : pairs)
  {
    const bool areHere = !from.local.empty() && !to.local.empty();
    ranksOfPairs.push_back(areHere ? ranks.rank() : ranks.size());
  }
  ranks.takeLeast(ranksOfPairs);
  this->findOnPieces(pairs, ranksOfPairs, found);
  gatherOnFirst(ranks, found);
  for (const double width : Widths)
  {
    this->findAcross(pairs, width, found);
  }
  return found;
}

SolveOptions PiecewisePaths::optionsOn(const SolveOptions& part)
{
  SolveOptions options = part;
  options.onProgress = [this](std::size_t steps) { return this->report(steps); };
  options.maximumDistance = this->Request.options.maximumDistance;
  return options;
}

bool PiecewisePaths::report(std::size_t steps)
{
  // A reporter does not tell each time that it has been cancelled.
  this->IsCancelled =
    this->IsCancelled || !this->Request.options.onProgress(this->StepsBefore + steps);
  return !this->IsCancelled;
}

bool PiecewisePaths::allGoOn(double searches)
{
  this->StepsBefore =
    static_cast<std::size_t>(searches * this->Request.mesh.mesh().numberOfVertices());
  return !this->Request.ranks.isAny(!this->report(0));
}

void PiecewisePaths::findOnPieces(std::span<const PointPair> pairs,
  std::span<const double> ranksOfPairs, std::span<FoundPath> found)
{
  RankGroup& ranks = this->Request.ranks;
  std::vector<Index> own;
  double left = 0.0;
  for (Index number = 0; number < pairs.size(); ++number)
  {
    left += ranksOfPairs[number] < ranks.size() ? 1.0 : 0.0;
    if (ranksOfPairs[number] == ranks.rank())
    {
      own.push_back(number);
    }
  }
  std::optional<PieceSearch> search;
  std::size_t done = 0;
  double doneByAll = 0.0;
  while (doneByAll < left && this->allGoOn(doneByAll))
  {
    ranks.together(
      [&]
      {
        const auto end = std::chrono::steady_clock::now() + Turn;
        while (done < own.size() && !this->IsCancelled && std::chrono::steady_clock::now() < end)
        {
          if (!search)
          {
            search.emplace(*this);
          }
          const Index number = own[done++];
          search->find(pairs[number], found[number]);
        }
      });
    doneByAll = ranks.sum(static_cast<double>(done));
  }
}

void PiecewisePaths::findAcross(
  std::span<const PointPair> pairs, double width, std::span<FoundPath> found)
{
  const std::vector<Index> unknown = unknownOf(found);
  const double known = static_cast<double>(found.size() - unknown.size());
  const auto most = static_cast<double>(
    std::min(MostPointsOfCorridor, roomOfCorridor(this->Request.surface.mostPointsOnARank())));
  for (std::size_t i = 0; i < unknown.size(); i += MostOnCorridor)
  {
    const auto numbers =
      std::span(unknown).subspan(i, std::min(MostOnCorridor, unknown.size() - i));
    if (!this->allGoOn(known + static_cast<double>(i)))
    {
      return;
    }
    const std::vector<double> points = this->pointsOfBalls(pairs, numbers, width);
    std::vector<Index> together;
    double sum = 0.0;
    for (std::size_t k = 0; k <= numbers.size(); ++k)
    {
      if (k < numbers.size() && points[k] > std::min(static_cast<double>(MostPointsOfPath), most))
      {
        continue;
      }
      if (!together.empty() && (k == numbers.size() || sum + points[k] > most))
      {
        if (!this->allGoOn(known + static_cast<double>(i + k)))
        {
          return;
        }
        this->findOnCorridor(pairs, together, width, found);
        together.clear();
        sum = 0.0;
      }
      if (k < numbers.size())
      {
        together.push_back(numbers[k]);
        sum += points[k];
      }
    }
  }
  tellAll(this->Request.ranks, found);
}

std::vector<double> PiecewisePaths::pointsOfBalls(
  std::span<const PointPair> pairs, std::span<const Index> numbers, double width)
{
  std::vector<double> own;
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(own),
    [&](Index number)
    {
      return static_cast<double>(
        this->Cutter.count(ballsAlong(pairs[number], width), MostPointsOfPath));
    });
  const std::vector<double> all = this->Request.ranks.gather(own);
  std::vector<double> sums(numbers.size(), 0.0);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    sums[i % sums.size()] += all[i];
  }
  return sums;
}

void PiecewisePaths::findOnCorridor(std::span<const PointPair> pairs,
  std::span<const Index> numbers, double width, std::span<FoundPath> found)
{
  std::vector<Ball> balls;
  for (const Index number : numbers)
  {
    const std::vector<Ball> along = ballsAlong(pairs[number], width);
    balls.insert(balls.end(), along.begin(), along.end());
  }
  RankGroup& ranks = this->Request.ranks;
  const std::vector<SurfacePatch> patches =
    patchesOfAll(ranks, [&] { return this->Cutter.cut(balls, nullptr); });
  if (ranks.rank() > 0)
  {
    return;
  }
  Corridor corridor;
  corridor.add(patches, balls);
  this->LargestCorridor = std::max(this->LargestCorridor, corridor.vertices().size());
  const auto part = std::make_shared<const CorridorMesh>(corridor, this->HasCost);
  const SolveOptions options = this->optionsOn(part->options());
  PartialSearch search({ part, &part->mesh() }, options, this->Request.style, this->Request.solver);
  const auto globalOf = [&](Index vertex) { return part->vertex(vertex).vertex; };
  for (const Index number : numbers)
  {
    if (!this->report(0))
    {
      break;
    }
    const std::array ends{ pairs[number].from, pairs[number].to };
    const std::vector<SurfacePoint> points = part->pointsOf(ends);
    take(search.between(points[0], points[1], this->FromBothEnds), globalOf, found[number]);
  }
}

std::vector<std::optional<TracedPath>> PiecewisePaths::onInput(std::span<const FoundPath> found)
{
  std::vector<GlobalVertex> carriers;
  std::unordered_map<GlobalVertex, Index, HashOfVertex> numbers;
  for (const FoundPath& one : found)
  {
    for (const GlobalPathPoint& point : one.path)
    {
      for (const GlobalVertex& corner : point.corners)
      {
        if (numbers.emplace(corner, static_cast<Index>(carriers.size())).second)
        {
          carriers.push_back(corner);
        }
      }
    }
  }
  RankGroup& ranks = this->Request.ranks;
  carriers = valuesIn<GlobalVertex>(ranks.fromFirst(bytesOf<GlobalVertex>(carriers)));
  InputCutter input(ranks, this->Request.surface, this->Request.input);
  Corridor corridor;
  corridor.add(input.cutOnAll(carriers), {});
  const auto surface = std::make_shared<const CorridorMesh>(corridor, false);
  std::vector<std::optional<TracedPath>> paths(found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (!found[i].hasPath)
    {
      continue;
    }
    TracedPath& traced = paths[i].emplace();
    traced.end = 0;
    traced.cost = found[i].cost;
    traced.isProvenShortest = found[i].isProvenShortest;
    if (ranks.rank() > 0)
    {
      continue;
    }
    traced.corridor = surface;
    for (const GlobalPathPoint& point : found[i].path)
    {
      PathPoint& added = traced.path.emplace_back(PathPoint{ {}, point.weights });
      std::transform(point.corners.begin(), point.corners.end(), added.corners.begin(),
        [&](const GlobalVertex& corner) { return surface->find(corner); });
    }
  }
  return paths;
}

}
