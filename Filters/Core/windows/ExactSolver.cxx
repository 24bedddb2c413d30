// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/ExactSolver.h"

#include "windows/WindowPath.h"

#include <utility>

namespace geodesic
{

ExactSolver::ExactSolver(std::shared_ptr<const TriangleMesh> mesh)
  : WindowSolver(std::move(mesh))
{
}

bool ExactSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  return this->marchWindows("Exact distances", nullptr, request, limit, field);
}

std::vector<SurfacePoint> ExactSolver::trace(
  const SurfacePoint& start, const PathStarts::Start& found) const
{
  WindowPath path(this->mesh(), this->Edges, *this->Passable, this->Workspace.junctions,
    *this->Found, this->SeedPoints, this->Workspace.arrivals);
  return path.from(start, found.distance, found.seed, found.arrival);
}

}
