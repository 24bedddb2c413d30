// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ThreadTeam_h
#define geodesic_ThreadTeam_h

#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace geodesic
{

/**
 * Spreads loops over threads. A loop is cut into as many ranges as there are threads; what it
 * computes must not depend on where.
 */
class ThreadTeam
{
public:
  /** @param threads at least 1; 0 takes as many as the machine runs at a time. */
  explicit ThreadTeam(unsigned threads = 0)
    : Threads(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()))
  {
  }

  /** The same with at most so many threads, for what takes memory for each. */
  ThreadTeam atMost(unsigned threads) const
  {
    return ThreadTeam(static_cast<unsigned>(std::min<std::size_t>(threads, this->Threads)));
  }

  /** Into how many ranges a loop of @p count steps is cut; small ones stay whole. */
  std::size_t numberOfRanges(std::size_t count) const
  {
    return std::clamp<std::size_t>(count / LeastRange, 1, this->Threads);
  }

  /** The first step of a range; of the range behind the last one, @p count. */
  std::size_t startOf(std::size_t range, std::size_t count) const
  {
    return count * range / this->numberOfRanges(count);
  }

  /**
   * Calls work(range, first, last) for each range from first to before last, which follow each
   * other from 0 to @p count, all at the same time. Of the exceptions that the calls throw the one
   * of the first range goes on.
   */
  template <class Work>
  void run(std::size_t count, const Work& work) const
  {
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
  /** Below this many steps a thread costs more than it saves. */
  static constexpr std::size_t LeastRange = 1024;
  std::size_t Threads;
};

/** Sums that each range counted, turned into where each range begins; returns the whole sum. */
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
