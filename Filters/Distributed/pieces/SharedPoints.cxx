// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/SharedPoints.h"

#include "base/BoundingBox.h"
#include "mesh/TriangleMesh.h"
#include "pieces/PointKeys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace geodesic::distributed
{
namespace
{

BoundingBox boxOf(const TriangleMesh& mesh)
{
  BoundingBox box;
  for (const Vector3& p : mesh.positions())
  {
    box.add(p);
  }
  return box;
}

/** A box that is a little larger: copies of a point with one global id may differ by rounding. */
BoundingBox widened(const BoundingBox& box)
{
  constexpr double rounding = 1e-6;
  const auto marginOf = [](double low, double high)
  { return rounding * (std::abs(low) + std::abs(high)); };
  const Vector3 margin{ marginOf(box.low.x, box.high.x), marginOf(box.low.y, box.high.y),
    marginOf(box.low.z, box.high.z) };
  return { box.low - margin, box.high + margin };
}

/** The boxes of the other ranks' pieces, widened. Collective. */
std::vector<BoundingBox> boxesOfOthers(RankGroup& ranks, const TriangleMesh& mesh)
{
  const BoundingBox own = boxOf(mesh);
  const std::array corners{ own.low.x, own.low.y, own.low.z, own.high.x, own.high.y, own.high.z };
  std::vector<BoundingBox> boxes;
  for (const std::vector<double>& c : ranks.gatherByRank(corners))
  {
    boxes.push_back(widened({ { c[0], c[1], c[2] }, { c[3], c[4], c[5] } }));
  }
  boxes.erase(boxes.begin() + ranks.rank());
  return boxes;
}

/** Returns the vertices that other pieces may have. Collective. */
std::vector<KeyedNumber> candidates(
  RankGroup& ranks, const TriangleMesh& mesh, std::span<const Key> keys)
{
  const std::vector<BoundingBox> boxes = boxesOfOthers(ranks, mesh);
  std::vector<KeyedNumber> vertices;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const Vector3& p = mesh.position(v);
    if (keys[v] != NoKey &&
      std::any_of(
        boxes.begin(), boxes.end(), [&](const BoundingBox& box) { return box.contains(p); }))
    {
      vertices.push_back({ keys[v], v });
    }
  }
  return vertices;
}

}

SharedPoints::SharedPoints(RankGroup& ranks, const TriangleMesh& mesh, std::span<const Key> keys)
  : Rank(ranks.rank())
  , IsShared(mesh.numberOfVertices(), false)
{
  this->FirstPlaces.push_back(0);
  if (ranks.size() == 1)
  {
    return;
  }
  std::map<int, std::vector<std::uint32_t>> slotsOfRank;
  for (const KeyMatch& match : matchKeys(ranks, candidates(ranks, mesh, keys)))
  {
    if (this->Vertices.empty() || this->Vertices.back() != match.own)
    {
      this->Vertices.push_back(match.own);
      this->IsShared[match.own] = true;
      // Matches are sorted, so the first one names the lowest rank.
      this->Globals.push_back({ match.rank, match.number });
    }
    if (match.rank != this->Rank)
    {
      const auto slot = static_cast<std::uint32_t>(this->Vertices.size() - 1);
      slotsOfRank[match.rank].push_back(slot);
    }
  }
  const auto isBefore = [this](std::uint32_t a, std::uint32_t b)
  { return this->Globals[a] < this->Globals[b]; };
  this->ByGlobal.resize(this->Vertices.size());
  std::iota(this->ByGlobal.begin(), this->ByGlobal.end(), 0u);
  std::sort(this->ByGlobal.begin(), this->ByGlobal.end(), isBefore);
  for (const int rank : ranks.others())
  {
    if (const auto found = slotsOfRank.find(rank); found != slotsOfRank.end())
    {
      std::sort(found->second.begin(), found->second.end(), isBefore);
      this->Neighbours.push_back({ rank, std::move(found->second) });
    }
  }
  this->findPlaces();
}

void SharedPoints::findPlaces()
{
  this->FirstPlaces.assign(this->Vertices.size() + 1, 0);
  for (const Neighbour& neighbour : this->Neighbours)
  {
    for (const std::uint32_t slot : neighbour.slots)
    {
      ++this->FirstPlaces[slot + 1];
    }
  }
  std::partial_sum(this->FirstPlaces.begin(), this->FirstPlaces.end(), this->FirstPlaces.begin());
  this->Places.resize(this->FirstPlaces.back());
  std::vector<std::uint32_t> next(this->FirstPlaces.begin(), this->FirstPlaces.end() - 1);
  for (std::uint32_t n = 0; n < this->Neighbours.size(); ++n)
  {
    const std::vector<std::uint32_t>& slots = this->Neighbours[n].slots;
    for (std::uint32_t place = 0; place < slots.size(); ++place)
    {
      this->Places[next[slots[place]]++] = { n, place };
    }
  }
}

std::vector<StartValue> SharedPoints::exchange(
  RankGroup& ranks, std::span<const StartValue> own) const
{
  std::vector<RankGroup::Message> messages(this->Neighbours.size());
  std::vector<int> partners;
  for (const Neighbour& neighbour : this->Neighbours)
  {
    partners.push_back(neighbour.rank);
  }
  for (const StartValue& start : own)
  {
    const Index slot = this->slotOf(start.vertex);
    if (slot == NoIndex)
    {
      continue;
    }
    for (const Place& to : this->placesOf(slot))
    {
      append(messages[to.neighbour],
        SentValue{ to.place, start.label, start.isFinal ? 1u : 0u, start.value });
    }
  }
  std::vector<StartValue> others;
  const auto received = ranks.exchange(partners, messages);
  for (std::size_t n = 0; n < received.size(); ++n)
  {
    for (const SentValue& sent : valuesIn<SentValue>(received[n]))
    {
      const Index vertex = this->Vertices[this->Neighbours[n].slots[sent.place]];
      others.push_back({ vertex, sent.label, sent.value, sent.isFinal != 0 });
    }
  }
  return others;
}

Index SharedPoints::slotOf(Index vertex) const
{
  if (vertex >= this->IsShared.size() || !this->IsShared[vertex])
  {
    return NoIndex;
  }
  const auto place = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex);
  return static_cast<Index>(place - this->Vertices.begin());
}

GlobalVertex SharedPoints::globalOf(Index vertex) const
{
  const Index slot = this->slotOf(vertex);
  return slot == NoIndex ? GlobalVertex{ this->Rank, vertex } : this->Globals[slot];
}

Index SharedPoints::find(const GlobalVertex& vertex) const
{
  if (vertex.rank == this->Rank)
  {
    return vertex.vertex;
  }
  const auto place = std::lower_bound(this->ByGlobal.begin(), this->ByGlobal.end(), vertex,
    [this](std::uint32_t slot, const GlobalVertex& wanted)
    { return this->Globals[slot] < wanted; });
  return place != this->ByGlobal.end() && this->Globals[*place] == vertex ? this->Vertices[*place]
                                                                          : NoIndex;
}

}
