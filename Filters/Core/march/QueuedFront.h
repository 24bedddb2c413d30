// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_QueuedFront_h
#define geodesic_QueuedFront_h

#include "march/FrontQueues.h"
#include "march/SourceFront.h"
#include "solve/DistanceField.h"
#include "solve/MarchControl.h"
#include "solve/MarchingFront.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * The march of FastMarchingSolver as a MarchingFront, which a Partition drives.
 * @tparam Values   as in NeighbourUpdate
 * @tparam Advance  see BatchedMarch::advance()
 */
template <class Values, class Advance>
class QueuedFront final : public MarchingFront
{
public:
  /**
   * @param meanLongestEdge, typicalEdge  see MarchingFront
   * @param firstDistance    the distance of the queues' key 0
   */
  QueuedFront(FrontQueues& queues, const MarchControl& control, double meanLongestEdge,
    double typicalEdge, double firstDistance, Values& values, Advance advance)
    : Queues(queues)
    , Control(control)
    , MeanLongestEdge(meanLongestEdge)
    , TypicalEdge(typicalEdge)
    , FirstDistance(firstDistance)
    , FrontValues(values)
    , AdvanceBefore(std::move(advance))
  {
  }

  void advance(double limit, std::vector<Index>* taken) override
  {
    double key = limit - this->FirstDistance;
    if (this->nextDistance() < limit)
    {
      // Rounding must not leave out the first one.
      constexpr double infinity = std::numeric_limits<double>::infinity();
      key = std::max(key, std::nextafter(this->Queues.nextKey(), infinity));
    }
    this->AdvanceBefore(this->Queues.endOfMarch(key), taken);
    if (taken)
    {
      std::transform(taken->begin(), taken->end(), taken->begin(),
        [&](Index item) { return this->FrontValues.vertexOf(item); });
    }
  }

  double nextDistance() const override { return this->FirstDistance + this->Queues.nextKey(); }

  double meanLongestEdge() const override { return this->MeanLongestEdge; }
  double typicalEdge() const override { return this->TypicalEdge; }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  bool isCancelled() const override { return this->Control.isCancelled(); }

  void visitValues(Index vertex, const Visit& visit) const override
  {
    this->FrontValues.visit(vertex, visit);
  }

  void lower(Index vertex, Index label, double value) override
  {
    const SourceFront& front = this->FrontValues.enter(label, vertex);
    this->Queues.goBackTo(this->Queues.group(front.group + this->Queues.groupOfVertex(vertex)),
      front.distance(value) - this->FirstDistance);
    // A final value is the same on all pieces, and has fallen there only along an edge.
    this->FrontValues.template propose<Way::Along>(front, vertex, value);
  }

private:
  FrontQueues& Queues;
  const MarchControl& Control;
  double MeanLongestEdge;
  double TypicalEdge;
  double FirstDistance;
  Values& FrontValues;
  Advance AdvanceBefore;
};

}

#endif
