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

/** The interface of all solvers: distances from seeds to the vertices of a mesh. */
class DistanceSolver
{
public:
  virtual ~DistanceSolver() = default;

  virtual const TriangleMesh& mesh() const = 0;

  /**
   * Computes the distance field of some seeds.
   * @param seeds    at least one
   * @param options  the arrays that its spans refer to must exist during the call
   * @return the field, which the next call overwrites. It is not an error that a target can't be
   *         reached or that the run is cancelled: see DistanceField::stopReason.
   */
  virtual const DistanceField& solve(std::span<const Seed> seeds, const SolveOptions& options) = 0;
};

}

#endif
