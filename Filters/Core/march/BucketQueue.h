// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BucketQueue_h
#define geodesic_BucketQueue_h

#include "base/Index.h"
#include "march/RadixHeap.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

/** In which order a queue hands out items: roughly by increasing key, or strictly. */
enum class QueueOrder
{
  ByBucket,
  ByValue
};

/**
 * A queue that hands out items roughly by increasing key. It goes from bucket to bucket, which are
 * of equal width; within a bucket, items come in the order in which they were pushed. That is
 * enough for a label correcting march, whose result does not depend on the order. Time is constant
 * for an item. R. Dial, Algorithm 360, CACM 12 (1969).
 *
 * Where keys differ by orders of magnitude, nearly all of them share one bucket. For these the
 * order can be that of the keys: each key then is a bucket of its own, and an item takes time
 * O(log n).
 */
class BucketQueue
{
public:
  /** Largest number of buckets. */
  static constexpr std::size_t MostBuckets = 1 << 16;

  /** The number of buckets that start() makes, a power of two. */
  static std::size_t numberOfBuckets(double width, double span)
  {
    const double wanted = std::min(span / width + 2.0, static_cast<double>(MostBuckets));
    return std::bit_ceil(static_cast<std::size_t>(wanted));
  }

  /**
   * Empties the queue and goes to key 0.
   * @param width  of a bucket, more than 0
   * @param span   the most by which a pushed key exceeds the last one taken
   */
  void start(double width, double span, QueueOrder order = QueueOrder::ByBucket)
  {
    this->IsByValue = order == QueueOrder::ByValue;
    this->Heap.clear();
    const std::size_t buckets = numberOfBuckets(width, span);
    for (std::vector<Index>& bucket : this->Buckets)
    {
      bucket.clear();
    }
    if (this->Buckets.size() < buckets)
    {
      this->Buckets.resize(buckets);
    }
    this->LastIndex = this->Buckets.size() - 1;
    this->PerWidth = 1.0 / width;
    this->goTo(0);
    this->Next = 0;
    this->Count = 0;
  }

  bool isEmpty() const { return this->Count == 0; }
  /** Whether items come strictly by key. An item whose key falls should then be pushed again. */
  bool isByValue() const { return this->IsByValue; }

  /** Adds an item. With a key beyond the last bucket it goes into the last one, with a key before
   * the current bucket into the current one. */
  void push(Index item, double key)
  {
    ++this->Count;
    if (this->IsByValue)
    {
      this->Heap.push(item, key);
      return;
    }
    const double number = key * this->PerWidth;
    const std::int64_t bucket = number < this->LastNumber
      ? std::max(static_cast<std::int64_t>(number), static_cast<std::int64_t>(this->Current))
      : static_cast<std::int64_t>(this->Current + this->LastIndex);
    this->bucket(static_cast<std::uint64_t>(bucket)).push_back(item);
  }

  /** Whether an item that waits with the key @p before is taken sooner if it is pushed once more
   * with @p key. */
  bool comesSooner(double key, double before) const
  {
    return this->IsByValue ? key < before : this->bucketOf(key) < this->bucketOf(before);
  }

  /** The number of a key's bucket; the key may be infinite. */
  std::uint64_t bucketOf(double key) const
  {
    if (this->IsByValue)
    {
      return RadixHeap::bitsOf(key);
    }
    constexpr double last = 1ull << 62;
    return static_cast<std::uint64_t>(std::clamp(key * this->PerWidth, 0.0, last));
  }

  /** Whether an item waits in a bucket before @p end. Goes to the first such bucket, or else to
   * @p end. */
  bool hasBefore(std::uint64_t end)
  {
    if (this->IsByValue)
    {
      this->End = end;
      return !this->isEmpty() && this->nextBucket() < end;
    }
    if (this->isEmpty())
    {
      this->bucket(this->Current).clear();
      this->Next = 0;
      this->goTo(std::max(this->Current, end));
      return false;
    }
    while (this->Current < end && this->Next == this->bucket(this->Current).size())
    {
      this->bucket(this->Current).clear();
      this->Next = 0;
      this->goTo(this->Current + 1);
    }
    return this->Current < end;
  }

  /**
   * Goes back to the bucket of a key, so that keys from there on have their places again, if the
   * key is below the last one taken. Does nothing if that would need more than MostBuckets buckets.
   * Where more than a thousand items wait in the current bucket, their order changes. Time linear
   * in the number of buckets gone back, and of items taken since the last time; or of all buckets
   * if there are too few.
   */
  void goBackTo(double key)
  {
    const std::uint64_t target = this->bucketOf(key);
    if (this->IsByValue || target >= this->Current)
    {
      return;
    }
    this->dropTaken();
    if (this->isEmpty() || this->isFree(target))
    {
      this->goTo(target);
      return;
    }
    std::uint64_t end = this->Current + this->Buckets.size();
    while (end > this->Current && this->bucket(end - 1).empty())
    {
      --end;
    }
    const std::uint64_t wanted = end - target + 1;
    if (wanted > MostBuckets)
    {
      return;
    }
    if (wanted > this->Buckets.size())
    {
      std::vector<std::vector<Index>> buckets(std::bit_ceil(wanted));
      for (std::uint64_t number = this->Current; number < end; ++number)
      {
        buckets[number & (buckets.size() - 1)] = std::move(this->bucket(number));
      }
      this->Buckets = std::move(buckets);
      this->LastIndex = this->Buckets.size() - 1;
    }
    this->goTo(target);
  }

  /** How many items wait. */
  std::size_t size() const { return this->Count; }
  /** How many of them wait in the current bucket; not if items come by value. */
  std::size_t sizeOfBucket() const
  {
    return this->Buckets[this->indexOf(this->Current)].size() - this->Next;
  }

  /** Calls visit(item) for each item that waits. */
  template <class Visit>
  void visit(const Visit& visit) const
  {
    for (std::uint64_t number = 0; number < this->Buckets.size(); ++number)
    {
      const std::vector<Index>& bucket = this->Buckets[number];
      const bool isCurrent = number == this->indexOf(this->Current);
      std::for_each(bucket.begin() + (isCurrent ? this->taken() : 0), bucket.end(), visit);
    }
    this->Heap.visit(visit);
  }
  /** Removes the items that wait and for which isRemoved(item) holds, in the order of buckets. What
   * waits in the current bucket may change its order. */
  template <class Test>
  void remove(const Test& isRemoved)
  {
    this->dropTaken();
    for (std::vector<Index>& bucket : this->Buckets)
    {
      this->Count -= std::erase_if(bucket, isRemoved);
    }
    this->Count -= this->Heap.remove(isRemoved);
  }

  /** The number of the first bucket in which an item waits. @pre !isEmpty() */
  std::uint64_t nextBucket() const
  {
    if (this->IsByValue)
    {
      return this->Heap.first().bits;
    }
    std::uint64_t number = this->Current;
    std::size_t taken = this->Next;
    while (taken == this->Buckets[this->indexOf(number)].size())
    {
      ++number;
      taken = 0;
    }
    return number;
  }
  /** The least key of a bucket. */
  double keyOf(std::uint64_t bucket) const
  {
    return this->IsByValue ? std::bit_cast<double>(bucket)
                           : static_cast<double>(bucket) / this->PerWidth;
  }

  /**
   * Takes items from the current bucket; by value, from the first ones before the end that
   * hasBefore() was given.
   * @param room  for the items; as many are taken as fit, or all of the bucket; by value, a few
   * @param isWaiting  tells whether an item was not taken since it was pushed last; by value,
   *                   others are left out
   * @param areApart   tells whether an item gains nothing by some others; by value, an item that
   *                   may gain is not taken with them
   * @return the part of @p room that holds them; none if, by value, none of those looked at is
   * waiting
   * @pre hasBefore() was true
   */
  template <class IsWaiting, class AreApart>
  std::span<const Index> take(
    std::span<Index> room, const IsWaiting& isWaiting, const AreApart& areApart)
  {
    if (this->IsByValue)
    {
      std::size_t taken = 0;
      do
      {
        const Index item = this->Heap.first().item;
        const bool counts = isWaiting(item);
        if (counts && !areApart(item, room.first(taken)))
        {
          break;
        }
        this->Heap.pop();
        --this->Count;
        room[taken] = item;
        taken += counts ? 1 : 0;
      } while (taken < std::min(room.size(), MostByValue) && !this->Heap.isEmpty() &&
        this->Heap.first().bits < this->End);
      return room.first(taken);
    }
    const std::size_t taken = std::min(room.size(), this->sizeOfBucket());
    std::copy_n(&this->bucket(this->Current)[this->Next], taken, room.data());
    this->Next += taken;
    this->Count -= taken;
    return room.first(taken);
  }

  /** The same, of all items. */
  std::span<const Index> take(std::span<Index> room)
  {
    return this->take(
      room, [](Index) { return true; }, [](Index, std::span<const Index>) { return true; });
  }

  /**
   * Items that are likely to be taken after the next @p skip ones, without taking them: those of
   * the current bucket, then of the one behind it. By value, some of those that are sorted; none if
   * some are to be skipped.
   * @param room  for the items, as many as fit
   * @return the part of @p room that holds them
   */
  std::span<const Index> upcoming(std::size_t skip, std::span<Index> room) const
  {
    if (this->IsByValue)
    {
      const std::span<const RadixHeap::Entry> entries = this->Heap.next();
      const std::size_t count = skip > 0 ? 0 : std::min(room.size(), entries.size());
      std::transform(entries.rbegin(), entries.rbegin() + static_cast<std::ptrdiff_t>(count),
        room.begin(), [](const RadixHeap::Entry& entry) { return entry.item; });
      return room.first(count);
    }
    if (this->Count <= skip)
    {
      return {};
    }
    std::size_t filled = 0;
    std::size_t first = this->Next + skip;
    for (std::uint64_t number = this->Current; number <= this->Current + 1; ++number)
    {
      const std::vector<Index>& items = this->Buckets[this->indexOf(number)];
      if (first < items.size())
      {
        const std::size_t count = std::min(room.size() - filled, items.size() - first);
        std::copy_n(items.data() + first, count, room.data() + filled);
        filled += count;
      }
      first -= std::min(first, items.size());
    }
    return room.first(filled);
  }

  /** The memory of the items, also of those that have room only. Time linear in the number of
   * buckets. */
  std::size_t bytes() const
  {
    std::size_t items = 0;
    for (const std::vector<Index>& bucket : this->Buckets)
    {
      items += bucket.capacity();
    }
    return items * sizeof(Index) + this->Heap.bytes();
  }

private:
  /** How many items are taken at a time by value: of more, later ones would often gain by the first
   * ones. */
  static constexpr std::size_t MostByValue = 4;

  void goTo(std::uint64_t number)
  {
    this->Current = number;
    this->LastNumber = static_cast<double>(number + this->LastIndex);
  }

  /** Whether there is room for the buckets from an earlier one up to the current one: no item waits
   * in those whose places they take. */
  bool isFree(std::uint64_t earlier) const
  {
    bool isFree = this->Current - earlier <= this->LastIndex;
    for (std::uint64_t number = earlier; isFree && number < this->Current; ++number)
    {
      isFree = this->Buckets[this->indexOf(number)].empty();
    }
    return isFree;
  }

  std::ptrdiff_t taken() const { return static_cast<std::ptrdiff_t>(this->Next); }
  /** Drops those items of the current bucket that were taken. Where many others are left, the last
   * ones take their places; few keep their order, in which fewer updates are made twice. */
  void dropTaken()
  {
    constexpr std::size_t few = 1024;
    std::vector<Index>& current = this->bucket(this->Current);
    const std::size_t left = current.size() - this->Next;
    const std::size_t moved = left <= few ? left : std::min(this->Next, left);
    std::copy_n(current.end() - static_cast<std::ptrdiff_t>(moved), moved, current.begin());
    current.resize(left);
    this->Next = 0;
  }

  std::size_t indexOf(std::uint64_t number) const { return number & this->LastIndex; }
  std::vector<Index>& bucket(std::uint64_t number) { return this->Buckets[this->indexOf(number)]; }

  std::vector<std::vector<Index>> Buckets;
  /** The number of buckets, which is a power of two, less 1. */
  std::uint64_t LastIndex = 0;
  double PerWidth = 1.0;
  /** The number of the current bucket. */
  std::uint64_t Current = 0;
  /** The number of the last bucket for which there is room. */
  double LastNumber = 0.0;
  /** How many items of the current bucket have been taken. */
  std::size_t Next = 0;
  /** How many items wait. */
  std::size_t Count = 0;
  /** What waits if items come by value. */
  RadixHeap Heap;
  bool IsByValue = false;
  /** By value, the end that hasBefore() was given last. */
  std::uint64_t End = 0;
};

}

#endif
