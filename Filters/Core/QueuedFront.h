#ifndef geodesic_QueuedFront_h
#define geodesic_QueuedFront_h

#include "BucketQueue.h"
#include "DistanceField.h"
#include "MarchControl.h"
#include "MarchingFront.h"

#include <cstddef>
#include <utility>

namespace geodesic
{

/** Width of the queue's buckets, in edges of TriangleMesh::meanLongestEdge(); 0.1 to 0.5 serve
 * about equally well. */
constexpr double BucketWidthInEdges = 0.25;

/** A march as a Partition sees it; @p Values and @p advance are the march. */
template <class Values, class Advance>
class QueuedFront final : public MarchingFront
{
public:
  /** @param firstDistance the distance of the queue's key 0 */
  QueuedFront(BucketQueue& queue, const MarchControl& control, double firstDistance, Values& values,
    Advance advance)
    : Queue(queue)
    , Control(control)
    , FirstDistance(firstDistance)
    , FrontValues(values)
    , AdvanceBefore(std::move(advance))
  {
  }

  void advance(double limit) override
  {
    this->AdvanceBefore(this->Queue.bucketOf(limit - this->FirstDistance));
  }

  double nextDistance() const override
  {
    return this->Queue.isEmpty() ? DistanceField::Unreached
                                 : this->FirstDistance + this->Queue.nextKey();
  }

  double meanLongestEdge() const override { return this->Queue.width() / BucketWidthInEdges; }
  std::size_t numberOfUpdates() const override { return this->Control.count(); }
  bool isCancelled() const override { return this->Control.isCancelled(); }

  void visitValues(Index vertex, const Visit& visit) const override
  {
    this->FrontValues.visit(vertex, visit);
  }

  void lower(Index vertex, Index label, double value) override
  {
    const auto& marched = this->FrontValues.label(label);
    this->Queue.goBackTo(marched.distance(value) - this->FirstDistance);
    this->FrontValues.propose(marched, vertex, value);
  }

private:
  BucketQueue& Queue;
  const MarchControl& Control;
  double FirstDistance;
  Values& FrontValues;
  Advance AdvanceBefore;
};

}

#endif
