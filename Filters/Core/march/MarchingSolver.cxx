// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/MarchingSolver.h"

#include "march/LabelDensity.h"
#include "march/LabelReach.h"
#include "mesh/TriangleMesh.h"
#include "solve/CostedStart.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** The largest distance of a field on all pieces. Collective. */
double farthestOf(const DistanceField& field, Partition& partition)
{
  double farthest = 0.0;
  for (const Index vertex : field.reached())
  {
    farthest = std::max(farthest, field.distance(vertex));
  }
  const std::vector<double> all = partition.gather({ &farthest, 1 });
  return *std::max_element(all.begin(), all.end());
}

/** Gives a vertex the seed of the neighbour through which it is nearest, if any has a seed.
 * @return whether it now has one */
bool takeSeedOfNeighbour(const TriangleMesh& mesh, Index vertex, DistanceField& field)
{
  double least = DistanceField::Unreached;
  for (const RingEntry& entry : mesh.ring(vertex))
  {
    const Index neighbour = entry.neighbour();
    const double way =
      field.distance(neighbour) + norm(mesh.position(neighbour) - mesh.position(vertex));
    if (field.nearestSeed(neighbour) != NoIndex && way < least)
    {
      least = way;
      field.setNearestSeed(vertex, field.nearestSeed(neighbour));
    }
  }
  return least < DistanceField::Unreached;
}

/** Takes over the seeds that other pieces found for vertices without one. Collective.
 * @return whether any piece found one since the last call */
bool takeSeedsOfOthers(bool foundOne, Partition& partition, DistanceField& field)
{
  std::vector<StartValue> own;
  for (const Index vertex : partition.sharedVertices())
  {
    if (field.nearestSeed(vertex) != NoIndex)
    {
      own.push_back({ vertex, field.nearestSeed(vertex), 0.0, false });
    }
  }
  for (const StartValue& other : partition.exchange(own))
  {
    if (field.isReached(other.vertex))
    {
      field.setNearestSeed(other.vertex, std::min(field.nearestSeed(other.vertex), other.label));
    }
  }
  const double found = foundOne ? 1.0 : 0.0;
  const std::vector<double> all = partition.gather({ &found, 1 });
  return *std::max_element(all.begin(), all.end()) > 0.0;
}

/**
 * Gives vertices the distance in the first march where that is less: a label that others bounded
 * may have come by a detour. Those that no label reached within the bounds also get a seed of a
 * neighbour. Collective.
 */
void takeFirstMarch(
  const TriangleMesh& mesh, const LabelBounds& bounds, Partition& partition, DistanceField& field)
{
  std::vector<Index> gaps;
  for (const Index vertex : bounds.reached())
  {
    if (!field.isReached(vertex))
    {
      gaps.push_back(vertex);
    }
    else if (bounds.first(vertex) < field.distance(vertex))
    {
      field.setDistance(vertex, bounds.first(vertex));
    }
  }
  std::sort(
    gaps.begin(), gaps.end(), [&](Index a, Index b) { return bounds.first(a) < bounds.first(b); });
  for (const Index vertex : gaps)
  {
    field.setDistance(vertex, bounds.first(vertex));
  }
  bool foundOne = !gaps.empty();
  while (takeSeedsOfOthers(foundOne, partition, field))
  {
    foundOne = false;
    for (const Index vertex : gaps)
    {
      foundOne |= field.nearestSeed(vertex) == NoIndex && takeSeedOfNeighbour(mesh, vertex, field);
    }
  }
}

}

MarchingSolver::MarchingSolver(
  std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds)
  : FrontSolver(std::move(mesh))
  , Bounds(std::move(bounds))
{
}

bool MarchingSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const AgreedMargins margins(*this->Bounds, request.front.labels.size(), request.partition);
  if (!request.hasCost)
  {
    const UnitCost cost(this->mesh(), margins.ofVertices(), request.partition);
    const auto starts = unitStarts(request.front, request.partition);
    return this->marchAtCost(starts, cost, request, limit, field);
  }
  if (!this->DiscSolver)
  {
    this->DiscSolver = this->another();
  }
  const VertexCost cost(
    this->mesh(), request.options.cost, margins.ofVertices(), request.partition);
  const auto starts = costedStarts(
    this->mesh(), request.front, request.options, request.partition, *this->DiscSolver);
  return this->marchAtCost(starts, cost, request, limit, field);
}

template <class Cost>
bool MarchingSolver::marchAtCost(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  if (!labelsAreDense(this->mesh(), request.front, request.partition))
  {
    return this->marchFrom(starts, cost, request, nullptr, limit, field);
  }
  // The second march counts its steps on from those of the first one.
  std::size_t steps = 0;
  SolveOptions options = request.options;
  if (options.onProgress)
  {
    options.onProgress = [&](std::size_t taken)
    {
      steps = taken;
      return request.options.onProgress(taken);
    };
  }
  this->Dense.begin(this->mesh(), request.front.labels, starts, request.partition);
  const SeedFront together{ { { 0, FrontShape::Straight, 0.0, {}, {} } }, {} };
  StopLimit firstLimit(options, field);
  const Request first{ together, request.closed, options, request.partition, request.hasCost };
  bool finished = this->marchFrom(this->Dense.starts(), cost, first, nullptr, firstLimit, field);
  if (finished)
  {
    const double farthest = farthestOf(field, request.partition);
    this->Dense.take(field, [&](Index vertex) { return cost.reach(vertex); });
    this->Dense.setLabels(
      labelReaches(this->mesh(), request.front, request.options.cost, farthest, request.partition));
    field.reset();
    if (options.onProgress)
    {
      options.onProgress = [&](std::size_t taken)
      { return request.options.onProgress(steps + taken); };
    }
    const Request second{ request.front, request.closed, options, request.partition,
      request.hasCost };
    finished = this->marchFrom(this->Dense.within(this->mesh(), request.front.labels, starts), cost,
      second, &this->Dense, limit, field);
    takeFirstMarch(this->mesh(), this->Dense, request.partition, field);
  }
  this->Dense.clear();
  return finished;
}

}
