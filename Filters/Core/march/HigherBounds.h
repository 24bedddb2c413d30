// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_HigherBounds_h
#define geodesic_HigherBounds_h

#include "march/LabelBounds.h"
#include "solve/MarchingFront.h"
#include "solve/Partition.h"

#include <vector>

namespace geodesic
{

class StopLimit;

/**
 * To be called after a march within bounds: has them checked, and goes on where they were too low.
 * Collective.
 * @param bounds      null if there are none
 * @param queueAgain  queueAgain(vertex) puts all values of a vertex into the queues again
 * @return false when cancelled
 */
template <class QueueAgain>
bool goOnWithinHigherBounds(LabelBounds* bounds, MarchingFront& front, Partition& partition,
  StopLimit& limit, const DistanceField& field, const QueueAgain& queueAgain)
{
  if (!bounds)
  {
    return true;
  }
  std::vector<Index> beside;
  const LabelBounds::Check found = bounds->check(field, beside);
  for (const Index vertex : beside)
  {
    queueAgain(vertex);
  }
  return found == LabelBounds::Check::Raised ? partition.march(front, limit)
                                             : found == LabelBounds::Check::Passed;
}

}

#endif
