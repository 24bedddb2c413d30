// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SearchProgress_h
#define geodesic_SearchProgress_h

#include "base/WorkCount.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <utility>

namespace geodesic
{

/** Thrown out of a search for a path that is cancelled. */
class SearchCancelled
{
};

/**
 * Reports the progress of a search for paths, which is several marches with tracing and
 * straightening between them, by SolveOptions::onProgress. The counts of all that follow one
 * another are added up, so that the progress never falls.
 */
class SearchProgress
{
public:
  /** @param options must live as long as this */
  explicit SearchProgress(const SolveOptions& options)
    : Options(options)
  {
  }

  /** Reports how many vertices a march has taken. @return false to cancel it */
  bool report(std::size_t taken)
  {
    this->InMarch = taken;
    return this->Options.onProgress(this->Count + taken);
  }
  /** To be called after each march. */
  void endMarch() { this->Count += std::exchange(this->InMarch, 0); }

  /** Counts steps outside of a march: entries of rings and faces of strips that are looked at. They
   * take less than a microsecond each. @throws SearchCancelled */
  void add(std::size_t steps)
  {
    WorkCount::add(steps);
    this->Steps += steps;
    if (this->Steps >= StepsOfReport)
    {
      this->Count += std::exchange(this->Steps, 0);
      if (this->Options.onProgress && !this->Options.onProgress(this->Count))
      {
        throw SearchCancelled();
      }
    }
  }

private:
  static constexpr std::size_t StepsOfReport = 1 << 14;

  const SolveOptions& Options;
  /** Vertices and steps that were reported and are no part of a march that goes on. */
  std::size_t Count = 0;
  std::size_t InMarch = 0;
  /** Steps since the last report. */
  std::size_t Steps = 0;
};

}

#endif
