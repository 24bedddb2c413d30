// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontSolver_h
#define geodesic_FrontSolver_h

#include "solve/DistanceSolver.h"
#include "solve/SeedFront.h"

#include <memory>
#include <span>

namespace geodesic
{

class ClosedTriangles;
class Partition;
class StopLimit;
class TriangleMesh;

/**
 * Computes the distance from seeds to the vertices of a mesh. A solver keeps its workspace, so a
 * second run on it allocates nothing and touches only what its front reaches.
 */
class FrontSolver : public DistanceSolver
{
public:
  FrontSolver(const FrontSolver&) = delete;
  FrontSolver& operator=(const FrontSolver&) = delete;

  const TriangleMesh& mesh() const final { return *this->Mesh; }

  /**
   * See DistanceSolver.
   * @throws std::invalid_argument for a request without an answer: no seed, a seed that is no point
   * of the mesh or that lies on what is excluded or closed, an option that does not fit the mesh
   * @throws std::runtime_error where fast marching does not settle (see MarchControl). After any
   *         exception from within a run the solver's workspace is undefined: make a new solver.
   */
  const DistanceField& solve(std::span<const Seed> seeds, const SolveOptions& options = {}) final;

protected:
  explicit FrontSolver(std::shared_ptr<const TriangleMesh> mesh);

  /** What a run is asked for, checked. */
  struct Request
  {
    const SeedFront& front;
    const ClosedTriangles& closed;
    const SolveOptions& options;
    Partition& partition;
    /** On all pieces of the surface alike, also on one without vertices. */
    bool hasCost;
  };

  /**
   * Lowers the field until it is final up to the limit.
   * @return false when cancelled
   */
  virtual bool march(const Request& request, StopLimit& limit, DistanceField& field) = 0;

  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return this->Mesh; }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  DistanceField Field;
};

}

#endif
