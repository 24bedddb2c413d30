// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceSolver_h
#define geodesic_DistanceSolver_h

#include "solve/DistanceField.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <span>

namespace geodesic
{

class TriangleMesh;

/** What gives distances from seeds to the vertices of a mesh. */
class DistanceSolver
{
public:
  virtual ~DistanceSolver() = default;

  virtual const TriangleMesh& mesh() const = 0;

  /**
   * @param seeds   at least one
   * @param options see there; what its spans refer to must live as long as the call
   * @return the field, which the next call overwrites. A target that can't be reached, or a
   * cancelled run, is no error: see DistanceField::stopReason.
   */
  virtual const DistanceField& solve(std::span<const Seed> seeds, const SolveOptions& options) = 0;
};

}

#endif
