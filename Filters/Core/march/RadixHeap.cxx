// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/RadixHeap.h"

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
  std::size_t level = this->Count;
  while (level > 0 && entry.bits >= this->Levels[level - 1].reference())
  {
    --level;
  }
  if (level < this->Count)
  {
    this->Levels[level].push(entry);
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
