// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ByLevel_h
#define geodesic_ByLevel_h

#include "base/Interruption.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** Things by the first of some levels that is above a value of theirs. */
template <class Thing>
class ByLevel
{
public:
  /** @param levels in increasing order */
  explicit ByLevel(std::span<const double> levels)
    : Levels(levels)
    , Starts(levels.size() + 1, 0)
  {
  }

  /** The number of the first level above a value; that of all levels if there is none. */
  std::size_t firstAbove(double value) const
  {
    return std::upper_bound(this->Levels.begin(), this->Levels.end(), value) - this->Levels.begin();
  }
  /** @param level below the number of levels */
  void add(std::size_t level, const Thing& thing)
  {
    this->Added.emplace_back(level, thing);
    ++this->Starts[level + 1];
  }
  /** To be called once all are there. */
  void order()
  {
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end());
    this->Things.resize(this->Added.size());
    for (std::size_t i = 0; i < this->Added.size(); ++i)
    {
      Interruption::checkAt(i);
      const auto& [level, thing] = this->Added[i];
      this->Things[next[level]++] = thing;
    }
    this->Added = {};
  }
  std::span<const Thing> of(std::size_t level) const
  {
    return std::span(this->Things)
      .subspan(this->Starts[level], this->Starts[level + 1] - this->Starts[level]);
  }

private:
  std::span<const double> Levels;
  std::vector<std::pair<std::size_t, Thing>> Added;
  std::vector<std::size_t> Starts;
  std::vector<Thing> Things;
};

}

#endif
