// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/Junctions.h"

#include "mesh/EdgeTable.h"
#include "solve/PassableTriangles.h"

#include <algorithm>

namespace geodesic
{

Junctions::Junction& Junctions::at(
  const EdgeTable& edges, const PassableTriangles& passable, Index halfEdge)
{
  const auto [place, isNew] =
    this->Places.try_emplace(edges.first(halfEdge), static_cast<Index>(this->All.size()));
  if (!isNew)
  {
    return this->All[place->second];
  }
  Junction& junction = this->All.emplace_back();
  Index side = halfEdge;
  do
  {
    if (passable.contains(EdgeTable::triangleOf(side)))
    {
      junction.sides.push_back(side);
    }
    side = edges.next(side);
  } while (side != halfEdge);
  return junction;
}

bool Junctions::wait(const EdgeTable& edges, const PassableTriangles& passable, Index halfEdge,
  std::span<const Window> windows, double key)
{
  Junction& junction = this->at(edges, passable, halfEdge);
  const bool isNearer = junction.waiting.empty() || key < junction.key;
  const std::size_t before = junction.waiting.capacity();
  for (const Window& window : windows)
  {
    junction.waiting.push_back({ window, halfEdge });
  }
  this->Bytes += (junction.waiting.capacity() - before) * sizeof(Coming);
  junction.key = isNearer ? key : junction.key;
  return isNearer;
}

bool Junctions::doWaitAt(Index first) const
{
  const auto place = this->Places.find(first);
  return place != this->Places.end() && !this->All[place->second].waiting.empty();
}

const Junctions::Junction& Junctions::pass(Index first, std::vector<Coming>& passing)
{
  Junction& junction = this->All[this->Places.at(first)];
  std::vector<Coming>& waiting = junction.waiting;
  std::stable_sort(waiting.begin(), waiting.end(),
    [](const Coming& a, const Coming& b)
    { return a.window.leastDistance() < b.window.leastDistance(); });
  const std::size_t before = junction.passed.bytes();
  passing.clear();
  for (const Coming& coming : waiting)
  {
    this->Nearer.clear();
    junction.passed.appendNearer(coming.window, this->Nearer);
    for (const Window& part : this->Nearer)
    {
      junction.passed.insert(part);
      passing.push_back({ part, coming.from });
    }
  }
  waiting.clear();
  this->Bytes += junction.passed.bytes() - before;
  return junction;
}

std::span<const Window> Junctions::passedAt(Index first) const
{
  const auto place = this->Places.find(first);
  return place == this->Places.end() ? std::span<const Window>{}
                                     : this->All[place->second].passed.windows();
}

void Junctions::clear()
{
  this->All.clear();
  this->Places.clear();
  this->Bytes = 0;
}

}
