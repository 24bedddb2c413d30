// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedFront_h
#define geodesic_SharedFront_h

#include "march/FrontQueues.h"
#include "march/SharedValues.h"
#include "solve/MarchControl.h"
#include "solve/MarchingFront.h"
#include "threads/ThreadFront.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace geodesic
{

/**
 * A thread's part of a march of FastMarchingSolver as a ThreadFront, which a SharedMarch drives.
 * @tparam Batches  a BatchedMarch
 */
template <class Cost, class Batches>
class SharedFront final : public ThreadFront
{
public:
  /** @param meanLongestEdge  see MarchingFront */
  SharedFront(FrontQueues& queues, const MarchControl& control, double meanLongestEdge,
    SharedValues<Cost>& values, SharedMarch::Share& share, Batches& batches)
    : Queues(queues)
    , Control(control)
    , MeanLongestEdge(meanLongestEdge)
    , FrontValues(values)
    , Share(share)
    , March(batches)
  {
  }

  void advance(double limit) override
  {
    this->March.advance(this->Queues.endOfMarch(limit), nullptr);
  }
  void advanceWhile(double limit, const std::function<bool()>& mayGoOn) override
  {
    this->March.advanceWhile(this->Queues.endOfMarch(limit), nullptr, mayGoOn);
  }
  void visitAtBorder(const std::function<void(Index)>& visit) override
  {
    this->FrontValues.visitAtBorder(visit);
  }
  double next() const override { return this->Queues.nextKey(); }
  std::size_t waiting() const override { return this->queue().size(); }
  std::size_t reached() const override { return this->FrontValues.numberOfReached(); }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  double meanLongestEdge() const override { return this->MeanLongestEdge; }
  double value(Index vertex) const override { return this->FrontValues.value(vertex); }

  void goBackTo(double value) override { this->Queues.goBackTo(this->Queues.group(0), value); }
  void lower(Index vertex, double value) override
  {
    this->FrontValues.template propose<Way::Along>(this->FrontValues.label(), vertex, value);
  }
  void updateRound(Index vertex) override { this->FrontValues.queueNotice(vertex); }
  void take(Index vertex) override { this->FrontValues.takeOver(vertex); }
  void visitWaiting(const std::function<void(Index)>& visit) const override
  {
    this->queue().visit(
      [&](Index item)
      {
        if (!this->FrontValues.isNotice(item))
        {
          visit(item);
        }
      });
  }
  void giveUp(const std::function<void(Index)>& give) override
  {
    this->queue().remove(
      [&](Index item)
      {
        const bool isGiven = !this->FrontValues.isNotice(item) && !this->Share.owns(item);
        if (isGiven)
        {
          give(item);
        }
        return isGiven;
      });
  }

private:
  BucketQueue& queue() const { return this->Queues.group(0).best; }

  FrontQueues& Queues;
  const MarchControl& Control;
  double MeanLongestEdge;
  SharedValues<Cost>& FrontValues;
  SharedMarch::Share& Share;
  Batches& March;
};

}

#endif
