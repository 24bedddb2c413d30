// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadTeam_h
#define geodesic_ThreadTeam_h

#include "base/Interruption.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace geodesic
{

/**
 * Spreads loops over threads. A loop is cut into at most as many ranges as there are threads; its
 * result must not depend on where the cuts are.
 */
class ThreadTeam
{
public:
  /** @param threads number of threads; 0 means as many as the machine runs at a time */
  explicit ThreadTeam(unsigned threads = 0)
    : Threads(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()))
  {
  }

  /** A team of at most @p threads of these threads, for loops that need memory for each one. */
  ThreadTeam atMost(unsigned threads) const
  {
    return ThreadTeam(static_cast<unsigned>(std::min<std::size_t>(threads, this->Threads)));
  }

  /** The number of ranges that a loop of @p count steps is cut into; a small loop is one range. */
  std::size_t numberOfRanges(std::size_t count) const
  {
    return std::clamp<std::size_t>(count / LeastRange, 1, this->Threads);
  }

  /** The first step of a range. For the range number after the last one, @p count. */
  std::size_t startOf(std::size_t range, std::size_t count) const
  {
    return count * range / this->numberOfRanges(count);
  }

  /**
   * Calls work(range, first, last) for each range, all at the same time: range is its number, first
   * its first step, last the step after its last one. Together the ranges are the steps from 0 to
   * before @p count. Returns when all calls have returned.
   * @throws whatever a call throws; if several do, the exception of the lowest range. Interrupted,
   *         before the first call
   */
  template <class Work>
  void run(std::size_t count, const Work& work) const
  {
    Interruption::check();
    const std::size_t ranges = this->numberOfRanges(count);
    std::vector<std::exception_ptr> errors(ranges);
    const auto runRange = [&](std::size_t range)
    {
      try
      {
        work(range, this->startOf(range, count), this->startOf(range + 1, count));
      }
      catch (...)
      {
        errors[range] = std::current_exception();
      }
    };
    {
      std::vector<std::jthread> others;
      others.reserve(ranges - 1);
      for (std::size_t range = 1; range < ranges; ++range)
      {
        others.emplace_back(runRange, range);
      }
      runRange(0);
    }
    for (const std::exception_ptr& error : errors)
    {
      if (error)
      {
        std::rethrow_exception(error);
      }
    }
  }

private:
  /** A thread with fewer steps costs more than it saves. */
  static constexpr std::size_t LeastRange = 1024;
  std::size_t Threads;
};

/**
 * Replaces the count of each range by the sum of the counts before it, which is where the range's
 * elements begin in a common array.
 * @return the sum of all counts
 */
inline std::size_t startsOf(std::vector<std::size_t>& counts)
{
  std::size_t sum = 0;
  for (std::size_t& count : counts)
  {
    const std::size_t start = sum;
    sum += count;
    count = start;
  }
  return sum;
}

}

#endif
