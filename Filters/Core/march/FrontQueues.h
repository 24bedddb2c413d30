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
#include <numeric>
#include <span>
#include <vector>

namespace geodesic
{

/** The queues of a group of fronts. */
struct FrontGroup
{
  /** For best values of vertices. */
  BucketQueue best;
  /** For secondary values. */
  BucketQueue secondary;
};

/**
 * The queues of a march. Its fronts are in groups, which take turns: one group goes on by a slice
 * of buckets, then the next one. Many fronts together use more memory than the processor's caches
 * hold; the fronts of a group, which start near each other, do not. Where the fronts of two groups
 * meet, one goes too far, by a slice at most. That is work for nothing but does no harm, as the
 * march is label correcting. The fronts of one label that start all over the surface are in groups
 * of the vertices where they wait. If buckets hold many items, as where costs are low, it would be
 * much work. So a turn also ends after a number of items, and the other groups then go on as far as
 * this one did.
 */
class FrontQueues
{
public:
  /** Largest number of buckets in a turn. The larger it is, the less often a group's memory has to
   * be fetched into the caches, and the farther fronts go for nothing where groups meet. */
  static constexpr std::uint64_t Slice = 20;
  /** Number of items after which a turn ends. */
  static constexpr std::size_t ItemsOfTurn = 1 << 15;
  /** Vertices whose numbers differ in their lowest so many bits only are one group of dense fronts:
   * their values, rings and positions are in a core's own cache together. With 10,000 seeds on an
   * icosphere of 160,000 points a quarter less time (worst_cases.md). */
  static constexpr int BitsOfDenseGroup = 13;
  static constexpr std::size_t VerticesOfDenseGroup = std::size_t{ 1 } << BitsOfDenseGroup;

  /**
   * Empties the queues.
   * @param width, span, order  see BucketQueue::start()
   * @param wanted       number of groups, at least 1; there are fewer if they would have more than
   *                     BucketQueue::MostBuckets buckets together
   */
  void start(double width, double span, std::size_t wanted, QueueOrder order = QueueOrder::ByBucket)
  {
    const std::size_t most = BucketQueue::MostBuckets / BucketQueue::numberOfBuckets(width, span);
    this->Groups.resize(std::clamp(wanted, std::size_t{ 1 }, most));
    for (FrontGroup& group : this->Groups)
    {
      group.best.start(width, span, order);
      group.secondary.start(width, span, order);
    }
    this->BitsOfGroup = std::numeric_limits<Index>::digits;
    this->startSlice(0);
  }

  /** After start(): makes the groups those of vertices instead of those of fronts.
   * @return false, with nothing done, if there is not one for each VerticesOfDenseGroup of them */
  bool groupByVertex(std::size_t numberOfVertices)
  {
    if (this->Groups.size() * VerticesOfDenseGroup < numberOfVertices)
    {
      return false;
    }
    this->BitsOfGroup = BitsOfDenseGroup;
    return true;
  }
  /** Makes groups those of vertices if they are so in other queues, with as many groups. */
  void groupAs(const FrontQueues& others) { this->BitsOfGroup = others.BitsOfGroup; }
  /** The group of what waits at a vertex; 0 unless groups are those of vertices. */
  Index groupOfVertex(Index vertex) const
  {
    return static_cast<Index>(std::uint64_t{ vertex } >> this->BitsOfGroup);
  }

  std::size_t numberOfGroups() const { return this->Groups.size(); }
  FrontGroup& group(std::size_t number) { return this->Groups[number]; }

  /** See BucketQueue::comesSooner(). */
  bool comesSooner(double key, double before) const
  {
    return this->anyQueue().comesSooner(key, before);
  }

  /** The number of a key's bucket; the key may be infinite. */
  std::uint64_t bucketOf(double key) const { return this->anyQueue().bucketOf(key); }
  /** The bucket behind those that a march up to a key goes through. These are the buckets before
   * the key's, and in any case the first in which an item waits, if it begins before the key: a
   * bucket can be wider than the step of a march that goes on step by step. */
  std::uint64_t endOfMarch(double key) const
  {
    const std::uint64_t end = this->bucketOf(key);
    return this->nextKey() < key ? std::max(end, this->nextBucket() + 1) : end;
  }
  /** A lower bound of the keys that wait: the least key of the first bucket in which an item waits;
   * infinity if none waits. */
  double nextKey() const
  {
    const std::uint64_t next = this->nextBucket();
    return next < None ? this->anyQueue().keyOf(next) : std::numeric_limits<double>::infinity();
  }

  /** Whether an item waits in a bucket before @p end. Goes to the queue whose turn it is. */
  bool hasBefore(std::uint64_t end)
  {
    if (this->anyQueue().isByValue())
    {
      return this->hasByValue(end);
    }
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

  /** See BucketQueue::take(). @pre hasBefore() was true */
  template <class... Tests>
  std::span<const Index> take(std::span<Index> room, const Tests&... tests)
  {
    const std::span<const Index> taken = this->Current->take(room, tests...);
    this->Taken += taken.size();
    return taken;
  }
  /** See BucketQueue::upcoming(). */
  std::span<const Index> upcoming(std::size_t skip, std::span<Index> room) const
  {
    return this->Current->upcoming(skip, room);
  }

  /** How many items wait. */
  std::size_t size() const
  {
    return std::accumulate(this->Groups.begin(), this->Groups.end(), std::size_t{ 0 },
      [](std::size_t count, const FrontGroup& group)
      { return count + group.best.size() + group.secondary.size(); });
  }
  /** Calls visit(item) for each item that waits. */
  template <class Visit>
  void visit(const Visit& visit) const
  {
    for (const FrontGroup& group : this->Groups)
    {
      group.best.visit(visit);
      group.secondary.visit(visit);
    }
  }
  /** Removes the items that wait and for which isRemoved(item) holds. */
  template <class Test>
  void remove(const Test& isRemoved)
  {
    for (FrontGroup& group : this->Groups)
    {
      group.best.remove(isRemoved);
      group.secondary.remove(isRemoved);
    }
  }

  /** Goes back to the bucket of a key in the queues of a group; see BucketQueue::goBackTo(). */
  void goBackTo(FrontGroup& group, double key)
  {
    group.best.goBackTo(key);
    group.secondary.goBackTo(key);
    // Within the slice the queue is found to be back when its group's turn goes on, or the next
    // one.
    if (this->bucketOf(key) < this->SliceStart)
    {
      this->startSlice(this->bucketOf(key));
    }
  }

  /** The same if the key is more than a few buckets behind where the march has come to. Else items
   * with that key are taken from the present bucket, together with others. */
  void goBackIfFar(FrontGroup& group, double key)
  {
    constexpr std::uint64_t few = 2;
    if (this->bucketOf(key) + few < this->Bucket)
    {
      this->goBackTo(group, key);
    }
  }

private:
  static constexpr std::uint64_t None = std::numeric_limits<std::uint64_t>::max();

  /** Any of the queues: in all of them buckets have the same numbers and keys. */
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

  /** Whether an item waits in a bucket of the slice before @p end. Goes to its queue, and begins
   * the next group's turn if the present one is over. */
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
        // Best values come first: whether a vertex keeps a secondary value depends on them.
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

  /** As hasBefore(), if items come by value: it is the turn of the queue with the least key, of
   * equal ones that of best values. */
  bool hasByValue(std::uint64_t end)
  {
    this->Current = nullptr;
    std::uint64_t least = None;
    for (FrontGroup& group : this->Groups)
    {
      for (BucketQueue* queue : { &group.best, &group.secondary })
      {
        if (queue->hasBefore(end) && queue->nextBucket() < least)
        {
          least = queue->nextBucket();
          this->Current = queue;
        }
      }
    }
    return this->Current != nullptr;
  }

  /** The number of the first bucket in which an item waits; None if none waits. */
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
  /** By so many bits a vertex's number is shifted to its group. */
  int BitsOfGroup = std::numeric_limits<Index>::digits;
  /** The queue from which items are taken. */
  BucketQueue* Current = nullptr;
  /** The first bucket of the slice, and the first one behind it. */
  std::uint64_t SliceStart = 0;
  std::uint64_t SliceEnd = 0;
  /** The number of the group whose turn it is, the bucket that it has come to, and the number of
   * items that it has taken. */
  std::size_t Turn = 0;
  std::uint64_t Bucket = 0;
  std::size_t Taken = 0;
};

}

#endif
