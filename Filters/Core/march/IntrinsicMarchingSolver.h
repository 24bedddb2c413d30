// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IntrinsicMarchingSolver_h
#define geodesic_IntrinsicMarchingSolver_h

#include "march/FastMarchingSolver.h"
#include "solve/DistanceSolver.h"

#include <memory>
#include <optional>
#include <span>

namespace geodesic
{

/**
 * Fast marching, on the faces or, with SolveOptions::isIntrinsic, over IntrinsicTriangles of the
 * surface. On needles the update sees sources that are not there, and vertices lower one another in
 * circles; these triangles have hardly any. Distances are then lowered along the edges of the mesh.
 *
 * Intrinsic triangles end at barriers, so other barriers need others; those of the last run are
 * kept. They take as long as 5 to 20 marches and up to 2 kB a vertex.
 */
class IntrinsicMarchingSolver final : public DistanceSolver
{
public:
  explicit IntrinsicMarchingSolver(const std::shared_ptr<const TriangleMesh>& mesh);
  ~IntrinsicMarchingSolver() override;

  const TriangleMesh& mesh() const override { return *this->Faces; }
  /** See FrontSolver::solve(). @throws std::invalid_argument also with SolveOptions::isIntrinsic
   * unless canMarchIntrinsically() */
  const DistanceField& solve(
    std::span<const Seed> seeds, const SolveOptions& options = {}) override;
  bool moveTo(const std::shared_ptr<const TriangleMesh>& mesh) override;
  /** See MarchingSolver. */
  bool gainsByMaximumDistance() const override { return true; }
  const Detours* detours() const override
  {
    return this->OnFaces ? this->OnFaces->detours() : nullptr;
  }

  /** Whether a request can be served on intrinsic triangles: one from points, at cost 1, on a
   * surface in one piece. */
  static bool canMarchIntrinsically(std::span<const Seed> seeds, const SolveOptions& options);

private:
  class Solver;
  struct Intrinsic;

  /** Makes the intrinsic triangles, unless they are there. @return false when cancelled */
  bool prepare(const SolveOptions& options);
  const DistanceField& solveOnFaces(std::span<const Seed> seeds, const SolveOptions& options);
  const DistanceField& solveIntrinsically(std::span<const Seed> seeds, const SolveOptions& options);

  std::shared_ptr<const TriangleMesh> Faces;
  std::unique_ptr<FastMarchingSolver> OnFaces;
  std::unique_ptr<Intrinsic> OnIntrinsic;
  /** The solver of the last run, which alone may keep its surface. */
  const DistanceSolver* Last = nullptr;
  /** Whether a front on the intrinsic triangles did not settle. */
  bool IsBetterOnFaces = false;
  /** Of a march on intrinsic triangles. */
  std::optional<DistanceField> Field;
};

}

#endif
