// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontQueues_h
#define geodesic_FrontQueues_h

#include "base/Index.h"
#include "march/BucketQueue.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

/** The queues of some fronts of a march. */
struct FrontGroup
{
  /** Of values that are the best of their vertices. */
  BucketQueue best;
  /** Of others. */
  BucketQueue secondary;
};

/**
 * The queues of a march. Its fronts are in groups, which take turns: one goes on by a slice of
 * buckets, then the next. Many fronts together spread over more memory than the processor has near;
 * those of a group, that start beside each other, do not. Where the fronts of two groups meet, one
 * goes too far by a slice at most, which is work for nothing and no more, as the march is label
 * correcting. Where a bucket holds much, as where costs are low, that would be a lot of work: after
 * so many items a turn is over, and the others come as far.
 */
class FrontQueues
{
public:
  /** So many buckets a group goes on for at most: the more, the less often it has to be fetched;
   * and the secondary it goes in vain. */
  static constexpr std::uint64_t Slice = 20;
  /** So many items end a turn. */
  static constexpr std::size_t ItemsOfTurn = 1 << 15;

  /** @param width, span as BucketQueue::start() has them; @param wanted number of groups, at least
   * 1; there are fewer where together they would have too many buckets */
  void start(double width, double span, std::size_t wanted)
  {
    const std::size_t most = BucketQueue::MostBuckets / BucketQueue::numberOfBuckets(width, span);
    this->Groups.resize(std::clamp(wanted, std::size_t{ 1 }, most));
    for (FrontGroup& group : this->Groups)
    {
      group.best.start(width, span);
      group.secondary.start(width, span);
    }
    this->startSlice(0);
  }

  std::size_t numberOfGroups() const { return this->Groups.size(); }
  FrontGroup& group(std::size_t number) { return this->Groups[number]; }

  /** The bucket of a key, which may be infinite. */
  std::uint64_t bucketOf(double key) const { return this->anyQueue().bucketOf(key); }
  /** No key that waits is less; infinity where none does. */
  double nextKey() const
  {
    const std::uint64_t next = this->nextBucket();
    return next < None ? this->anyQueue().keyOf(next) : std::numeric_limits<double>::infinity();
  }

  /** Whether an item of a bucket before @p end waits; goes to the one whose turn it is. */
  bool hasBefore(std::uint64_t end)
  {
    while (!this->hasInSlice(end))
    {
      const std::uint64_t next = this->nextBucket();
      this->startSlice(std::min(next, end));
      if (next >= end)
      {
        return false;
      }
    }
    return true;
  }

  /** See BucketQueue::take(). @pre hasBefore */
  std::span<const Index> take(std::span<Index> room)
  {
    const std::span<const Index> taken = this->Current->take(room);
    this->Taken += taken.size();
    return taken;
  }
  /** See BucketQueue::next(). */
  std::span<const Index> next(std::size_t most) const { return this->Current->next(most); }

  /** Goes back so that a key of a group has its place again; see BucketQueue::goBackTo(). */
  void goBackTo(FrontGroup& group, double key)
  {
    group.best.goBackTo(key);
    group.secondary.goBackTo(key);
    this->startSlice(std::min(this->SliceStart, this->bucketOf(key)));
  }

private:
  static constexpr std::uint64_t None = std::numeric_limits<std::uint64_t>::max();

  /** All of them have the same buckets. */
  const BucketQueue& anyQueue() const { return this->Groups.front().best; }

  void startSlice(std::uint64_t bucket)
  {
    this->SliceStart = bucket;
    this->SliceEnd = bucket + Slice;
    this->Turn = 0;
    this->startTurn();
  }
  void startTurn()
  {
    this->Bucket = this->SliceStart;
    this->Taken = 0;
  }

  /** Goes on to what waits in buckets before @p end, of the slice. */
  bool hasInSlice(std::uint64_t end)
  {
    for (; this->Turn < this->Groups.size(); ++this->Turn)
    {
      FrontGroup& group = this->Groups[this->Turn];
      for (; this->Bucket < std::min(this->SliceEnd, end); ++this->Bucket)
      {
        if (this->Taken >= ItemsOfTurn)
        {
          this->SliceEnd = this->Bucket + 1;
          break;
        }
        // Best values first: what secondary ones are kept for depends on them.
        for (BucketQueue* queue : { &group.best, &group.secondary })
        {
          if (queue->hasBefore(this->Bucket + 1))
          {
            this->Current = queue;
            return true;
          }
        }
      }
      this->startTurn();
    }
    return false;
  }

  /** The first bucket in which something waits; None where nothing does. */
  std::uint64_t nextBucket() const
  {
    std::uint64_t next = None;
    for (const FrontGroup& group : this->Groups)
    {
      for (const BucketQueue* queue : { &group.best, &group.secondary })
      {
        next = queue->isEmpty() ? next : std::min(next, queue->nextBucket());
      }
    }
    return next;
  }

  std::vector<FrontGroup> Groups;
  BucketQueue* Current = nullptr;
  std::uint64_t SliceStart = 0;
  std::uint64_t SliceEnd = 0;
  /** Number of the group whose turn it is, the bucket that it is at, and what it has taken. */
  std::size_t Turn = 0;
  std::uint64_t Bucket = 0;
  std::size_t Taken = 0;
};

}

#endif
