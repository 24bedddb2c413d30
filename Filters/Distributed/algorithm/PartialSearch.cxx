// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/PartialSearch.h"

#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"

#include <algorithm>
#include <utility>

namespace geodesic::distributed
{
namespace
{

std::unique_ptr<DistanceSolver> solverLike(const DistanceSolver& example,
  std::shared_ptr<const TriangleMesh> mesh, const SolveOptions& options, const PathStyle& style)
{
  // See DistributedPathFinder: a path along edges is shortest in a field along edges.
  const bool isAlongEdges = style.order == PathOrder::Vertices && options.cost.empty();
  if (example.crossesFaces() && !isAlongEdges)
  {
    return std::make_unique<FastMarchingSolver>(std::move(mesh));
  }
  return std::make_unique<DijkstraSolver>(std::move(mesh));
}

}

PartialSearch::PartialSearch(std::shared_ptr<const TriangleMesh> mesh, const SolveOptions& options,
  const PathStyle& style, const DistanceSolver& example)
  : Options(options)
  , Style(style)
  , Solver(solverLike(example, std::move(mesh), options, style))
{
  if (!options.cost.empty())
  {
    const auto [least, most] = std::minmax_element(options.cost.begin(), options.cost.end());
    this->LeastCost = *least;
    this->MostCost = *most;
  }
}

PartialSearch::Outcome PartialSearch::between(
  const SurfacePoint& from, const SurfacePoint& to, bool fromBothEnds)
{
  Outcome outcome = this->search(from, to);
  if (!outcome.path)
  {
    return outcome;
  }
  std::reverse(outcome.path->begin(), outcome.path->end());
  if (fromBothEnds && !outcome.isProvenShortest)
  {
    Outcome other = this->search(to, from);
    if (!other.isKnown)
    {
      return other;
    }
    if (other.path && costsLess(other.cost, outcome.cost))
    {
      return other;
    }
  }
  return outcome;
}

bool PartialSearch::isEnough(
  const DistanceField& field, const Outcome& outcome, const Vector3& start) const
{
  // Of a vertex of a face on the path, the distance is at most an edge more than at the path. If
  // one that others have were less, so would be the way by it to the start, but for two edges.
  constexpr double edges = 2.0;
  const double most = outcome.path
    ? outcome.cost + edges * this->MostCost * this->Solver->mesh().longestEdgeLength()
    : DistanceField::Unreached;
  const std::span<const Index> reached = field.reached();
  return std::none_of(reached.begin(), reached.end(),
    [&](Index vertex)
    {
      const Vector3 way = this->Solver->mesh().position(vertex) - start;
      return this->Options.isIncomplete(vertex) &&
        field.distance(vertex) + this->LeastCost * norm(way) <= most;
    });
}

PartialSearch::Outcome PartialSearch::search(const SurfacePoint& end, const SurfacePoint& start)
{
  Outcome outcome;
  try
  {
    PathFinder finder(*this->Solver, { &end, 1 }, this->Options, this->Style);
    // What is prepared of cost and barriers is for later searches as well.
    this->Options.keepsSurface = true;
    outcome.path = finder.march({ &start, 1 }) ? finder.pathFrom(start) : std::nullopt;
    outcome.cost = finder.cost();
    outcome.isProvenShortest = finder.isProvenShortest();
    outcome.isKnown = finder.field().stopReason() != StopReason::Cancelled &&
      this->isEnough(finder.field(), outcome, this->Solver->mesh().positionOf(start));
  }
  catch (const IncompleteRing&)
  {
    outcome = {};
  }
  return outcome;
}

}
