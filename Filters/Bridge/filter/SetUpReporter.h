// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SetUpReporter_h
#define geodesic_bridge_SetUpReporter_h

#include "base/Interruption.h"
#include "filter/VtkVersions.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <chrono>

namespace geodesic::bridge
{

/**
 * Tells a filter's observers, every tenth of a second, that it prepares a surface, and ends that by
 * Interrupted if they abort the filter. How long it takes is not known before, so the progress only
 * comes near to a share of the whole. To be made before all work of a run, on one rank only: others
 * would wait for one that is interrupted.
 */
class SetUpReporter
{
public:
  /** @param share  the part of the filter's progress that is its preparation */
  explicit SetUpReporter(vtkAlgorithm& filter, double share)
    : Filter(filter)
    , Share(share)
    , Interrupter([this] { return this->report(); })
  {
  }

private:
  using Clock = std::chrono::steady_clock;

  bool report()
  {
    const auto now = Clock::now();
    if (now < this->LastReport + std::chrono::milliseconds(100))
    {
      return true;
    }
    this->LastReport = now;
    const double seconds = std::chrono::duration<double>(now - this->Begin).count();
    this->Filter.UpdateProgress(
      std::max(this->Filter.GetProgress(), this->Share * seconds / (1.0 + seconds)));
    return !checkAbort(this->Filter);
  }

  vtkAlgorithm& Filter;
  double Share;
  Clock::time_point Begin = Clock::now();
  Clock::time_point LastReport = Begin;
  Interruption Interrupter;
};

}

#endif
