// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RadixHeap_h
#define geodesic_RadixHeap_h

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
 * Items with keys of at least 0, of which the first is the one of the least key. The bits of such
 * numbers are in their order, so keys are compared by the highest bit in which they differ from a
 * reference. Where keys rise, as they mostly do in a march, an entry goes through a few buckets of
 * ever lower bits, each of which is read from front to back, where a heap would jump about. What
 * comes next is sorted. R. Ahuja, K. Mehlhorn, J. Orlin, R. Tarjan, Faster algorithms for the
 * shortest path problem, Journal of the ACM 37 (1990).
 *
 * A key may also be below those taken before. An item takes time O(64), and O(n / 4096) where n
 * such keys come one after the other. Marches by value take 10 % less time than with a heap of four
 * entries below each (rows of random costs in worst_cases.md).
 */
class RadixHeap
{
public:
  struct Entry
  {
    std::uint64_t bits;
    Index item;

    double key() const { return std::bit_cast<double>(this->bits); }
  };

  bool isEmpty() const { return this->Sorted.empty(); }
  /** @pre !isEmpty() */
  const Entry& first() const { return this->Sorted.back(); }
  /** The entries that are likely to be the first ones soon, the last of them the first. */
  std::span<const Entry> next() const { return this->Sorted; }

  void clear()
  {
    this->Sorted.clear();
    for (std::vector<Entry>& bucket : this->Buckets)
    {
      bucket.clear();
    }
    this->Used = 0;
    this->Reference = 0;
    this->Limit = 0;
  }

  void push(Index item, double key)
  {
    const Entry entry{ std::bit_cast<std::uint64_t>(std::max(key, 0.0)), item };
    if (entry.bits >= this->Limit)
    {
      this->put(entry);
      if (this->Sorted.empty())
      {
        this->sortNext();
      }
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

  /** Removes the first entry. @pre !isEmpty() */
  void pop()
  {
    this->Sorted.pop_back();
    if (this->Sorted.empty() && this->Used != 0)
    {
      this->sortNext();
    }
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

  /** Removes the items for which isRemoved(item) holds. @return how many there were */
  template <class Test>
  std::size_t remove(const Test& isRemoved)
  {
    const auto test = [&](const Entry& entry) { return isRemoved(entry.item); };
    std::size_t removed = std::erase_if(this->Sorted, test);
    for (std::size_t i = 0; i < this->Buckets.size(); ++i)
    {
      removed += std::erase_if(this->Buckets[i], test);
      this->noteUse(i);
    }
    if (this->Sorted.empty() && this->Used != 0)
    {
      this->sortNext();
    }
    return removed;
  }

  std::size_t bytes() const
  {
    std::size_t entries = this->Sorted.capacity();
    for (const std::vector<Entry>& bucket : this->Buckets)
    {
      entries += bucket.capacity();
    }
    return entries * sizeof(Entry);
  }

private:
  /** So many entries are sorted at once. */
  static constexpr std::size_t MostSorted = 10;
  /** As many keys may come that are below those taken before. */
  static constexpr std::size_t MostBelow = 4096;

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
  void noteUse(std::size_t bucket)
  {
    const std::uint64_t bit = std::uint64_t{ 1 } << bucket;
    this->Used = this->Buckets[bucket].empty() ? this->Used & ~bit : this->Used | bit;
  }

  /** Sorts the entries of the first bucket; if they are many, those of a part of it.
   * @pre Sorted is empty, and some bucket is not */
  void sortNext()
  {
    while (true)
    {
      const auto first = static_cast<std::size_t>(std::countr_zero(this->Used));
      std::vector<Entry>& bucket = this->Buckets[first];
      const auto isLess = [](const Entry& a, const Entry& b) { return a.bits < b.bits; };
      this->Reference = std::min_element(bucket.begin(), bucket.end(), isLess)->bits;
      if (bucket.size() <= MostSorted || first == 0)
      {
        this->Limit = endOfBlock(this->Reference, first > 0 ? first - 1 : 0);
        std::swap(this->Sorted, bucket);
        std::sort(this->Sorted.begin(), this->Sorted.end(),
          [&](const Entry& a, const Entry& b) { return isLess(b, a); });
        this->noteUse(first);
        return;
      }
      // They all go to buckets before this one.
      for (const Entry& entry : bucket)
      {
        this->put(entry);
      }
      bucket.clear();
      this->noteUse(first);
    }
  }

  /** Puts the later ones of many sorted entries into buckets. */
  void unsortLast()
  {
    const std::uint64_t middle = this->Sorted[this->Sorted.size() / 2].bits;
    if (middle > this->Reference)
    {
      this->Limit = endOfBlock(this->Reference, this->bucketOf(middle) - 1);
      const auto end = std::partition_point(this->Sorted.begin(), this->Sorted.end(),
        [&](const Entry& entry) { return entry.bits >= this->Limit; });
      std::for_each(this->Sorted.begin(), end, [&](const Entry& entry) { this->put(entry); });
      this->Sorted.erase(this->Sorted.begin(), end);
      if (this->Sorted.empty())
      {
        this->sortNext();
      }
    }
    else if (this->Sorted.size() > MostBelow && this->Sorted.back().bits < this->Reference)
    {
      this->beginAnew();
    }
  }

  /** Makes the least key the reference. */
  void beginAnew()
  {
    std::vector<Entry> all = std::move(this->Sorted);
    for (std::vector<Entry>& bucket : this->Buckets)
    {
      all.insert(all.end(), bucket.begin(), bucket.end());
    }
    const std::uint64_t least = std::min_element(all.begin(), all.end(),
      [](const Entry& a, const Entry& b)
      { return a.bits < b.bits; })->bits;
    this->clear();
    this->Reference = least;
    for (const Entry& entry : all)
    {
      this->put(entry);
    }
    this->sortNext();
  }

  /** The entries below the limit, the first one last. */
  std::vector<Entry> Sorted;
  /** The other ones, by the highest bit in which they differ from the reference. Bits of numbers
   * that are not negative have no highest one, so there are 63 such bits. */
  std::array<std::vector<Entry>, 64> Buckets;
  /** One bit for each bucket that is not empty. */
  std::uint64_t Used = 0;
  std::uint64_t Reference = 0;
  std::uint64_t Limit = 0;
};

}

#endif
