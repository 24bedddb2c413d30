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
 * @param bounds  null if there are none
 * @param values  takeHigherBounds() reads the bounds anew, goBackTo(vertex) makes empty queues go
 *                back to all values of a vertex, and queueAgain(vertex) puts these into them once
 * more
 * @return false when cancelled
 */
template <class Front, class Values>
bool goOnWithinHigherBounds(LabelBounds* bounds, Front& front, Values& values, Partition& partition,
  StopLimit& limit, const DistanceField& field)
{
  if (!bounds)
  {
    return true;
  }
  std::vector<Index> beside;
  const LabelBounds::Check found = bounds->check(field, beside);
  values.takeHigherBounds();
  // As long as a queue is empty, it goes back without a step.
  for (const Index vertex : beside)
  {
    values.goBackTo(vertex);
  }
  for (const Index vertex : beside)
  {
    values.queueAgain(vertex);
  }
  return found == LabelBounds::Check::Raised ? partition.march(front, limit)
                                             : found == LabelBounds::Check::Passed;
}

}

#endif
