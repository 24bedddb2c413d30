// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_ProgressReporter_h
#define geodesic_bridge_ProgressReporter_h

#include "base/Index.h"
#include "filter/VtkVersions.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace geodesic::bridge
{

/**
 * Reports the progress of a march, or of a search for a path, to a filter's observers: about a
 * hundred times a run, and every tenth of a second at least, so that they can abort it. How much
 * there is to do is not known before, so the progress only comes near to 1. It goes on from the
 * filter's progress so far.
 */
class ProgressReporter
{
public:
  ProgressReporter(vtkAlgorithm& filter, Index numberOfVertices)
    : Filter(filter)
    , Total(1.2 * numberOfVertices)
    , Start(filter.GetProgress())
    , Reported(Start)
  {
  }

  /**
   * @param taken number of vertices taken from the queue, and of other steps, so far; few vertices
   *              are usually taken twice
   * @return false if the filter must abort
   */
  bool report(std::size_t taken)
  {
    const double fraction =
      this->Start + (1.0 - this->Start) * this->fractionOf(static_cast<double>(taken));
    const auto now = Clock::now();
    if (fraction < this->Reported + 0.01 && now < this->LastReport + std::chrono::milliseconds(100))
    {
      return true;
    }
    this->Reported = std::max(this->Reported, fraction);
    this->LastReport = now;
    // What was prepared since the march was ordered may have come further.
    this->Filter.UpdateProgress(std::max(this->Filter.GetProgress(), this->Reported));
    return !checkAbort(this->Filter);
  }

private:
  using Clock = std::chrono::steady_clock;

  /** Rises up to nine tenths as expected, and then ever more slowly. */
  double fractionOf(double taken) const
  {
    constexpr double expected = 0.9;
    return taken < this->Total ? expected * taken / this->Total
                               : 1.0 - (1.0 - expected) * this->Total / taken;
  }

  vtkAlgorithm& Filter;
  double Total;
  double Start;
  double Reported;
  Clock::time_point LastReport = Clock::now();
};

}

#endif
