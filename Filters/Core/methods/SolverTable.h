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
  /** As users see it; the text of the XML entry. */
  const char* name;
  /** The number of the contour interpolator's GeodesicMethod; -1: it does not offer the solver. */
  int interpolatorNumber;
  /** Whether the filters' XML offers it; others are for tests. */
  bool isOffered;
  /** Distances go across faces, and so do paths; else along edges only. */
  bool crossesFaces;
  /** Distances are those of the polyhedron, rounding aside. */
  bool isExact;
  bool takesCosts;
  bool takesBarriers;
  RankSupport ranks;
  /** Bytes a vertex that a solver holds after a whole field from one seed, beside the mesh. */
  double bytesPerVertex;

  std::unique_ptr<DistanceSolver> (*make)(std::shared_ptr<const TriangleMesh> mesh);
};

/** All solvers, by number. A new solver is registered here and nowhere else. */
std::span<const SolverTraits> solverTable();

/** @throws std::invalid_argument naming the numbers there are */
const SolverTraits& solverOfNumber(int number);
/** The solver of an interpolator's GeodesicMethod. @throws std::invalid_argument */
const SolverTraits& solverOfInterpolator(int interpolatorNumber);
/** @throws std::invalid_argument naming the solvers there are */
const SolverTraits& solverOfName(std::string_view name);

/** What a request asks of a solver. */
struct SolverDemands
{
  bool hasCosts = false;
  bool hasBarriers = false;
  bool isOnSeveralRanks = false;

  /** @param ranks on how many of them the surface is */
  static SolverDemands of(const SolveOptions& options, int ranks);
};

/**
 * @param table where to look for solvers that can serve instead
 * @throws std::invalid_argument that says what the solver cannot do, and which ones can
 */
void checkServes(const SolverTraits& solver, const SolverDemands& demands,
  std::span<const SolverTraits> table = solverTable());

}

#endif
