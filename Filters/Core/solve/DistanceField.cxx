// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/DistanceField.h"

#include "base/Lanes.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace geodesic
{
namespace
{

/** The largest of some numbers that are not below 0; 0 if there is none. */
template <class NumberAt>
double largestOf(std::size_t count, const NumberAt& numberAt)
{
  // Four independent maxima: with one, each comparison would wait for the one before.
  std::array<double, 4> most{};
  std::size_t i = 0;
  for (; i + most.size() <= count; i += most.size())
  {
    for (std::size_t lane = 0; lane < most.size(); ++lane)
    {
      most[lane] = largest(numberAt(i + lane), most[lane]);
    }
  }
  for (; i < count; ++i)
  {
    most[0] = largest(numberAt(i), most[0]);
  }
  return *std::max_element(most.begin(), most.end());
}

}

void DistanceField::reset()
{
  this->fillReached(std::span(this->Distances), Unreached);
  if (this->OnlySeed == NoIndex)
  {
    this->fillReached(std::span(this->NearestSeeds), NoIndex);
  }
  this->OnlySeed = NoIndex;
  this->Reached.clear();
  this->LargestDistance = 0.0;
  this->Reason = StopReason::Exhausted;
  this->RaisedGain = 0.0;
  this->IsIntrinsic = false;
}

void DistanceField::noteReached(std::span<const std::span<const Index>> lists)
{
  std::size_t count = this->Reached.size();
  for (const std::span<const Index> list : lists)
  {
    count += list.size();
  }
  if (count == this->Distances.size())
  {
    // All vertices: orderReached() needs no more than their number.
    this->Reached.resize(count);
    return;
  }
  for (const std::span<const Index> list : lists)
  {
    this->Reached.insert(this->Reached.end(), list.begin(), list.end());
  }
}

void DistanceField::orderReached()
{
  if (this->isWhole())
  {
    std::iota(this->Reached.begin(), this->Reached.end(), Index{ 0 });
    return;
  }
  constexpr std::size_t least = 8;
  if (this->Reached.size() < this->Distances.size() / least)
  {
    return;
  }
  std::size_t count = 0;
  for (Index vertex = 0; count < this->Reached.size(); ++vertex)
  {
    this->Reached[count] = vertex;
    count += this->isReached(vertex) ? 1 : 0;
  }
}

void DistanceField::finish(double limit, StopReason reason)
{
  this->Reason = reason;
  this->LargestDistance = this->largestReached();
  if (this->LargestDistance <= limit)
  {
    return;
  }
  std::erase_if(this->Reached,
    [&](Index vertex)
    {
      if (this->Distances[vertex] > limit)
      {
        this->Distances[vertex] = Unreached;
        if (this->OnlySeed == NoIndex)
        {
          this->NearestSeeds[vertex] = NoIndex;
        }
        return true;
      }
      return false;
    });
  this->LargestDistance = this->largestReached();
}

double DistanceField::largestReached() const
{
  if (this->isWhole())
  {
    return largestOf(this->Distances.size(), [&](std::size_t i) { return this->Distances[i]; });
  }
  return largestOf(
    this->Reached.size(), [&](std::size_t i) { return this->Distances[this->Reached[i]]; });
}

}
