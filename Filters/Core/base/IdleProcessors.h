// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IdleProcessors_h
#define geodesic_IdleProcessors_h

#include <algorithm>
#include <fstream>
#include <istream>
#include <string>
#include <thread>

namespace geodesic
{

/**
 * Returns how many processors have nothing else to do just now: the calling thread's own, and those
 * on which no other thread of any program runs or waits to run.
 * @param processors  how many there are
 * @param load        what /proc/loadavg of Linux says, "0.62 2.10 2.61 1/81 17674": the fourth word
 *                    begins with the number of threads that run or wait to run, this one among
 *                    them. Where it says nothing of the kind, all are idle
 */
inline unsigned idleProcessors(unsigned processors, std::istream& load)
{
  std::string mean;
  unsigned running = 1;
  if (!(load >> mean >> mean >> mean >> running))
  {
    return processors;
  }
  const unsigned others = std::max(running, 1u) - 1;
  return others < processors ? processors - others : 1;
}

/** The same for this machine. Takes some ten microseconds. */
inline unsigned idleProcessors()
{
  std::ifstream load("/proc/loadavg");
  return idleProcessors(std::max(std::thread::hardware_concurrency(), 1u), load);
}

}

#endif
