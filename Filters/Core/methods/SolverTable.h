// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolverTable_h
#define geodesic_SolverTable_h

#include "solve/DistanceSolver.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace geodesic
{

/** How a solver works where the surface is in pieces on several ranks. */
enum class RankSupport
{
  /** It does not; such a request is an error. */
  None,
  /** It marches on each piece and exchanges values by SolveOptions::partition. */
  Partition
};

/** What a solver can do. */
struct SolverTraits
{
  /** The value of Method in the filters, their XML and state files. Never changes. */
  int number;
  /** The name that users see; also the text of the XML entry. */
  const char* name;
  /** The value of the contour interpolator's GeodesicMethod; -1 where it does not offer the solver.
   */
  int interpolatorNumber;
  /** Whether the filters' XML offers the solver. Solvers that aren't offered are for tests. */
  bool isOffered;
  /** Whether distances and paths go across faces; if not, they follow edges only. */
  bool crossesFaces;
  /** Whether distances are exactly those on the polyhedron, except for rounding. */
  bool isExact;
  /** Whether it can use SolveOptions::cost. */
  bool takesCosts;
  /** Whether it can use excluded vertices and closed triangles. */
  bool takesBarriers;
  RankSupport ranks;
  /** Memory that a solver holds after a whole field from one seed, in bytes for each vertex,
   * without the mesh. */
  double bytesPerVertex;

  /** Makes a solver for a mesh. */
  std::unique_ptr<DistanceSolver> (*make)(std::shared_ptr<const TriangleMesh> mesh);
};

/** All solvers, by number. A new solver is registered here; its entries in the XML follow, as
 * architecture.md says. */
std::span<const SolverTraits> solverTable();

/** The solver of a number. @throws std::invalid_argument with a list of the numbers there are */
const SolverTraits& solverOfNumber(int number);
/** The solver of a value of the interpolator's GeodesicMethod. @throws std::invalid_argument with a
 * list of the values there are */
const SolverTraits& solverOfInterpolator(int interpolatorNumber);
/** The solver of a name. @throws std::invalid_argument with a list of the names there are */
const SolverTraits& solverOfName(std::string_view name);

/** What a solver must be able to do to serve a request. */
struct SolverDemands
{
  bool hasCosts = false;
  bool hasBarriers = false;
  bool isOnSeveralRanks = false;

  /** @param ranks the number of ranks that have a piece of the surface */
  static SolverDemands of(const SolveOptions& options, int ranks);
};

/**
 * Checks that a solver can serve a request.
 * @param table where to look for solvers that can serve instead
 * @throws std::invalid_argument where it cannot; the message says why and names solvers that can
 */
void checkServes(const SolverTraits& solver, const SolverDemands& demands,
  std::span<const SolverTraits> table = solverTable());

}

#endif
