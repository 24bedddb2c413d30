// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceSolver_h
#define geodesic_DistanceSolver_h

#include "solve/DistanceField.h"
#include "solve/Seed.h"
#include "solve/SolveOptions.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

class Detours;

/** A shortest path that a solver has found along with its field. */
struct FoundPath
{
  double length;
  /** From the start to the seed; consecutive points lie in one triangle. */
  std::vector<SurfacePoint> points;
};

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

  /**
   * Goes over to a mesh that has the structure of the solver's own, TriangleMesh::hasStructureOf(),
   * and keeps its workspace.
   * @return false, with nothing done, where the mesh has another structure, or the solver holds too
   *         much that depends on positions: then another solver must be made
   */
  virtual bool moveTo(const std::shared_ptr<const TriangleMesh>& /*mesh*/) { return false; }

  /** Whether distances are those of paths across faces; if not, of paths along edges. */
  virtual bool crossesFaces() const { return true; }

  /** Whether a run towards targets (SolveOptions::onlyTowardsTargets) goes to all sides until it
   * has reached them, so that it gains by a maximum distance, even if that is only a guess. */
  virtual bool gainsByMaximumDistance() const { return false; }

  /** Which triangles fronts crossed as straight ones in the last run with costs; null if that is
   * not known. */
  virtual const Detours* detours() const { return nullptr; }

  /** Whether pathFrom() gives paths. */
  virtual bool findsPaths() const { return false; }
  /**
   * The shortest path from one of SolveOptions::pathStarts to its nearest seed, of those whose
   * length is within the stop's distance; nothing if there is none.
   */
  virtual std::optional<FoundPath> pathFrom(const SurfacePoint& /*start*/) const
  {
    return std::nullopt;
  }
};

}

#endif
