#ifndef geodesic_MarchControl_h
#define geodesic_MarchControl_h

#include "SolveOptions.h"
#include "StopLimit.h"

#include <cstddef>

namespace geodesic
{

/** Counts what a march takes from its queue; reports progress and follows the targets meanwhile. */
class MarchControl
{
public:
  MarchControl(const SolveOptions& options, StopLimit& limit)
    : Options(options)
    , Limit(limit)
  {
  }

  /** To be asked before each step; false once the run is cancelled. */
  bool mayGoOn()
  {
    constexpr std::size_t limitInterval = 32;
    ++this->Count;
    if (this->Count % limitInterval == 0)
    {
      this->Limit.update();
    }
    if (this->Options.onProgress && this->Count % this->Options.progressInterval == 0)
    {
      this->Cancelled = !this->Options.onProgress(this->Count);
    }
    return !this->Cancelled;
  }

  bool isCancelled() const { return this->Cancelled; }

private:
  const SolveOptions& Options;
  StopLimit& Limit;
  std::size_t Count = 0;
  bool Cancelled = false;
};

}

#endif
