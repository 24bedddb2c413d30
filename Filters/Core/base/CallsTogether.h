// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CallsTogether_h
#define geodesic_CallsTogether_h

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace geodesic
{

/**
 * Calls work(thread) on each of some threads at the same time, for work in which they wait for each
 * other: none begins before all are there. The first thread is the calling one. Returns when all
 * calls have returned.
 * @param threads  at least 1
 * @param work     throws nothing
 * @throws std::system_error where the system has no more threads, before any call
 */
template <class Work>
void callTogether(std::size_t threads, const Work& work)
{
  enum Signal
  {
    Wait,
    Begin,
    Leave
  };
  std::atomic<Signal> signal = Wait;
  std::vector<std::jthread> others;
  try
  {
    for (std::size_t thread = 1; thread < threads; ++thread)
    {
      others.emplace_back(
        [&, thread]
        {
          // It does not sleep: a thread that is woken up is often put on the waking one's
          // processor.
          while (signal == Wait)
          {
            std::this_thread::yield();
          }
          if (signal == Begin)
          {
            work(thread);
          }
        });
    }
  }
  catch (...)
  {
    signal = Leave;
    throw;
  }
  signal = Begin;
  work(std::size_t{ 0 });
}

}

#endif
