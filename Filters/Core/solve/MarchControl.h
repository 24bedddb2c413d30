// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchControl_h
#define geodesic_MarchControl_h

#include "solve/SolveOptions.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace geodesic
{

/** A front that takes too many updates, see MarchControl. */
class FrontDoesNotSettle : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * Counts what a march takes from its queue; reports progress and follows the targets meanwhile.
 *
 * It also says from which gain on a new value counts. A relative gain of 1e-12 makes fields agree
 * to 1e-10 over all orders, at one to a few updates a vertex. Where sheets of triangles lie on each
 * other at random, or triangles are needles, gains can go on for ever, each smaller than the last.
 * So a march has a budget of MostUpdates for each value that vertices keep, those of several labels
 * counted apart, and for SmallMarch values more. At 40 updates for each, and then at every 10 more,
 * the least gain is raised tenfold, which a field says (DistanceField::raisedGain()); beyond the
 * budget mayGoOn() throws.
 */
class MarchControl
{
public:
  /** The updates for each value that is kept at which the least gain is raised first. */
  static constexpr std::size_t UsualUpdates = 40;
  /** The most updates for each value that is kept. */
  static constexpr std::size_t MostUpdates = 100;
  /** A number of values for which the budget allows in any case. It is large, as pieces of a
   * surface are small: needles of 300 points with costs settle after 100,000 updates, and only then
   * do all cuts of them agree. */
  static constexpr std::size_t SmallMarch = 10000;

  /** @param mostUpdates  for each value that is kept, if these are to be fewer. The least gain is
   * not raised before then */
  MarchControl(const SolveOptions& options, StopLimit& limit, std::size_t mostUpdates = MostUpdates)
    : Options(options)
    , Limit(limit)
    , Most(mostUpdates)
    , NextRelaxation(std::min(mostUpdates, UsualUpdates))
    , NextReport(
        options.onProgress && options.progressInterval > 0 ? options.progressInterval : Never)
  {
  }

  /** Ends a march that took too many updates. @param most  for each value
   * @throws FrontDoesNotSettle always */
  [[noreturn]] static void endUnsettled(std::size_t updates, std::size_t values, std::size_t most)
  {
    throw FrontDoesNotSettle("The front does not settle: it took " + std::to_string(updates) +
      " updates for " + std::to_string(values) + " values, more than the limit of " +
      std::to_string(most) +
      " for each. The surface has needles, or triangles that lie on each other. Clean or remesh "
      "the surface, or use the method Dijkstra.");
  }

  /** The least gain that counts if that was raised, as a part of a value; else 0. */
  double raisedGain() const { return this->NextRelaxation > UsualUpdates ? this->LeastGain : 0.0; }
  /** A new value counts below this fraction of the old one. */
  double keptFraction() const { return this->KeptFraction; }

  /**
   * To be asked before each step, or before several; false once the run is cancelled.
   * @param values  how many values vertices keep so far
   * @throws FrontDoesNotSettle where the march is beyond its budget
   */
  bool mayGoOn(std::size_t values, std::size_t steps = 1)
  {
    constexpr std::size_t limitInterval = 32;
    const std::size_t before = this->Count;
    this->Count += steps;
    if (this->Count / limitInterval != before / limitInterval)
    {
      this->Limit.update();
    }
    if (this->Count > this->NextRelaxation * (values + SmallMarch))
    {
      this->relax(values);
    }
    while (this->Count >= this->NextReport && !this->Cancelled)
    {
      this->report();
    }
    return !this->Cancelled;
  }

  /** Reports the progress that was last reported, so that a run can be cancelled between steps too;
   * false once it is. Cheap enough to be called for each seed. */
  bool reportAgain()
  {
    constexpr std::size_t interval = 256;
    if (this->NextReport != Never && !this->Cancelled && ++this->Repetitions % interval == 0)
    {
      this->Cancelled = !this->Options.onProgress(this->LastReport);
    }
    return !this->Cancelled;
  }

  /** How many steps were taken. */
  std::size_t count() const { return this->Count; }

  bool isCancelled() const { return this->Cancelled; }

private:
  static constexpr std::size_t Never = std::numeric_limits<std::size_t>::max();

  void report()
  {
    this->Cancelled = !this->Options.onProgress(this->NextReport);
    this->LastReport = this->NextReport;
    this->NextReport += this->Options.progressInterval;
  }

  void relax(std::size_t values)
  {
    if (this->NextRelaxation >= this->Most)
    {
      endUnsettled(this->Count, values, this->Most);
    }
    this->NextRelaxation += 10;
    this->LeastGain *= 10.0;
    this->KeptFraction = 1.0 - this->LeastGain;
  }

  const SolveOptions& Options;
  StopLimit& Limit;
  std::size_t Most;
  /** The number of updates for each value at which the least gain is raised next. */
  std::size_t NextRelaxation;
  std::size_t LastReport = 0;
  std::size_t NextReport;
  std::size_t Repetitions = 0;
  double LeastGain = 1e-12;
  double KeptFraction = 1.0 - 1e-12;
  std::size_t Count = 0;
  bool Cancelled = false;
};

}

#endif
