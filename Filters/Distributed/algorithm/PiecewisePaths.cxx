// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/PiecewisePaths.h"

#include "gather/Corridor.h"
#include "gather/InputCutter.h"
#include "pieces/DistributedSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/** So many paths are sought on a corridor at first, and at most. */
constexpr std::size_t FirstOnCorridor = 64;
constexpr std::size_t MostOnCorridor = 1024;

/** The radius of balls along the straight line between two points: a part of its length, which the
 * ellipse of the front has (see PathFinder), and some edges. */
constexpr double PartOfLength = 0.3;
constexpr double EdgesOfRadius = 4.0;
/** Corridors are so wide one after the other. */
constexpr std::array Widths{ 1.0, 3.0 };
/** A line of more balls is longer than what is near. */
constexpr double MostBalls = 64.0;

/** What a rank tells of a path. */
struct FoundHeader
{
  Index number;
  std::uint32_t hasPath;
  std::uint32_t isProvenShortest;
  std::uint32_t numberOfPoints;
  double cost;
};

/** What all ranks know of it. */
struct Known
{
  std::uint8_t isKnown;
  std::uint8_t hasPath;
  std::uint8_t isProvenShortest;
};

std::vector<Ball> ballsAlong(const PointPair& pair, double width)
{
  const Vector3 way = pair.to.position - pair.from.position;
  const double length = norm(way);
  const double edge = std::max(pair.from.longestEdge, pair.to.longestEdge);
  const double radius = width * (PartOfLength * length + EdgesOfRadius * edge);
  const double count = std::min(std::ceil(length / radius), MostBalls);
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
void take(
  const PartialSearch::Outcome& outcome, const GlobalOf& globalOf, PiecewisePaths::Found& found)
{
  if (outcome.isKnown)
  {
    found = { true, outcome.path.has_value(), outcome.isProvenShortest, outcome.cost,
      outcome.path ? globalPathOf(*outcome.path, globalOf) : GlobalPath{} };
  }
}

RankGroup::Message packed(std::span<const PiecewisePaths::Found> found)
{
  RankGroup::Message message;
  for (Index number = 0; number < found.size(); ++number)
  {
    if (const auto& [isKnown, hasPath, isProven, cost, path] = found[number]; isKnown)
    {
      append(message,
        FoundHeader{ number, hasPath ? 1u : 0u, isProven ? 1u : 0u,
          static_cast<std::uint32_t>(path.size()), cost });
      const RankGroup::Message points = bytesOf<GlobalPathPoint>(path);
      message.insert(message.end(), points.begin(), points.end());
    }
  }
  return message;
}

void unpack(const RankGroup::Message& message, std::span<PiecewisePaths::Found> found)
{
  for (const char* at = message.data(); at < message.data() + message.size();)
  {
    FoundHeader header;
    std::memcpy(&header, at, sizeof(header));
    at += sizeof(header);
    GlobalPath path(header.numberOfPoints);
    std::memcpy(path.data(), at, path.size() * sizeof(GlobalPathPoint));
    at += path.size() * sizeof(GlobalPathPoint);
    found[header.number] = { true, header.hasPath != 0, header.isProvenShortest != 0, header.cost,
      std::move(path) };
  }
}

std::vector<Index> unknownOf(std::span<const PiecewisePaths::Found> found)
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

PiecewisePaths::PiecewisePaths(const PathRequest& request, bool fromBothEnds, IsAborted isAborted)
  : Request(request)
  , FromBothEnds(fromBothEnds)
  , IsAbortedNow(std::move(isAborted))
  , HasCost(request.ranks.isAny(!request.options.cost.empty()))
  , Cutter(request.mesh, request.options)
{
}

std::vector<PiecewisePaths::Found> PiecewisePaths::find(std::span<const PointPair> pairs)
{
  RankGroup& ranks = this->Request.ranks;
  std::vector<Found> found(pairs.size());
  std::vector<double> ranksOfPairs;
  for (const auto& [from, to] : pairs)
  {
    const bool areHere = !from.local.empty() && !to.local.empty();
    ranksOfPairs.push_back(areHere ? ranks.rank() : ranks.size());
  }
  ranks.takeLeast(ranksOfPairs);
  ranks.together([&] { this->findOnPiece(pairs, ranksOfPairs, found); });
  for (const RankGroup::Message& message : ranks.toFirst(packed(found)))
  {
    unpack(message, found);
  }
  this->tellAll(found);
  for (const double width : Widths)
  {
    this->findAcross(pairs, width, found);
  }
  return found;
}

SolveOptions PiecewisePaths::optionsOn(const SolveOptions& part) const
{
  SolveOptions options = part;
  options.onProgress = [this](std::size_t steps)
  { return this->Request.options.onProgress(this->StepsBefore + steps); };
  options.maximumDistance = this->Request.options.maximumDistance;
  return options;
}

bool PiecewisePaths::begins(Index number)
{
  this->StepsBefore = std::size_t{ number } * this->Request.mesh.mesh().numberOfVertices();
  return this->Request.options.onProgress(this->StepsBefore);
}

void PiecewisePaths::findOnPiece(
  std::span<const PointPair> pairs, std::span<const double> ranksOfPairs, std::span<Found> found)
{
  const double own = this->Request.ranks.rank();
  if (std::find(ranksOfPairs.begin(), ranksOfPairs.end(), own) == ranksOfPairs.end())
  {
    return;
  }
  const DividedMesh& mesh = this->Request.mesh;
  std::vector<std::uint8_t> incomplete(mesh.mesh().numberOfVertices());
  for (const Index vertex : mesh.shared().vertices())
  {
    incomplete[vertex] = 1;
  }
  SolveOptions options = this->optionsOn(this->Request.options);
  options.incomplete = incomplete;
  PartialSearch search(mesh.sharedMesh(), options, this->Request.style, this->Request.solver);
  const auto globalOf = [&](Index vertex) { return mesh.shared().globalOf(vertex); };
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (ranksOfPairs[i] == own)
    {
      if (!this->begins(static_cast<Index>(i)))
      {
        return;
      }
      take(search.between(pairs[i].from.local[0], pairs[i].to.local[0], this->FromBothEnds),
        globalOf, found[i]);
    }
  }
}

void PiecewisePaths::findAcross(
  std::span<const PointPair> pairs, double width, std::span<Found> found)
{
  const std::vector<Index> unknown = unknownOf(found);
  std::size_t together = FirstOnCorridor;
  for (std::size_t i = 0; i < unknown.size() && !this->IsAbortedNow();)
  {
    const std::size_t count = std::min(together, unknown.size() - i);
    if (this->findOnCorridor(pairs, std::span(unknown).subspan(i, count), width, found))
    {
      i += count;
      together = std::min(2 * together, MostOnCorridor);
    }
    else
    {
      together = (count + 1) / 2;
    }
  }
  this->tellAll(found);
}

bool PiecewisePaths::findOnCorridor(std::span<const PointPair> pairs,
  std::span<const Index> numbers, double width, std::span<Found> found)
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
  Corridor corridor;
  if (ranks.rank() == 0)
  {
    corridor.add(patches, balls);
  }
  const bool isTooLarge =
    corridor.vertices().size() > roomOfCorridor(this->Request.surface.mostPointsOnARank());
  if (ranks.isAny(isTooLarge))
  {
    // Even a single path may be longer than what is near.
    return numbers.size() == 1;
  }
  if (ranks.rank() > 0)
  {
    return true;
  }
  this->LargestCorridor = std::max(this->LargestCorridor, corridor.vertices().size());
  const auto part = std::make_shared<const CorridorMesh>(corridor, this->HasCost);
  const SolveOptions options = this->optionsOn(part->options());
  PartialSearch search({ part, &part->mesh() }, options, this->Request.style, this->Request.solver);
  const auto globalOf = [&](Index vertex) { return part->vertex(vertex).vertex; };
  for (const Index number : numbers)
  {
    if (!this->begins(number))
    {
      break;
    }
    const std::array ends{ pairs[number].from, pairs[number].to };
    const std::vector<SurfacePoint> points = part->pointsOf(ends);
    take(search.between(points[0], points[1], this->FromBothEnds), globalOf, found[number]);
  }
  return true;
}

void PiecewisePaths::tellAll(std::span<Found> found)
{
  RankGroup& ranks = this->Request.ranks;
  std::vector<Known> known(found.size());
  std::transform(found.begin(), found.end(), known.begin(),
    [](const Found& one)
    {
      const auto flag = [](bool isSet) { return static_cast<std::uint8_t>(isSet ? 1 : 0); };
      return Known{ flag(one.isKnown), flag(one.hasPath), flag(one.isProvenShortest) };
    });
  known = valuesIn<Known>(ranks.fromFirst(bytesOf<Known>(known)));
  for (std::size_t i = 0; i < found.size() && ranks.rank() > 0; ++i)
  {
    found[i] = { known[i].isKnown != 0, known[i].hasPath != 0, known[i].isProvenShortest != 0, 0.0,
      {} };
  }
}

std::vector<std::optional<TracedPath>> PiecewisePaths::onInput(std::span<const Found> found)
{
  std::vector<GlobalVertex> carriers;
  std::unordered_map<GlobalVertex, Index, HashOfVertex> numbers;
  for (const Found& one : found)
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
