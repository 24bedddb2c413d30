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
 * other. The first thread is the calling one. Returns when all calls have returned.
 * @param threads    at least 1
 * @param meanwhile  meanwhile(areThere) is called by the calling thread once the others are made;
 *                   areThere() says whether all run. They begin when it returns. It may throw
 * @param work       throws nothing
 * @throws std::system_error where the system has no more threads, before any call of work;
 *         whatever meanwhile throws
 */
template <class Meanwhile, class Work>
void callTogether(std::size_t threads, const Meanwhile& meanwhile, const Work& work)
{
  enum Signal
  {
    Wait,
    Begin,
    Leave
  };
  std::atomic<Signal> signal = Wait;
  std::atomic<std::size_t> present = 1;
  std::vector<std::jthread> others;
  try
  {
    for (std::size_t thread = 1; thread < threads; ++thread)
    {
      others.emplace_back(
        [&, thread]
        {
          ++present;
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
    meanwhile([&] { return present == threads; });
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
