// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_OptionsOfMarches_h
#define geodesic_OptionsOfMarches_h

#include "solve/Partition.h"
#include "solve/SolveOptions.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace geodesic
{

/** The options of a run for several marches, one after the other: each counts its steps on from
 * those of the one before. */
class OptionsOfMarches
{
public:
  /** @param options of the run; must outlive this object */
  explicit OptionsOfMarches(const SolveOptions& options)
    : Own(options)
  {
    if (options.onProgress)
    {
      this->Own.onProgress = [this, &report = options.onProgress](std::size_t taken)
      {
        this->Steps = this->Before + taken;
        return report(this->Steps);
      };
    }
  }
  OptionsOfMarches(const OptionsOfMarches&) = delete;
  OptionsOfMarches& operator=(const OptionsOfMarches&) = delete;

  const SolveOptions& get() const { return this->Own; }
  /** To be called often by what takes long before, between or after marches: each time counts as a
   * step. Once it was
   * told to cancel it stays so. @return false when cancelled */
  bool goesOn()
  {
    if (this->Own.onProgress && !this->IsCancelled)
    {
      const std::size_t taken = this->Steps - this->Before;
      ++this->Before;
      this->IsCancelled = !this->Own.onProgress(taken);
    }
    return !this->IsCancelled;
  }
  /** Whether goesOn() was told to cancel on any piece. Collective. */
  bool areCancelled(Partition& partition) const
  {
    const double isCancelled = this->IsCancelled ? 1.0 : 0.0;
    const std::vector<double> all = partition.gather({ &isCancelled, 1 });
    return *std::max_element(all.begin(), all.end()) > 0.0;
  }
  /** To be called between two marches. @return the steps of the one before, as far as known */
  std::size_t beginNext()
  {
    const std::size_t taken = this->Steps - this->Before;
    this->Before = this->Steps;
    return taken;
  }
  /** To be called where a march goes on after another one. @param taken  its steps until then, as
   * beginNext() returned them */
  void goOn(std::size_t taken) { this->Before = this->Steps - taken; }

private:
  SolveOptions Own;
  std::size_t Before = 0;
  std::size_t Steps = 0;
  bool IsCancelled = false;
};

}

#endif
