// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods/SolverTeam.h"

#include "base/MachineMemory.h"
#include "mesh/TriangleMesh.h"
#include "methods/SolverTable.h"

#include <algorithm>

namespace geodesic
{

void SolverTeam::prepare(
  const SolverTraits& method, const std::shared_ptr<const TriangleMesh>& mesh, std::size_t threads)
{
  if (this->Method != &method)
  {
    this->Solvers.clear();
  }
  for (auto& solver : this->Solvers)
  {
    if (solver && &solver->mesh() != mesh.get() && !solver->moveTo(mesh))
    {
      solver.reset();
    }
  }
  this->Method = &method;
  this->Mesh = mesh;
  constexpr double shareOfOthers = 0.25;
  const double bytes = method.bytesPerVertex * std::max<Index>(mesh->numberOfVertices(), 1);
  const auto most =
    static_cast<std::size_t>(1.0 + shareOfOthers * static_cast<double>(machineMemory()) / bytes);
  this->Solvers.resize(std::min(threads, most));
}

DistanceSolver& SolverTeam::ofThread(std::size_t thread)
{
  auto& solver = this->Solvers[thread];
  if (!solver)
  {
    solver = this->Method->make(this->Mesh);
  }
  return *solver;
}

std::size_t SolverTeam::memoryOfEach(std::size_t limit) const
{
  const std::size_t all = limit > 0 ? limit : machineMemory() / 4 * 3;
  return std::max<std::size_t>(all / this->Solvers.size(), 1);
}

std::size_t SolverTeam::stepsToMakeOne() const
{
  // Starting a thread takes as long as some thousand steps.
  constexpr std::size_t least = 4096;
  return least + this->Mesh->numberOfVertices() / 8;
}

}
