// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of MarchingSolver within LabelBounds.
#include "march/MarchingSolver.h"

#include "march/EdgeLowering.h"
#include "march/FirstMarchDistances.h"
#include "march/HubVertices.h"
#include "march/LabelDensity.h"
#include "march/LabelReach.h"
#include "march/LineBounds.h"
#include "march/SourceFront.h"
#include "march/StraightLines.h"
#include "march/TakenStart.h"
#include "mesh/TriangleMesh.h"
#include "solve/OptionsOfMarches.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

constexpr LabelThinning OfCompeting{ .mostError = 0.05,
  .allowance = 0.5,
  .lasting = 20.0,
  .excess = 0.08 };
/** Beside lines are many labels, each of which is the nearest for less. */
constexpr LabelThinning OfLines{ .mostError = 0.08,
  .allowance = 0.45,
  .lasting = 60.0,
  .excess = 0.05 };

/** Where costs are spread, half a dear edge is more than a way across much of the surface. The
 * excess is LabelBounds::excess(). */
constexpr LabelThinning OfSpreadCosts{ .mostError = 0.1,
  .allowance = 0.0,
  .lasting = 20.0,
  .excess = 0.0 };

/** A front of all labels together, for a first march. */
const SeedFront Together{ { { 0, FrontShape::Straight, 0.0, {}, {} } }, {} };

/** Resets a field for another march of the same run. */
void resetAfterMarch(DistanceField& field)
{
  const double raisedGain = field.raisedGain();
  field.reset();
  field.noteRaisedGain(raisedGain);
}

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

/** Lets all pieces know the targets' distances after these were lowered without a march.
 * Collective.
 */
void learnTargets(StopLimit& limit, Partition& partition)
{
  std::vector<double> least = limit.targetDistances();
  const std::vector<double> all = partition.gather(least);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    double& known = least[i % least.size()];
    known = std::min(known, all[i]);
  }
  limit.learn(least);
}

/**
 * Makes a field of starts alone: each vertex gets the least distance, and of equal ones the
 * smallest seed number. Pieces that share a vertex have the same starts there.
 */
void takeStarts(
  std::span<const Label> labels, std::span<const StartValue> starts, DistanceField& field)
{
  for (const StartValue& start : starts)
  {
    takeStart(start, labels, field);
  }
  field.orderReached();
}

}

template <class Cost>
bool MarchingSolver::marchWithinBounds(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, bool areDense, StopLimit& limit, DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  const auto endAtStarts = [&]
  {
    takeStarts(labels, starts, field);
    learnTargets(limit, request.partition);
    return true;
  };
  if (areDense && areSettled(this->mesh(), starts, request.partition))
  {
    return endAtStarts();
  }
  OptionsOfMarches marches(request.options);
  if constexpr (Cost::isUnit)
  {
    if (areDense && LineBounds::suit(this->mesh(), request.front, request.partition) &&
      !this->hasHubs(request.partition))
    {
      return this->marchWithinLines(starts, cost, request, marches, limit, field);
    }
  }
  this->LabelsWithin.begin(this->mesh(), labels, starts, request.partition);
  if (areDense && this->LabelsWithin.areAllInside(request.partition))
  {
    this->LabelsWithin.clear();
    return endAtStarts();
  }
  return this->marchTwice(starts, cost, request, areDense, marches, limit, field);
}

template bool MarchingSolver::marchWithinBounds(
  std::span<const StartValue>, const UnitCost&, const Request&, bool, StopLimit&, DistanceField&);
template bool MarchingSolver::marchWithinBounds(
  std::span<const StartValue>, const VertexCost&, const Request&, bool, StopLimit&, DistanceField&);

bool MarchingSolver::hasHubs(Partition& partition)
{
  const double isMissing = this->HasHubs ? 0.0 : 1.0;
  const std::vector<double> all = partition.gather({ &isMissing, 1 });
  if (*std::max_element(all.begin(), all.end()) > 0.0)
  {
    this->HasHubs = geodesic::hasHubs(this->mesh(), partition);
  }
  return *this->HasHubs;
}

bool MarchingSolver::marchWithinLines(std::span<const StartValue> starts, const UnitCost& cost,
  const Request& request, OptionsOfMarches& marches, StopLimit& limit, DistanceField& field)
{
  LabelBounds& bounds = this->LabelsWithin;
  LineBounds lineBounds({ this->mesh(), marches, request.partition, request.front, cost, limit },
    bounds,
    [&](std::span<const StartValue> from, std::span<const std::uint8_t> excluded)
    { return this->marchWays(from, excluded, cost, request, marches, limit); });
  if (!this->Lines)
  {
    this->Lines.emplace(this->mesh().positions());
  }
  lineBounds.set(*this->Lines, starts);
  bounds.setChecking([&](const DistanceField& found, std::vector<Index>& beside)
    { return lineBounds.raise(found, beside); });
  const Request within{ request.front, request.closed, marches.get(), request.partition,
    request.hasCost };
  const std::span<const StartValue> counting =
    bounds.within(this->mesh(), request.front.labels, starts, [&] { return marches.goesOn(); });
  const bool isFinished = this->marchLabels(counting, cost, within, marches, limit, field);
  return this->finishWithinBounds(starts, request, true, isFinished, marches, limit, field);
}

template <class Cost>
bool MarchingSolver::marchLabels(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, OptionsOfMarches& marches, StopLimit& limit, DistanceField& field)
{
  LabelBounds& bounds = this->LabelsWithin;
  if (marches.areCancelled(request.partition) ||
    !this->marchFrom(starts, cost, request, &bounds, limit, field))
  {
    return false;
  }
  // A march on threads does not go on from where it was.
  std::vector<Index> beside;
  const LabelBounds::Check found = bounds.check(field, beside);
  if (found != LabelBounds::Check::Raised)
  {
    return found == LabelBounds::Check::Passed;
  }
  resetAfterMarch(field);
  marches.beginNext();
  return this->marchFrom(starts, cost, request, &bounds, limit, field);
}

const DistanceField* MarchingSolver::marchWays(std::span<const StartValue> starts,
  std::span<const std::uint8_t> excluded, const UnitCost& cost, const Request& request,
  OptionsOfMarches& marches, StopLimit& limit)
{
  if (!this->WaysSolver)
  {
    this->WaysSolver = this->another();
    this->Ways.emplace(this->mesh().numberOfVertices());
  }
  this->Ways->reset();
  learnTargets(limit, request.partition);
  const std::size_t taken = marches.beginNext();
  SolveOptions options = marches.get();
  options.excluded = excluded;
  options.maximumDistance = limit.value();
  StopLimit limitOfWays(this->mesh(), options, *this->Ways);
  limitOfWays.setReaches(limit.reaches());
  const Request ways{ Together, request.closed, options, request.partition, request.hasCost };
  const bool isFinished =
    this->WaysSolver->marchFrom(starts, cost, ways, nullptr, limitOfWays, *this->Ways);
  marches.goOn(taken);
  return isFinished ? &*this->Ways : nullptr;
}

bool MarchingSolver::finishWithinBounds(std::span<const StartValue> starts, const Request& request,
  bool areDense, bool isFinished, OptionsOfMarches& marches, StopLimit& limit, DistanceField& field)
{
  const Taking taking = !areDense ? Taking::WhereNone
    : request.hasCost             ? Taking::WhereLess
                                  : Taking::WhereLessRaised;
  marches.beginNext();
  if (isFinished)
  {
    marches.goesOn();
    isFinished = !marches.areCancelled(request.partition);
  }
  if (isFinished)
  {
    takeFirstMarch(this->mesh(), request.front.labels, starts, taking, this->LabelsWithin,
      request.partition, field);
  }
  if (taking == Taking::WhereLessRaised && isFinished)
  {
    isFinished = lowerAlongEdges(this->mesh(), request.closed, marches.get(),
      this->LabelsWithin.atEnds(), request.partition, limit, field);
  }
  learnTargets(limit, request.partition);
  this->LabelsWithin.clear();
  return isFinished;
}

template <class Cost>
bool MarchingSolver::marchTwice(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, bool areDense, OptionsOfMarches& marches, StopLimit& limit,
  DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  const SolveOptions& options = marches.get();
  StopLimit firstLimit(this->mesh(), options, field);
  firstLimit.setReaches(limit.reaches());
  const Request first{ Together, request.closed, options, request.partition, request.hasCost };
  if (!this->marchFrom(this->LabelsWithin.starts(), cost, first, nullptr, firstLimit, field))
  {
    this->LabelsWithin.clear();
    return false;
  }
  if (areDense)
  {
    const double least = leastSeedValue(labels);
    const double farthest = farthestOf(field, request.partition);
    const std::vector<Index> hubs = hubVertices(this->mesh(), field.reached(), request.partition);
    const auto isHub = [&](Index vertex)
    { return std::binary_search(hubs.begin(), hubs.end(), vertex); };
    marches.goesOn();
    const bool areSpread = !request.hasCost &&
      labelsAreSpread(this->mesh(), request.front, farthest - least, request.partition);
    const bool compete =
      !areSpread && labelsCompeteInTriangles(this->mesh(), request.front, request.partition);
    const bool costsAreSpread = cost.queueOrder() == QueueOrder::ByValue;
    const LabelThinning& thinning = costsAreSpread ? OfSpreadCosts
      : compete                                    ? OfCompeting
                                                   : OfLines;
    std::vector<LabelReach> reaches(labels.size());
    if (!areSpread)
    {
      reaches = labelReaches(
        this->mesh(), request.front, request.options.cost, farthest, thinning,
        [&] { return marches.goesOn(); }, request.partition);
    }
    if (marches.areCancelled(request.partition))
    {
      this->LabelsWithin.clear();
      return false;
    }
    const auto excessOf = [&](Index vertex) -> std::optional<double>
    {
      if (isHub(vertex))
      {
        return std::nullopt;
      }
      const double reach = cost.reach(vertex);
      if (compete && this->LabelsWithin.hasStart(vertex))
      {
        return LabelBounds::excessAtStart(reach);
      }
      return areSpread || costsAreSpread
        ? LabelBounds::excess(reach, field.distance(vertex) - least)
        : thinning.excess * reach;
    };
    this->LabelsWithin.take(field, std::move(reaches), excessOf);
  }
  else
  {
    this->LabelsWithin.take(field, std::vector<LabelReach>(labels.size()),
      [&](Index vertex) { return cost.margin(vertex); });
  }
  resetAfterMarch(field);
  marches.beginNext();
  const Request second{ request.front, request.closed, options, request.partition,
    request.hasCost };
  const std::span<const StartValue> counting =
    this->LabelsWithin.within(this->mesh(), labels, starts, [&] { return marches.goesOn(); });
  const bool isFinished = this->marchLabels(counting, cost, second, marches, limit, field);
  return this->finishWithinBounds(starts, request, areDense, isFinished, marches, limit, field);
}

}
