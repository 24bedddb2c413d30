// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_FastMarchingWorkspace_h
#define geodesic_bridge_FastMarchingWorkspace_h

#include "input/InputSurface.h"
#include "march/FastMarchingSolver.h"

#include <memory>

namespace geodesic::bridge
{

/** The state that is kept from run to run, so that only what changed is computed again. */
class FastMarchingWorkspace
{
public:
  /** Returns a solver for the input's surface: the last one, if the surface is the same, but for
   * where its points are. */
  FastMarchingSolver& solverFor(vtkPolyData* input)
  {
    auto surface = InputSurface::of(InputBlocks(input), PointIdentity{});
    if (surface != this->Surface)
    {
      if (!this->Solver || !this->Solver->moveTo(surface->mesh()))
      {
        this->Solver = std::make_unique<FastMarchingSolver>(surface->mesh());
      }
      this->Surface = std::move(surface);
    }
    return *this->Solver;
  }

  /** The surface of the last solver. */
  const InputSurface& surface() const { return *this->Surface; }

  /** Drops the state. Must be called after an exception, which leaves the solver undefined. */
  void forget() { *this = FastMarchingWorkspace(); }

private:
  std::shared_ptr<const InputSurface> Surface;
  std::unique_ptr<FastMarchingSolver> Solver;
};

}

#endif
