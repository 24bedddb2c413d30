// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchControl_h
#define geodesic_MarchControl_h

#include "solve/SolveOptions.h"
#include "solve/StopLimit.h"

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace geodesic
{

/**
 * Counts what a march takes from its queue; reports progress and follows the targets meanwhile.
 *
 * It also says from which gain on a new value counts. A relative gain of 1e-12 makes fields agree
 * to 1e-10 over all orders, at one to a few updates a vertex. Where sheets of triangles lie on each
 * other at random, gains can go on for ever, each smaller than the last: after every 400 (n + 100)
 * updates, n the number of vertices, the least gain is raised tenfold; beyond 1e-6 relax() throws.
 */
class MarchControl
{
public:
  MarchControl(const SolveOptions& options, StopLimit& limit, Index numberOfVertices)
    : Options(options)
    , Limit(limit)
    , Patience(400 * (std::size_t{ numberOfVertices } + 100))
    , NextRelaxation(this->Patience)
    , NextReport(
        options.onProgress && options.progressInterval > 0 ? options.progressInterval : Never)
  {
  }

  /** A new value counts below this fraction of the old one. */
  double keptFraction() const { return this->KeptFraction; }

  /**
   * To be asked before each step, or before several; false once the run is cancelled.
   * @throws std::runtime_error where the march does not end
   */
  bool mayGoOn(std::size_t steps = 1)
  {
    constexpr std::size_t limitInterval = 32;
    const std::size_t before = this->Count;
    this->Count += steps;
    if (this->Count / limitInterval != before / limitInterval)
    {
      this->Limit.update();
    }
    if (this->Count >= this->NextRelaxation)
    {
      this->relax();
    }
    while (this->Count >= this->NextReport && !this->Cancelled)
    {
      this->report();
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
    this->NextReport += this->Options.progressInterval;
  }

  void relax()
  {
    this->NextRelaxation += this->Patience;
    constexpr double largestGain = 1e-6;
    this->LeastGain *= 10.0;
    this->KeptFraction = 1.0 - this->LeastGain;
    if (this->LeastGain > largestGain)
    {
      throw std::runtime_error("The front does not settle after " + std::to_string(this->Count) +
        " updates: the surface consists of triangles that lie on each other. Clean the surface, or "
        "use "
        "the method Dijkstra.");
    }
  }

  const SolveOptions& Options;
  StopLimit& Limit;
  std::size_t Patience;
  std::size_t NextRelaxation;
  std::size_t NextReport;
  double LeastGain = 1e-12;
  double KeptFraction = 1.0 - 1e-12;
  std::size_t Count = 0;
  bool Cancelled = false;
};

}

#endif
