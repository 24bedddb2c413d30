// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/LineBounds.h"

#include "base/SortUnique.h"
#include "march/LabelDensity.h"
#include "march/LabelReach.h"
#include "march/StraightLines.h"
#include "mesh/TriangleMesh.h"
#include "solve/OptionsOfMarches.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace geodesic
{
namespace
{

/** How much the distances that count may exceed the least straight line: parts of it and of the
 * reach. On a hilly grid distances are 2 % more than lines in the mean. */
constexpr double PartOfLine = 1.04;
constexpr double PartOfReach = 0.5;
/** Of far parts. Bounds there are as wide as if labels were not thinned. */
constexpr LabelThinning OfFarParts{ .mostError = 0.1,
  .allowance = 0.0,
  .lasting = 20.0,
  .excess = 0.0 };

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
    labelsAreSpread(mesh, front, 0.0, partition);
}

void LineBounds::set(StraightLines& lines, std::span<const StartValue> starts)
{
  const auto& [mesh, marches, partition, front, cost, limit] = this->On;
  this->SeedValue = front.labels[0].value;
  this->findMost(starts);
  std::vector<Vector3> places(front.labels.size());
  std::transform(front.labels.begin(), front.labels.end(), places.begin(),
    [](const Label& label) { return label.position; });
  // No value counts that is longer than the limit by some edges. On pieces these may be others'.
  constexpr double edges = 8.0;
  const double farthest = partition.isDivided()
    ? DistanceField::Unreached
    : limit.value() - this->SeedValue + edges * mesh.longestEdgeLength();
  this->Bounds.startBlocks(mesh.numberOfVertices(), front.labels.size());
  lines.measure(places, std::max(farthest, 0.0),
    [&, &reachOf = cost](Index first, std::span<const double> squares)
    {
      const std::span<double> bounds = this->Bounds.addBlock(first, squares.size());
      for (Index i = 0; i < bounds.size(); ++i)
      {
        bounds[i] = this->SeedValue +
          std::min(this->Most,
            PartOfLine * std::sqrt(squares[i]) + PartOfReach * reachOf.reach(first + i));
      }
    });
  // The nearest seed in space may be on another sheet.
  const auto raise = [&](Index vertex, double bound)
  { this->Bounds.setOfVertex(vertex, std::max(bound, this->Bounds.ofVertex(vertex))); };
  for (const StartValue& start : starts)
  {
    constexpr double rounding = 1.0 + 1e-9;
    raise(start.vertex, rounding * (this->SeedValue + start.value));
  }
  std::vector<StartValue> shared;
  for (const Index vertex : partition.sharedVertices())
  {
    shared.push_back({ vertex, 0, this->Bounds.ofVertex(vertex), false });
  }
  for (const StartValue& other : partition.exchange(shared))
  {
    raise(other.vertex, other.value);
  }
}

void LineBounds::findMost(std::span<const StartValue> starts)
{
  constexpr double mostSpacings = 2.0;
  double most = mostSpacings * labelSpacing(this->On.mesh, this->On.front, this->On.partition);
  for (const StartValue& start : starts)
  {
    most = std::max(most, start.value);
  }
  this->Most = this->mostOfAll(most);
}

double LineBounds::mostOfAll(double own) const
{
  const std::vector<double> all = this->On.partition.gather({ &own, 1 });
  return *std::max_element(all.begin(), all.end());
}

double LineBounds::excess(Index vertex, double distance) const
{
  return LabelBounds::excess(this->On.cost.reach(vertex), distance - this->SeedValue);
}

std::vector<Index> LineBounds::lowIn(const DistanceField& field) const
{
  const auto& [mesh, marches, partition, front, cost, limit] = this->On;
  std::vector<Index> low;
  for (const auto& [begin, end] : this->Bounds.blocks())
  {
    for (Index vertex = begin; vertex < end; ++vertex)
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
  }
  // Rounding may tell otherwise on another piece.
  std::vector<StartValue> own;
  std::transform(low.begin(), low.end(), std::back_inserter(own),
    [](Index vertex) {
      return StartValue{ vertex, 0, 0.0, false };
    });
  for (const StartValue& other : partition.exchange(own))
  {
    low.push_back(other.vertex);
  }
  sortUnique(low);
  return low;
}

std::vector<StartValue> LineBounds::startsOfWays(const DistanceField& field,
  std::span<const Index> low, const std::vector<std::uint8_t>& isLow) const
{
  const TriangleMesh& mesh = this->On.mesh;
  std::vector<std::uint8_t> isStart(mesh.numberOfVertices());
  for (const FrontStart& start : this->On.front.starts)
  {
    const bool isLeast = this->SeedValue + start.length <= field.distance(start.vertex);
    isStart[start.vertex] |= isLeast ? 1 : 0;
  }
  std::vector<std::uint8_t> isKnown(mesh.numberOfVertices());
  std::vector<StartValue> starts;
  const auto add = [&](Index vertex)
  {
    if (isKnown[vertex] == 0 && field.isReached(vertex))
    {
      isKnown[vertex] = 1;
      const bool isFinal = isLow[vertex] == 0 || isStart[vertex] != 0;
      starts.push_back({ vertex, 0, field.distance(vertex), isFinal });
    }
  };
  for (const Index vertex : low)
  {
    add(vertex);
    for (const RingEntry& entry : mesh.ring(vertex))
    {
      add(entry.neighbour());
    }
  }
  return starts;
}

bool LineBounds::raiseTo(const DistanceField& ways, std::span<const Index> low)
{
  this->boundLabels(ways);
  bool isAny = false;
  const auto raise = [&](Index vertex, double bound)
  {
    isAny |= bound > this->Bounds.ofVertex(vertex);
    this->Bounds.setOfVertex(vertex, std::max(bound, this->Bounds.ofVertex(vertex)));
  };
  std::vector<StartValue> own;
  for (const Index vertex : low)
  {
    if (const double distance = ways.distance(vertex); ways.isReached(vertex))
    {
      this->Bounds.setFirst(vertex, distance);
      raise(vertex, distance + this->excess(vertex, distance));
      own.push_back({ vertex, 0, this->Bounds.ofVertex(vertex), false });
    }
  }
  // Bounds are the same on all pieces, to the last bit.
  for (const StartValue& other : this->On.partition.exchange(own))
  {
    raise(other.vertex, other.value);
  }
  return isAny;
}

LabelBounds::Check LineBounds::raise(const DistanceField& field, std::vector<Index>& beside)
{
  const auto& [mesh, marches, partition, front, cost, limit] = this->On;
  const std::vector<Index> low = this->lowIn(field);
  if (this->mostOfAll(static_cast<double>(low.size())) == 0.0)
  {
    return LabelBounds::Check::Passed;
  }
  std::vector<std::uint8_t> isLow(mesh.numberOfVertices());
  std::vector<std::uint8_t> excluded(mesh.numberOfVertices(), 1);
  for (const Index vertex : low)
  {
    isLow[vertex] = 1;
    excluded[vertex] = marches.get().isExcluded(vertex) ? 1 : 0;
  }
  const std::vector<StartValue> starts = this->startsOfWays(field, low, isLow);
  for (const StartValue& start : starts)
  {
    excluded[start.vertex] = 0;
  }
  const DistanceField* const ways = this->March(starts, excluded);
  if (!ways)
  {
    return LabelBounds::Check::Cancelled;
  }
  const bool isRaised = this->mostOfAll(this->raiseTo(*ways, low) ? 1.0 : 0.0) > 0.0;
  if (marches.areCancelled(partition))
  {
    return LabelBounds::Check::Cancelled;
  }
  if (!isRaised)
  {
    return LabelBounds::Check::Passed;
  }
  std::transform(starts.begin(), starts.end(), std::back_inserter(beside),
    [](const StartValue& start) { return start.vertex; });
  return LabelBounds::Check::Raised;
}

void LineBounds::boundLabels(const DistanceField& ways)
{
  double farthest = 0.0;
  for (const Index vertex : ways.reached())
  {
    farthest = std::max(farthest, ways.distance(vertex));
  }
  std::vector<LabelReach> reaches = labelReaches(
    this->On.mesh, this->On.front, {}, this->mostOfAll(farthest), OfFarParts,
    [this] { return this->On.marches.goesOn(); }, this->On.partition);
  for (LabelReach& reach : reaches)
  {
    // Not less than any value so far, so that this bound is no lower either.
    reach.value = std::max(reach.value, this->Most);
  }
  this->Bounds.setOfLabels(std::move(reaches));
}

}
