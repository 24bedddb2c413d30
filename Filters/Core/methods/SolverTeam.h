// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolverTeam_h
#define geodesic_SolverTeam_h

#include "solve/DistanceSolver.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace geodesic
{

struct SolverTraits;

/**
 * Solvers of one method on one mesh, one for each thread. They are made when they are first asked
 * for, and kept with their workspaces from run to run.
 */
class SolverTeam
{
public:
  /**
   * Prepares for runs; keeps the solvers if the method is that of the last time, and the mesh is so
   * too, or the same with its points elsewhere.
   * @param threads  how many threads are wanted, at least 1. There are fewer if the solvers beside
   *                 the first would hold more than a quarter of the machine's memory
   */
  void prepare(const SolverTraits& method, const std::shared_ptr<const TriangleMesh>& mesh,
    std::size_t threads);

  const TriangleMesh& mesh() const { return *this->Mesh; }
  std::size_t numberOfThreads() const { return this->Solvers.size(); }
  /** The solver of the calling thread. */
  DistanceSolver& first() { return this->ofThread(0); }
  /** The solver of a thread, which may be asked for by that thread only. */
  DistanceSolver& ofThread(std::size_t thread);
  /** Replaces a solver whose workspace an exception has left undefined. */
  void renew(std::size_t thread) { this->Solvers[thread].reset(); }
  /** Each thread's part of SolveOptions::memoryLimit, while several work. */
  std::size_t memoryOfEach(std::size_t limit) const;
  /** How many vertices a march takes in the time that it takes to make a solver. */
  std::size_t stepsToMakeOne() const;

private:
  const SolverTraits* Method = nullptr;
  std::shared_ptr<const TriangleMesh> Mesh;
  std::vector<std::unique_ptr<DistanceSolver>> Solvers;
};

}

#endif
