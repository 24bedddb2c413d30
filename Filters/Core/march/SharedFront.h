// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedFront_h
#define geodesic_SharedFront_h

#include "march/FrontQueues.h"
#include "march/NeighbourValues.h"
#include "solve/MarchControl.h"
#include "threads/SharedMarch.h"
#include "threads/ThreadFront.h"

#include <cstddef>
#include <functional>

namespace geodesic
{

/**
 * A thread's part of a march of FastMarchingSolver as a ThreadFront, which a SharedMarch drives.
 * @tparam Values   SharedValues or SharedLabelValues
 * @tparam Batches  a BatchedMarch
 */
template <class Values, class Batches>
class SharedFront final : public ThreadFront
{
public:
  /** @param meanLongestEdge  see MarchingFront */
  SharedFront(FrontQueues& queues, const MarchControl& control, double meanLongestEdge,
    Values& values, const SharedMarch::Share& share, Batches& batches)
    : Queues(queues)
    , Control(control)
    , MeanLongestEdge(meanLongestEdge)
    , FrontValues(values)
    , Share(share)
    , March(batches)
  {
  }

  void advanceWhile(double limit, const std::function<bool()>& mayGoOn) override
  {
    this->March.advanceWhile(this->Queues.endOfMarch(limit), nullptr, mayGoOn);
  }
  void visitAtBorder(
    const std::function<void(const LabelAtVertex& place, double key)>& visit) override
  {
    this->FrontValues.visitAtBorder(visit);
  }
  double next() const override { return this->Queues.nextKey(); }
  std::size_t waiting() const override { return this->Queues.size(); }
  std::size_t reached() const override { return this->FrontValues.numberOfReached(); }
  std::size_t numberOfValues() const override { return this->FrontValues.numberOfOwnValues(); }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  double meanLongestEdge() const override { return this->MeanLongestEdge; }

  void lower(const LabelAtVertex& place, double key, bool isAlong) override
  {
    if (isAlong)
    {
      this->FrontValues.template lower<Way::Along>(place, key);
    }
    else
    {
      this->FrontValues.template lower<Way::Across>(place, key);
    }
  }
  void updateRound(const LabelAtVertex& place) override { this->FrontValues.updateRound(place); }
  void take(Index item) override { this->FrontValues.take(item); }
  void visitWaiting(const std::function<void(Index vertex)>& visit) const override
  {
    this->Queues.visit(
      [&](Index item)
      {
        if (!Values::isNotice(item))
        {
          visit(this->FrontValues.vertexOf(item));
        }
      });
  }
  void giveUp(const std::function<void(Index item, Index vertex)>& give) override
  {
    this->Queues.remove(
      [&](Index item)
      {
        const Index vertex = this->FrontValues.vertexOf(item);
        const bool isGiven = !Values::isNotice(item) && !this->Share.owns(vertex);
        if (isGiven)
        {
          give(item, vertex);
        }
        return isGiven;
      });
  }

private:
  FrontQueues& Queues;
  const MarchControl& Control;
  double MeanLongestEdge;
  Values& FrontValues;
  const SharedMarch::Share& Share;
  Batches& March;
};

}

#endif
