// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/RadixHeap.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace geodesic
{

void RadixHeap::clear()
{
  this->Below.clear();
  while (this->Count > 0)
  {
    this->last().start(0);
    --this->Count;
  }
}

void RadixHeap::push(Index item, double key)
{
  const Entry entry{ bitsOf(key), item };
  const auto end = this->Levels.begin() + static_cast<std::ptrdiff_t>(this->Count);
  const auto level = std::partition_point(this->Levels.begin(), end,
    [&](const RadixLevel& other) { return other.reference() > entry.bits; });
  if (level != end)
  {
    level->push(entry);
    return;
  }
  this->Below.push_back(entry);
  std::push_heap(this->Below.begin(), this->Below.end(), RadixLevel::isMore);
  if (this->Below.size() > MostBelow)
  {
    this->addLevel();
  }
}

void RadixHeap::pop()
{
  if (!this->Below.empty())
  {
    std::pop_heap(this->Below.begin(), this->Below.end(), RadixLevel::isMore);
    this->Below.pop_back();
    return;
  }
  this->last().pop();
  this->dropEmpty();
}

std::size_t RadixHeap::bytes() const
{
  std::size_t bytes = this->Below.capacity() * sizeof(Entry);
  for (const RadixLevel& level : this->Levels)
  {
    bytes += level.bytes();
  }
  return bytes;
}

void RadixHeap::addLevel()
{
  if (this->Count == this->Levels.size())
  {
    this->Levels.emplace_back();
  }
  RadixLevel& added = this->Levels[this->Count];
  ++this->Count;
  added.start(this->Below.front().bits);
  for (const Entry& entry : this->Below)
  {
    added.push(entry);
  }
  this->Below.clear();
  while (this->Count > 1 && this->Levels[this->Count - 2].size() <= 2 * this->last().size())
  {
    RadixLevel& before = this->Levels[this->Count - 2];
    this->last().takeFrom(before);
    std::swap(before, this->last());
    --this->Count;
  }
}

void RadixHeap::dropEmpty()
{
  while (this->Count > 0 && this->last().isEmpty())
  {
    --this->Count;
  }
}

}
