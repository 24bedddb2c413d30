// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/LabelBounds.h"

#include "base/Platform.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace geodesic
{
namespace
{

/** Inside vertices are only looked for if at least one vertex in so many has a start. */
constexpr std::size_t VerticesOfStart = 32;
/** Where a label has at most so many starts, they are looked through for those round each of them.
 */
constexpr std::size_t MostOfSmallLabel = 8;
/** Starts of labels lie anywhere: what is read of them is fetched by so many starts ahead. */
constexpr std::size_t Soon = 8;
/** How often goesOn() is called. */
constexpr std::size_t StartsOfReport = 4096;

/** Whether a test holds for all neighbours of a vertex and the entries of its ring. */
template <class Test>
bool allRound(const TriangleMesh& mesh, Index vertex, const Test& test)
{
  const std::span<const RingEntry> ring = mesh.ring(vertex);
  bool isAll = true;
  for (std::size_t i = 0; i < ring.size() && isAll; ++i)
  {
    isAll = test(ring[i].neighbour(), i);
  }
  return isAll;
}

/** Whether a final value at a vertex can't lower one at the neighbour of a ring entry, that is more
 * by @p rise, along the edge. */
bool isNoWay(const TriangleMesh& mesh, Index vertex, std::size_t entry, double rise)
{
  if (!(rise > 0.0))
  {
    return true;
  }
  const Vector3 edge = mesh.toNeighbour(vertex, entry);
  return rise * rise <= dot(edge, edge);
}

/** Whether no update from a start changes the value of its label at the neighbour of a ring entry:
 * the label has few starts, one of them is there and final, and no way along the edge is shorter.
 */
bool isSettledBy(std::span<const StartValue> sameLabel, const TriangleMesh& mesh,
  const StartValue& start, Index neighbour, std::size_t entry)
{
  return sameLabel.size() <= MostOfSmallLabel &&
    std::any_of(sameLabel.begin(), sameLabel.end(),
      [&](const StartValue& other)
      {
        return other.vertex == neighbour && other.isFinal &&
          isNoWay(mesh, start.vertex, entry, other.value - start.value);
      });
}

/** The starts of the label of the one at place @p first, from there on. */
std::span<const StartValue> ofSameLabel(std::span<const StartValue> starts, std::size_t first)
{
  const auto begin = starts.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = std::find_if(
    begin, starts.end(), [&](const StartValue& start) { return start.label != begin->label; });
  return { begin, end };
}

}

bool areSettled(const TriangleMesh& mesh, std::span<const StartValue> starts, Partition& partition)
{
  std::span<const StartValue> sameLabel;
  const bool isSettled = std::all_of(starts.begin(), starts.end(),
    [&](const StartValue& start)
    {
      if (const std::size_t next = &start - starts.data() + Soon; next + Soon < starts.size())
      {
        mesh.prefetchRingStart(starts[next + Soon].vertex);
        mesh.rings().prefetch(starts[next].vertex);
      }
      if (sameLabel.empty() || sameLabel[0].label != start.label)
      {
        sameLabel = ofSameLabel(starts, &start - starts.data());
      }
      return start.isFinal &&
        allRound(mesh, start.vertex,
          [&](Index vertex, std::size_t entry)
          { return isSettledBy(sameLabel, mesh, start, vertex, entry); });
    });
  const double isAnyOpen = isSettled ? 0.0 : 1.0;
  const std::vector<double> all = partition.gather({ &isAnyOpen, 1 });
  return *std::max_element(all.begin(), all.end()) == 0.0;
}

void LabelBounds::begin(const TriangleMesh& mesh, std::span<const Label> labels,
  std::span<const StartValue> starts, Partition& partition)
{
  this->PlaceOfStart.resize(mesh.numberOfVertices(), NoIndex);
  this->Starts.clear();
  this->Starts.reserve(starts.size());
  for (const StartValue& start : starts)
  {
    if (const std::size_t next = &start - starts.data() + Soon; next < starts.size())
    {
      prefetchToWrite(&this->PlaceOfStart[starts[next].vertex]);
    }
    this->addStart({ start.vertex, 0, start.value + labels[start.label].value, start.isFinal });
  }
  std::vector<StartValue> ownStarts;
  for (const Index vertex : partition.sharedVertices())
  {
    if (const Index place = this->PlaceOfStart[vertex]; place != NoIndex)
    {
      ownStarts.push_back(this->Starts[place]);
    }
  }
  for (const StartValue& other : partition.exchange(ownStarts))
  {
    this->addStart(other);
  }

  this->AreInside.clear();
  if (!this->haveManyStarts(mesh, partition))
  {
    return;
  }
  this->sortStarts();
  const auto finalValue = [&](Index vertex)
  {
    const Index place = this->PlaceOfStart[vertex];
    return place != NoIndex && this->Starts[place].isFinal ? this->Starts[place].value
                                                           : -DistanceField::Unreached;
  };
  this->AreInside.resize(mesh.numberOfVertices());
  for (StartValue& start : this->Starts)
  {
    if (const std::size_t next = &start - this->Starts.data() + Soon;
        next + Soon < this->Starts.size())
    {
      mesh.prefetchRingStart(this->Starts[next + Soon].vertex);
      mesh.rings().prefetch(this->Starts[next].vertex);
    }
    // A final value falls by a way along an edge alone.
    start.isIdle = allRound(mesh, start.vertex,
      [&](Index vertex, std::size_t entry)
      {
        const double rise = finalValue(vertex) - start.value;
        return rise > -DistanceField::Unreached && isNoWay(mesh, start.vertex, entry, rise);
      });
    const bool isInside = start.isFinal &&
      allRound(mesh, start.vertex,
        [&](Index vertex, std::size_t) { return start.value <= finalValue(vertex); });
    this->AreInside[start.vertex] = isInside ? 1 : 0;
  }
  std::vector<StartValue> shared;
  for (const Index vertex : partition.sharedVertices())
  {
    shared.push_back({ vertex, 0, this->AreInside[vertex] != 0 ? 1.0 : 0.0, false });
  }
  for (const StartValue& other : partition.exchange(shared))
  {
    this->AreInside[other.vertex] = other.value == 1.0 ? this->AreInside[other.vertex] : 0;
  }
}

bool LabelBounds::areAllInside(Partition& partition) const
{
  const bool areInside = std::all_of(this->Starts.begin(), this->Starts.end(),
    [&](const StartValue& start) { return this->isInside(start.vertex); });
  const double isAnyPassed = areInside ? 0.0 : 1.0;
  const std::vector<double> all = partition.gather({ &isAnyPassed, 1 });
  return *std::max_element(all.begin(), all.end()) == 0.0;
}

void LabelBounds::addStart(const StartValue& start)
{
  Index& place = this->PlaceOfStart[start.vertex];
  if (place == NoIndex)
  {
    place = static_cast<Index>(this->Starts.size());
    this->Starts.push_back(start);
    return;
  }
  StartValue& least = this->Starts[place];
  least.isFinal = start.value < least.value
    ? start.isFinal
    : least.isFinal || (start.value == least.value && start.isFinal);
  least.value = std::min(least.value, start.value);
}

void LabelBounds::sortStarts()
{
  std::vector<StartValue> sorted;
  sorted.reserve(this->Starts.size());
  for (Index& place : this->PlaceOfStart)
  {
    if (place != NoIndex)
    {
      sorted.push_back(this->Starts[place]);
      place = static_cast<Index>(sorted.size() - 1);
    }
  }
  this->Starts = std::move(sorted);
}

bool LabelBounds::haveManyStarts(const TriangleMesh& mesh, Partition& partition) const
{
  // How many starts there are, and vertices for each of which there would have to be one.
  std::array<double, 2> counts{ static_cast<double>(this->Starts.size() * VerticesOfStart),
    static_cast<double>(mesh.numberOfVertices()) };
  for (const Index vertex : partition.sharedVertices())
  {
    if (!partition.owns(vertex))
    {
      counts[0] -= this->PlaceOfStart[vertex] == NoIndex ? 0.0 : VerticesOfStart;
      counts[1] -= 1.0;
    }
  }
  const std::vector<double> all = partition.gather(counts);
  double difference = 0.0;
  for (std::size_t i = 0; i < all.size(); i += counts.size())
  {
    difference += all[i] - all[i + 1];
  }
  return difference > 0.0;
}

std::span<const StartValue> LabelBounds::within(const TriangleMesh& mesh,
  std::span<const Label> labels, std::span<const StartValue> starts,
  const std::function<bool()>& goesOn)
{
  std::vector<StartValue>& within = this->Within;
  within.clear();
  within.reserve(starts.size());
  std::vector<StartValue> closed;
  std::span<const StartValue> sameLabel;
  for (const StartValue& start : starts)
  {
    if (const std::size_t place = &start - starts.data();
        place % StartsOfReport == StartsOfReport - 1 && !goesOn())
    {
      return {};
    }
    if (sameLabel.empty() || sameLabel[0].label != start.label)
    {
      sameLabel = ofSameLabel(starts, &start - starts.data());
    }
    if (const std::size_t next = &start - starts.data() + Soon; next + Soon < starts.size())
    {
      mesh.prefetchRingStart(starts[next + Soon].vertex);
      mesh.rings().prefetch(starts[next].vertex);
      this->prefetch(starts[next].vertex);
    }
    if (start.value > this->ofLabel(start.label))
    {
      continue;
    }
    if (start.value + labels[start.label].value <=
      this->ofVertex(start.vertex, this->allowanceOf(start.label)))
    {
      within.push_back(start);
      within.back().isIdle = !this->AreInside.empty() &&
        allRound(mesh, start.vertex,
          [&](Index vertex, std::size_t entry)
          { return this->isInside(vertex) || isSettledBy(sameLabel, mesh, start, vertex, entry); });
    }
    else if (start.isFinal)
    {
      closed.push_back({ start.vertex, start.label, DistanceField::Unreached, true, true });
    }
  }
  if (!closed.empty())
  {
    std::vector<std::uint8_t> haveValue(mesh.numberOfVertices());
    for (const StartValue& start : within)
    {
      haveValue[start.vertex] = 1;
    }
    std::copy_if(closed.begin(), closed.end(), std::back_inserter(within),
      [&](const StartValue& start) { return haveValue[start.vertex] != 0; });
  }
  return within;
}

void LabelBounds::startBlocks(std::size_t vertices, std::size_t labels)
{
  this->OfVertices.resize(vertices, DistanceField::Unreached);
  this->OfLabels.assign(labels, LabelReach());
  this->AreInside.clear();
}

void LabelBounds::clear()
{
  for (const auto& [begin, end] : this->Blocks)
  {
    std::fill(
      this->OfVertices.begin() + begin, this->OfVertices.begin() + end, DistanceField::Unreached);
  }
  this->Blocks.clear();
  this->Checks = nullptr;
  for (const Index vertex : this->Reached)
  {
    this->First[vertex] = DistanceField::Unreached;
    this->OfVertices[vertex] = DistanceField::Unreached;
  }
  for (const StartValue& start : this->Starts)
  {
    this->PlaceOfStart[start.vertex] = NoIndex;
  }
  this->Reached.clear();
  this->AtEnds.clear();
  this->Starts.clear();
}

}
