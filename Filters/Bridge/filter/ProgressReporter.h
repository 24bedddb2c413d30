// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_ProgressReporter_h
#define geodesic_bridge_ProgressReporter_h

#include "base/Index.h"
#include "filter/Abort.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <cstddef>

namespace geodesic::bridge
{

/** Reports the progress of a march to a filter's observers, about a hundred times a run. */
class ProgressReporter
{
public:
  ProgressReporter(vtkAlgorithm& filter, Index numberOfVertices)
    : Filter(filter)
    , Total(1.2 * numberOfVertices)
  {
  }

  /**
   * @param taken number of vertices taken from the queue so far; few vertices are taken twice
   * @return false if the filter must abort
   */
  bool report(std::size_t taken)
  {
    const double fraction = std::min(static_cast<double>(taken) / this->Total, 1.0);
    if (fraction < this->Reported + 0.01)
    {
      return true;
    }
    this->Reported = fraction;
    this->Filter.UpdateProgress(fraction);
    return !checkAbort(this->Filter);
  }

private:
  vtkAlgorithm& Filter;
  double Total;
  double Reported = 0.0;
};

}

#endif
