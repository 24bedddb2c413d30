// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods/SolverTable.h"

#include "march/IntrinsicMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "solve/DijkstraSolver.h"
#include "sources/VirtualSourceSolver.h"
#include "windows/BoundedSolver.h"
#include "windows/ExactSolver.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace geodesic
{
namespace
{

template <class Solver>
std::unique_ptr<DistanceSolver> make(std::shared_ptr<const TriangleMesh> mesh)
{
  return std::make_unique<Solver>(std::move(mesh));
}

constexpr std::array Solvers{
  SolverTraits{ .number = 0,
    .name = "FastMarching",
    .interpolatorNumber = 1,
    .isOffered = true,
    .crossesFaces = true,
    .isExact = false,
    .takesCosts = true,
    .takesBarriers = true,
    .ranks = RankSupport::Partition,
    .bytesPerVertex = 41.0,
    .make = &make<IntrinsicMarchingSolver> },
  SolverTraits{ .number = 1,
    .name = "Dijkstra",
    .interpolatorNumber = 0,
    .isOffered = true,
    .crossesFaces = false,
    .isExact = false,
    .takesCosts = true,
    .takesBarriers = true,
    .ranks = RankSupport::Partition,
    .bytesPerVertex = 19.0,
    .make = &make<DijkstraSolver> },
  SolverTraits{ .number = 2,
    .name = "Exact",
    .interpolatorNumber = -1,
    .isOffered = true,
    .crossesFaces = true,
    .isExact = true,
    .takesCosts = false,
    .takesBarriers = true,
    .ranks = RankSupport::None,
    .bytesPerVertex = 250.0,
    .make = &make<ExactSolver> },
  SolverTraits{ .number = 3,
    .name = "VirtualSources",
    .interpolatorNumber = -1,
    .isOffered = true,
    .crossesFaces = true,
    .isExact = false,
    .takesCosts = false,
    .takesBarriers = true,
    .ranks = RankSupport::None,
    .bytesPerVertex = 920.0,
    .make = &make<VirtualSourceSolver> },
  SolverTraits{ .number = 4,
    .name = "Bounded",
    .interpolatorNumber = -1,
    .isOffered = true,
    .crossesFaces = true,
    .isExact = false,
    .takesCosts = false,
    .takesBarriers = true,
    .ranks = RankSupport::None,
    .bytesPerVertex = 250.0,
    .make = &make<BoundedSolver> },
  SolverTraits{ .number = 100,
    .name = "Reference",
    .interpolatorNumber = -1,
    .isOffered = false,
    .crossesFaces = true,
    .isExact = false,
    .takesCosts = true,
    .takesBarriers = true,
    .ranks = RankSupport::Partition,
    .bytesPerVertex = 51.0,
    .make = &make<ReferenceSolver> },
};

/** Lists the solvers that users may choose, for messages: "0 (FastMarching), 1 (Dijkstra)".
 * @param describe returns the text for a solver; one with an empty text is left out */
template <class Describe>
std::string listOf(std::span<const SolverTraits> solvers, const Describe& describe)
{
  std::string list;
  for (const SolverTraits& solver : solvers)
  {
    const std::string described = solver.isOffered ? describe(solver) : std::string();
    list += (list.empty() || described.empty() ? "" : ", ") + described;
  }
  return list;
}

template <class IsWanted, class Describe>
const SolverTraits& find(
  const IsWanted& isWanted, const std::string& wanted, const Describe& describe)
{
  const auto found = std::find_if(Solvers.begin(), Solvers.end(), isWanted);
  if (found == Solvers.end())
  {
    throw std::invalid_argument(
      "There is no method " + wanted + "; the methods are " + listOf(Solvers, describe) + ".");
  }
  return *found;
}

std::string numberAndName(int number, const char* name)
{
  return std::to_string(number) + " (" + name + ")";
}

}

std::span<const SolverTraits> solverTable()
{
  return Solvers;
}

const SolverTraits& solverOfNumber(int number)
{
  return find([&](const SolverTraits& solver) { return solver.number == number; },
    std::to_string(number),
    [](const SolverTraits& solver) { return numberAndName(solver.number, solver.name); });
}

const SolverTraits& solverOfInterpolator(int interpolatorNumber)
{
  return find([&](const SolverTraits& solver)
    { return solver.interpolatorNumber >= 0 && solver.interpolatorNumber == interpolatorNumber; },
    std::to_string(interpolatorNumber),
    [](const SolverTraits& solver)
    {
      return solver.interpolatorNumber >= 0 ? numberAndName(solver.interpolatorNumber, solver.name)
                                            : std::string();
    });
}

const SolverTraits& solverOfName(std::string_view name)
{
  return find([&](const SolverTraits& solver) { return solver.name == name; }, std::string(name),
    [](const SolverTraits& solver) { return std::string(solver.name); });
}

SolverDemands SolverDemands::of(const SolveOptions& options, int ranks)
{
  return { !options.cost.empty(), !options.excluded.empty() || !options.closedTriangles.empty(),
    ranks > 1 };
}

void checkServes(
  const SolverTraits& solver, const SolverDemands& demands, std::span<const SolverTraits> table)
{
  const auto check =
    [&](bool isDemanded, const char* what, const auto& serves, const char* remedy = "")
  {
    if (isDemanded && !serves(solver))
    {
      throw std::invalid_argument(std::string("The method ") + solver.name + " can't work with " +
        what + "; these can: " +
        listOf(table,
          [&](const SolverTraits& other)
          { return serves(other) ? std::string(other.name) : std::string(); }) +
        "." + remedy);
    }
  };
  check(demands.hasCosts, "costs", [](const SolverTraits& s) { return s.takesCosts; });
  check(demands.hasBarriers, "barriers", [](const SolverTraits& s) { return s.takesBarriers; });
  check(
    demands.isOnSeveralRanks, "a surface on several ranks",
    [](const SolverTraits& s) { return s.ranks != RankSupport::None; },
    " Or bring the surface to one rank: by GatherForExact of Geodesic Distance and Geodesic Path, "
    "or before by Aggregate Dataset.");
}

}
