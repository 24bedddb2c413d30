// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolvedField_h
#define geodesic_SolvedField_h

#include "solve/DistanceSolver.h"

#include <exception>
#include <utility>

namespace geodesic
{

/** Thrown where a field that was solved already does not reach far enough. */
class FieldTooSmall : public std::exception
{
public:
  const char* what() const noexcept override
  {
    return "The field does not reach as far as the path needs.";
  }
};

/**
 * Stands in for a solver whose field is there, so that several threads can find paths in the field
 * at a time. Each needs an object of its own.
 */
class SolvedField final : public DistanceSolver
{
public:
  /** @param solver, field  the solver, and what it returned last; nothing may change them as long
   * as this is used */
  SolvedField(const DistanceSolver& solver, const DistanceField& field)
    : Solver(solver)
    , Field(field)
  {
  }

  const TriangleMesh& mesh() const override { return this->Solver.mesh(); }

  /** Returns the field, whatever is asked for. @throws FieldTooSmall from the second call on: the
   * caller asks again where the field was not enough */
  const DistanceField& solve(std::span<const Seed>, const SolveOptions&) override
  {
    if (std::exchange(this->IsGiven, true))
    {
      throw FieldTooSmall();
    }
    return this->Field;
  }

  bool crossesFaces() const override { return this->Solver.crossesFaces(); }
  bool findsPaths() const override { return this->Solver.findsPaths(); }
  std::optional<FoundPath> pathFrom(const SurfacePoint& start) const override
  {
    return this->Solver.pathFrom(start);
  }

private:
  const DistanceSolver& Solver;
  const DistanceField& Field;
  bool IsGiven = false;
};

}

#endif
