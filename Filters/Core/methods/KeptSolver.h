// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_KeptSolver_h
#define geodesic_KeptSolver_h

#include "mesh/TriangleMesh.h"
#include "methods/SolverTable.h"

#include <memory>

namespace geodesic
{

/** One solver, kept with its workspace from run to run as long as it suits what is asked for. */
class KeptSolver
{
public:
  /** A solver of a method on a mesh: the one of the last call, if it was of this method, and the
   * mesh is the same or has its structure; else a new one. */
  DistanceSolver& get(const SolverTraits& method, const std::shared_ptr<const TriangleMesh>& mesh)
  {
    const bool suits = this->Solver && this->Method == &method &&
      (&this->Solver->mesh() == mesh.get() || this->Solver->moveTo(mesh));
    if (!suits)
    {
      this->Solver.reset();
      this->Solver = method.make(mesh);
      this->Method = &method;
    }
    return *this->Solver;
  }

private:
  const SolverTraits* Method = nullptr;
  std::unique_ptr<DistanceSolver> Solver;
};

}

#endif
