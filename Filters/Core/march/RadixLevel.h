// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RadixLevel_h
#define geodesic_RadixLevel_h

#include "base/Index.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * A part of RadixHeap: entries whose keys are not below a reference, of which the first is the one
 * of the least key. The bits of numbers of at least 0 are in their order, so keys are compared by
 * the highest bit in which they differ from the reference. Where keys rise, an entry goes through a
 * few buckets of ever lower bits, each of which is read from front to back, where a heap would jump
 * about. What comes next is sorted. The reference rises with the first entry.
 * R. Ahuja, K. Mehlhorn, J. Orlin, R. Tarjan, Faster algorithms for the shortest path problem,
 * Journal of the ACM 37 (1990).
 */
class RadixLevel
{
public:
  struct Entry
  {
    std::uint64_t bits;
    Index item;

    double key() const { return std::bit_cast<double>(this->bits); }
  };
  /** The order of keys, from the largest one. */
  static bool isMore(const Entry& a, const Entry& b) { return a.bits > b.bits; }

  bool isEmpty() const { return this->Count == 0; }
  std::size_t size() const { return this->Count; }
  std::uint64_t reference() const { return this->Reference; }
  /** @pre !isEmpty() */
  const Entry& first() const { return this->Sorted.back(); }
  /** Entries that are likely to be the first ones soon, the last of them the first. */
  std::span<const Entry> next() const { return this->Sorted; }

  /** Removes all entries, and sets the reference. */
  void start(std::uint64_t reference)
  {
    this->Sorted.clear();
    for (std::size_t i = 0; i < this->Buckets.size(); ++i)
    {
      this->emptyBucket(i);
    }
    this->Reference = reference;
    this->Limit = reference;
    this->Count = 0;
  }

  /** @pre the key is not below the reference */
  void push(const Entry& entry)
  {
    ++this->Count;
    if (entry.bits >= this->Limit)
    {
      this->put(entry);
      this->provideFirst();
      return;
    }
    // Behind equal ones, of which there may be very many.
    const auto place = std::partition_point(this->Sorted.begin(), this->Sorted.end(),
      [&](const Entry& other) { return other.bits >= entry.bits; });
    this->Sorted.insert(place, entry);
    if (this->Sorted.size() > 2 * MostSorted)
    {
      this->unsortLast();
    }
  }

  /** Adds the entries of another level, which is empty then. @pre none is below the reference */
  void takeFrom(RadixLevel& other)
  {
    const auto takeAll = [&](std::vector<Entry>& entries) {
      std::for_each(entries.begin(), entries.end(), [&](const Entry& entry) { this->push(entry); });
    };
    takeAll(other.Sorted);
    std::for_each(other.Buckets.begin(), other.Buckets.end(), takeAll);
    other.start(0);
  }

  /** Removes the first entry. @pre !isEmpty() */
  void pop()
  {
    this->Sorted.pop_back();
    --this->Count;
    this->provideFirst();
  }

  /** Calls visit(item) for each item. */
  template <class Visit>
  void visit(const Visit& visit) const
  {
    const auto visitAll = [&](const std::vector<Entry>& entries) {
      std::for_each(entries.begin(), entries.end(), [&](const Entry& entry) { visit(entry.item); });
    };
    visitAll(this->Sorted);
    std::for_each(this->Buckets.begin(), this->Buckets.end(), visitAll);
  }

  /** Removes the entries for which isRemoved(entry) holds. @return how many there were */
  template <class Test>
  std::size_t remove(const Test& isRemoved)
  {
    std::size_t removed = std::erase_if(this->Sorted, isRemoved);
    for (std::size_t i = 0; i < this->Buckets.size(); ++i)
    {
      removed += std::erase_if(this->Buckets[i], isRemoved);
      if (this->Buckets[i].empty())
      {
        this->emptyBucket(i);
      }
    }
    this->Count -= removed;
    this->provideFirst();
    return removed;
  }

  std::size_t bytes() const
  {
    std::size_t entries = this->Sorted.capacity();
    for (const std::vector<Entry>& bucket : this->Buckets)
    {
      entries += bucket.capacity();
    }
    return sizeof(*this) + entries * sizeof(Entry);
  }

private:
  /** So many entries are sorted at once. */
  static constexpr std::size_t MostSorted = 10;
  /** Room for more entries is not kept in a bucket that is empty. */
  static constexpr std::size_t MostRoom = 4096;

  /** The number of the highest bit in which the bits of a key differ from the reference, from 1 on.
   */
  std::size_t bucketOf(std::uint64_t bits) const
  {
    return static_cast<std::size_t>(std::bit_width(bits ^ this->Reference));
  }
  /** The first bits above all that differ from some in the lowest @p count ones only. */
  static std::uint64_t endOfBlock(std::uint64_t bits, std::size_t count)
  {
    return ((bits >> count) + 1) << count;
  }

  void put(const Entry& entry)
  {
    const std::size_t bucket = this->bucketOf(entry.bits);
    this->Buckets[bucket].push_back(entry);
    this->Used |= std::uint64_t{ 1 } << bucket;
  }
  void emptyBucket(std::size_t number)
  {
    std::vector<Entry>& bucket = this->Buckets[number];
    bucket.clear();
    if (bucket.capacity() > MostRoom)
    {
      bucket.shrink_to_fit();
    }
    this->Used &= ~(std::uint64_t{ 1 } << number);
  }

  /** Provides the first entry, unless it is known or there is none. */
  void provideFirst()
  {
    if (this->Sorted.empty() && this->Used != 0)
    {
      this->sortNext();
    }
  }

  /** Sorts the entries of the first bucket; if they are many, those of a part of it.
   * @pre Sorted is empty, and some bucket is not */
  void sortNext()
  {
    while (true)
    {
      const auto first = static_cast<std::size_t>(std::countr_zero(this->Used));
      std::vector<Entry>& bucket = this->Buckets[first];
      this->Reference = std::max_element(bucket.begin(), bucket.end(), isMore)->bits;
      if (bucket.size() <= MostSorted || first == 0)
      {
        this->Limit = endOfBlock(this->Reference, first > 0 ? first - 1 : 0);
        std::swap(this->Sorted, bucket);
        std::sort(this->Sorted.begin(), this->Sorted.end(), isMore);
        this->emptyBucket(first);
        return;
      }
      // They all go to buckets before this one.
      for (const Entry& entry : bucket)
      {
        this->put(entry);
      }
      this->emptyBucket(first);
    }
  }

  /** Puts the later ones of many sorted entries into buckets. */
  void unsortLast()
  {
    const std::uint64_t middle = this->Sorted[this->Sorted.size() / 2].bits;
    // Very many may equal the reference.
    const std::size_t bits = middle > this->Reference ? this->bucketOf(middle) - 1 : 0;
    this->Limit = endOfBlock(this->Reference, bits);
    const auto end = std::partition_point(this->Sorted.begin(), this->Sorted.end(),
      [&](const Entry& entry) { return entry.bits >= this->Limit; });
    std::for_each(this->Sorted.begin(), end, [&](const Entry& entry) { this->put(entry); });
    this->Sorted.erase(this->Sorted.begin(), end);
    this->provideFirst();
  }

  /** The entries from the reference on and below the limit, the first one last. */
  std::vector<Entry> Sorted;
  /** The other ones, by the highest bit in which they differ from the reference. Bits of numbers
   * that are not negative have no highest one, so there are 63 such bits. */
  std::array<std::vector<Entry>, 64> Buckets;
  /** One bit for each bucket that is not empty. */
  std::uint64_t Used = 0;
  std::uint64_t Reference = 0;
  std::uint64_t Limit = 0;
  /** The number of all entries. */
  std::size_t Count = 0;
};

}

#endif
