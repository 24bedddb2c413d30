// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontSolver_h
#define geodesic_FrontSolver_h

#include "solve/ClosedTriangles.h"
#include "solve/DistanceSolver.h"
#include "solve/SeedFront.h"

#include <memory>
#include <optional>
#include <span>

namespace geodesic
{

class Partition;
class StopLimit;
class TriangleMesh;

/**
 * The base of solvers whose fronts carry labels and values (see MarchingFront). It checks a request
 * and turns seeds into labels and starts; a derived class marches. A solver keeps its workspace:
 * a second run needs hardly any new memory, and touches only what its front reaches.
 */
class FrontSolver : public DistanceSolver
{
public:
  FrontSolver(const FrontSolver&) = delete;
  FrontSolver& operator=(const FrontSolver&) = delete;

  const TriangleMesh& mesh() const final { return *this->Mesh; }

  /**
   * See DistanceSolver.
   * @throws std::invalid_argument for no seed, a seed that is no point of the mesh or lies on
   *         excluded vertices or in a closed triangle, or an option that does not fit the mesh
   * @throws std::runtime_error where fast marching does not settle (see MarchControl). After any
   *         exception from within a run the solver's workspace is undefined: make a new solver.
   */
  const DistanceField& solve(std::span<const Seed> seeds, const SolveOptions& options = {}) final;

  bool moveTo(const std::shared_ptr<const TriangleMesh>& mesh) final;

protected:
  explicit FrontSolver(std::shared_ptr<const TriangleMesh> mesh);

  /** A checked request, as march() gets it. */
  struct Request
  {
    const SeedFront& front;
    const ClosedTriangles& closed;
    const SolveOptions& options;
    Partition& partition;
    /** Whether there are costs; the same on all pieces, also on one without vertices. */
    bool hasCost;
    /** Whether cost and barriers are those of the run before, see SolveOptions::keepsSurface. */
    bool keepsSurface = false;
    /** What the front was made of. */
    std::span<const Seed> seeds = {};
  };

  /**
   * Marches from the request's starts until the field is final up to the limit.
   * @param limit  falls as the front comes nearer to the targets
   * @param field  reset, gets the distances and nearest seeds
   * @return false when cancelled
   */
  virtual bool march(const Request& request, StopLimit& limit, DistanceField& field) = 0;

  /** To be called instead of march() for a run that was cancelled before it: what is kept of the
   * last run must not be taken for this one's. */
  virtual void forgetLast() {}

  /** Makes what depends on positions anew for a mesh of the same structure. @return false, with
   * nothing done, where that does not pay */
  virtual bool renewFor(const TriangleMesh& /*mesh*/) { return false; }

  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return this->Mesh; }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  DistanceField Field;
  /** Of the last run, for the next that keeps the surface. */
  std::optional<ClosedTriangles> Closed;
  bool HasCost = false;
  /** That of the last run, kept for its memory. */
  SeedFront Front;
};

}

#endif
