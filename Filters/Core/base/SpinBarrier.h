// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SpinBarrier_h
#define geodesic_SpinBarrier_h

#include "base/Platform.h"

#include <atomic>
#include <cstddef>
#include <thread>

namespace geodesic
{

/**
 * Where threads wait for each other, for steps of some ten microseconds: std::barrier puts threads
 * to sleep, and to wake them takes longer than such a step. A thread here looks again and again,
 * and leaves the processor to others between looks once it has waited for long.
 */
class SpinBarrier
{
public:
  explicit SpinBarrier(std::size_t threads)
    : Expected(threads)
    , Patience(runAtOnce(threads) ? UsualPatience : 0)
  {
  }

  /** Whether the machine has a processor for each of so many threads. */
  static bool runAtOnce(std::size_t threads)
  {
    return threads <= std::thread::hardware_concurrency();
  }

  /** Returns once all threads have arrived. What they wrote before is then seen by all.
   * @return false, at once, if the barrier is or gets broken */
  bool wait()
  {
    const std::size_t phase = this->Phase.load(std::memory_order_relaxed);
    if (this->Arrived.fetch_add(1, std::memory_order_acq_rel) + 1 == this->Expected)
    {
      this->Arrived.store(0, std::memory_order_relaxed);
      this->Phase.fetch_add(1, std::memory_order_release);
    }
    for (std::size_t looks = 0; this->Phase.load(std::memory_order_acquire) == phase; ++looks)
    {
      if (this->IsBroken.load(std::memory_order_relaxed))
      {
        return false;
      }
      if (looks < this->Patience)
      {
        pauseProcessor();
      }
      else
      {
        std::this_thread::yield();
      }
    }
    return true;
  }

  /** Whether a thread that came now would wait for others. */
  bool othersAreComing() const
  {
    return this->Arrived.load(std::memory_order_relaxed) + 1 < this->Expected;
  }

  /** For a thread that will not come again: nobody waits any more. */
  void breakUp() { this->IsBroken.store(true, std::memory_order_relaxed); }

private:
  /** Some ten microseconds. */
  static constexpr std::size_t UsualPatience = 4000;

  std::size_t Expected;
  /** After so many looks a thread leaves the processor to others; at once if there are more threads
   * than processors. */
  std::size_t Patience;
  std::atomic<std::size_t> Arrived = 0;
  /** How often all have arrived. */
  std::atomic<std::size_t> Phase = 0;
  std::atomic<bool> IsBroken = false;
};

}

#endif
