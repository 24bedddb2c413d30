// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/LineBounds.h"

#include "base/SortUnique.h"
#include "march/EdgeLowering.h"
#include "march/HubVertices.h"
#include "march/LabelDensity.h"
#include "march/StraightLines.h"
#include "mesh/TriangleMesh.h"
#include "solve/OptionsOfMarches.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace geodesic
{
namespace
{

/** How much the distances that count may exceed the least straight line: parts of it and of the
 * reach. On a hilly grid distances are 2 % more than lines in the mean. */
constexpr double PartOfLine = 1.04;
constexpr double PartOfReach = 0.5;
/** Where more of all vertices have a bound that was too low, another march takes less. */
constexpr double MostRaised = 0.35;

/** The reached ones of some vertices and their neighbours, each once. */
std::vector<Index> reachedBeside(
  const TriangleMesh& mesh, std::span<const Index> vertices, const DistanceField& field)
{
  std::vector<std::uint8_t> areKnown(mesh.numberOfVertices());
  std::vector<Index> beside;
  const auto add = [&](Index vertex)
  {
    if (areKnown[vertex] == 0 && field.isReached(vertex))
    {
      areKnown[vertex] = 1;
      beside.push_back(vertex);
    }
  };
  for (const Index vertex : vertices)
  {
    add(vertex);
    for (const RingEntry& entry : mesh.ring(vertex))
    {
      add(entry.neighbour());
    }
  }
  return beside;
}

}

bool LineBounds::suit(const TriangleMesh& mesh, const SeedFront& front, Partition& partition)
{
  const std::vector<Label>& labels = front.labels;
  const bool areAlike = std::all_of(labels.begin(), labels.end(),
    [&](const Label& label)
    { return label.shape == FrontShape::Round && label.value == labels[0].value; });
  const bool areApart =
    std::adjacent_find(labels.begin(), labels.end(),
      [](const Label& a, const Label& b) { return a.seed == b.seed; }) == labels.end();
  return areAlike && areApart && !mesh.isIntrinsic() && labelsHaveRoom(mesh, front, partition) &&
    labelsAreSpread(mesh, front, 0.0, partition) && !hasHubs(mesh, partition);
}

bool LineBounds::set(std::span<const StartValue> starts)
{
  const auto& [mesh, closed, options, partition, front, cost, limit] = this->On;
  this->SeedValue = front.labels[0].value;
  std::vector<Vector3> places(front.labels.size());
  std::transform(front.labels.begin(), front.labels.end(), places.begin(),
    [](const Label& label) { return label.position; });
  const std::span<double> bounds =
    this->Bounds.startOfAll(mesh.numberOfVertices(), front.labels.size());
  squareLeastLines(mesh, places, bounds);
  double farthest = 0.0;
  for (Index vertex = 0; vertex < bounds.size(); ++vertex)
  {
    const double line = std::sqrt(bounds[vertex]);
    farthest = std::max(farthest, line);
    bounds[vertex] = this->SeedValue + PartOfLine * line + PartOfReach * cost.reach(vertex);
  }
  const std::vector<double> all = partition.gather({ &farthest, 1 });
  if (!labelsAreSpread(mesh, front, *std::max_element(all.begin(), all.end()), partition))
  {
    this->Bounds.clear();
    return false;
  }
  // The nearest seed in space may be on another sheet.
  for (const StartValue& start : starts)
  {
    constexpr double rounding = 1.0 + 1e-9;
    bounds[start.vertex] =
      std::max(bounds[start.vertex], rounding * (this->SeedValue + start.value));
  }
  std::vector<StartValue> shared;
  for (const Index vertex : partition.sharedVertices())
  {
    shared.push_back({ vertex, 0, bounds[vertex], false });
  }
  for (const StartValue& other : partition.exchange(shared))
  {
    bounds[other.vertex] = std::max(bounds[other.vertex], other.value);
  }
  return true;
}

double LineBounds::excess(Index vertex, double distance) const
{
  return LabelBounds::excess(this->On.cost.reach(vertex), distance - this->SeedValue);
}

std::vector<Index> LineBounds::lowIn(const DistanceField& field) const
{
  const StopLimit& limit = this->On.limit;
  std::vector<Index> low;
  for (Index vertex = 0; vertex < this->On.mesh.numberOfVertices(); ++vertex)
  {
    const double bound = this->Bounds.ofVertex(vertex);
    const double distance = field.distance(vertex);
    const bool isLow = !(distance + this->excess(vertex, distance) <= bound);
    // What is beyond the limit does not count anyway.
    if (isLow && (!limit.isPossible() || bound < limit.with(vertex)))
    {
      low.push_back(vertex);
    }
  }
  return low;
}

bool LineBounds::findWays(
  const DistanceField& field, std::span<const Index> low, DistanceField& ways) const
{
  this->On.options.beginNext();
  const SolveOptions& options = this->On.options.get();
  StopLimit limit(this->On.mesh, options, ways);
  limit.setReaches(this->On.limit.reaches());
  return lowerAlongEdges(this->On.mesh, this->On.closed, options,
    reachedBeside(this->On.mesh, low, field), this->On.partition, limit, ways);
}

std::vector<Index> LineBounds::raiseTo(const DistanceField& ways, std::span<const Index> low)
{
  Partition& partition = this->On.partition;
  std::vector<Index> raised;
  const auto raise = [&](Index vertex, double bound)
  {
    if (bound > this->Bounds.ofVertex(vertex))
    {
      this->Bounds.setOfVertex(vertex, bound);
      raised.push_back(vertex);
    }
  };
  for (const Index vertex : low)
  {
    if (ways.isReached(vertex))
    {
      raise(vertex, ways.distance(vertex) + this->excess(vertex, ways.distance(vertex)));
    }
  }
  const std::span<const Index> shared = partition.sharedVertices();
  std::vector<StartValue> own;
  for (const Index vertex : raised)
  {
    if (std::binary_search(shared.begin(), shared.end(), vertex))
    {
      own.push_back({ vertex, 0, this->Bounds.ofVertex(vertex), false });
    }
  }
  for (const StartValue& other : partition.exchange(own))
  {
    raise(other.vertex, other.value);
  }
  sortUnique(raised);
  return raised;
}

bool LineBounds::isWorthwhile(std::span<const Index> raised, const DistanceField& ways) const
{
  const auto& [mesh, closed, options, partition, front, cost, limit] = this->On;
  std::array<double, 3> counts{ 0.0, 0.0, 0.0 };
  for (const Index vertex : raised)
  {
    counts[0] += partition.owns(vertex) ? 1.0 : 0.0;
    counts[2] = std::max(counts[2], ways.distance(vertex) - this->SeedValue);
  }
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    counts[1] += partition.owns(vertex) ? 1.0 : 0.0;
  }
  const std::vector<double> all = partition.gather(counts);
  std::array<double, 3> ofAll{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < all.size(); i += counts.size())
  {
    ofAll[0] += all[i];
    ofAll[1] += all[i + 1];
    ofAll[2] = std::max(ofAll[2], all[i + 2]);
  }
  return ofAll[0] <= MostRaised * ofAll[1] && labelsAreSpread(mesh, front, ofAll[2], partition);
}

LabelBounds::Check LineBounds::raise(const DistanceField& field, std::vector<Index>& beside)
{
  Partition& partition = this->On.partition;
  const auto isAny = [&](const std::vector<Index>& vertices)
  {
    const double count = static_cast<double>(vertices.size());
    const std::vector<double> all = partition.gather({ &count, 1 });
    return *std::max_element(all.begin(), all.end()) > 0.0;
  };
  const std::vector<Index> low = this->lowIn(field);
  if (!isAny(low))
  {
    return LabelBounds::Check::Passed;
  }
  DistanceField ways = field;
  if (!this->findWays(field, low, ways))
  {
    return LabelBounds::Check::Cancelled;
  }
  const std::vector<Index> raised = this->raiseTo(ways, low);
  this->AreUseless = !this->isWorthwhile(raised, ways);
  if (this->AreUseless || !isAny(raised))
  {
    return LabelBounds::Check::Passed;
  }
  beside = reachedBeside(this->On.mesh, raised, field);
  std::sort(beside.begin(), beside.end(),
    [&](Index a, Index b)
    { return std::tuple(field.distance(a), a) < std::tuple(field.distance(b), b); });
  return LabelBounds::Check::Raised;
}

}
