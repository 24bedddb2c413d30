// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_KeyHeap_h
#define geodesic_KeyHeap_h

#include "base/Index.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace geodesic
{

/**
 * Items with keys, of which the first is the one of the least key. It is a heap in which an entry
 * has four others below it: they share a line of the processor's caches, and an entry passes half
 * as many lines as in a binary heap. D. B. Johnson, Priority queues with update and finding minimum
 * spanning trees, Information Processing Letters 4 (1975). An item takes time O(log n). Marches by
 * value take 5 to 25 % less time than with std::push_heap() (rows of random costs in
 * worst_cases.md).
 */
class KeyHeap
{
public:
  struct Entry
  {
    double key;
    Index item;
  };

  bool isEmpty() const { return this->Entries.empty(); }
  const Entry& first() const { return this->Entries.front(); }
  const std::vector<Entry>& entries() const { return this->Entries; }
  void clear() { this->Entries.clear(); }

  void push(Index item, double key)
  {
    this->Entries.emplace_back();
    this->rise(this->Entries.size() - 1, { key, item });
  }

  /** Removes the first entry. @pre !isEmpty() */
  void pop()
  {
    const Entry last = this->Entries.back();
    this->Entries.pop_back();
    if (!this->Entries.empty())
    {
      // The last one mostly belongs near the end again, so it rises from there.
      this->rise(this->holeAtEnd(0), last);
    }
  }

  /** Removes the entries of items for which isRemoved(item) holds. @return how many there were */
  template <class Test>
  std::size_t remove(const Test& isRemoved)
  {
    const std::size_t removed =
      std::erase_if(this->Entries, [&](const Entry& entry) { return isRemoved(entry.item); });
    // An order by key is a heap.
    std::sort(this->Entries.begin(), this->Entries.end(),
      [](const Entry& a, const Entry& b) { return a.key < b.key; });
    return removed;
  }

  std::size_t bytes() const { return this->Entries.capacity() * sizeof(Entry); }

private:
  static constexpr std::size_t Below = 4;

  /** Puts an entry into a place, or a place above it, from where others then move down. */
  void rise(std::size_t place, const Entry& entry)
  {
    while (place > 0 && entry.key < this->Entries[(place - 1) / Below].key)
    {
      this->Entries[place] = this->Entries[(place - 1) / Below];
      place = (place - 1) / Below;
    }
    this->Entries[place] = entry;
  }

  /** Moves the least of the entries below an empty place up, and so on. @return the empty place at
   * the end */
  std::size_t holeAtEnd(std::size_t place)
  {
    for (std::size_t below = Below * place + 1; below < this->Entries.size();
         below = Below * place + 1)
    {
      const auto first = this->Entries.begin() + static_cast<std::ptrdiff_t>(below);
      const std::size_t count = std::min(Below, this->Entries.size() - below);
      const auto least = std::min_element(first, first + static_cast<std::ptrdiff_t>(count),
        [](const Entry& a, const Entry& b) { return a.key < b.key; });
      this->Entries[place] = *least;
      place = static_cast<std::size_t>(least - this->Entries.begin());
    }
    return place;
  }

  std::vector<Entry> Entries;
};

}

#endif
