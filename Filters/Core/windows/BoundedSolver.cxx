// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/BoundedSolver.h"

#include "windows/WindowMerging.h"

#include <utility>

namespace geodesic
{

BoundedSolver::BoundedSolver(std::shared_ptr<const TriangleMesh> mesh)
  : WindowSolver(std::move(mesh))
{
}

bool BoundedSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const WindowMerging merging(request.options.tolerance);
  this->Path.reset();
  const bool isFinished = this->marchWindows("Bounded distances", &merging, request, limit, field);
  if (this->Workspace.kept.areWanted())
  {
    this->Path.emplace(this->mesh(), this->Edges, *this->Passable, this->Workspace.kept,
      *this->Found, this->SeedPoints, this->SeedValues, this->Workspace.arrivals);
  }
  return isFinished;
}

std::vector<SurfacePoint> BoundedSolver::trace(
  const SurfacePoint& start, const PathStarts::Start& found) const
{
  return this->Path->from(start, found.arrival);
}

}
