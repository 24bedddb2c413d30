// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/BoundedSolver.h"

#include "mesh/TriangleMesh.h"
#include "windows/WindowMerging.h"
#include "windows/WindowRequest.h"

#include <utility>
#include <vector>

namespace geodesic
{

BoundedSolver::BoundedSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
  , Edges(this->mesh())
  , Workspace(this->mesh())
{
}

bool BoundedSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const std::vector<Label>& labels = request.front.labels;
  checkWindowRequest("Bounded distances", request.hasCost, request.partition);
  const WindowMerging merging(request.options.tolerance);
  const PassableTriangles passable(this->mesh(), this->Edges, request.options);
  bool isFinished = false;
  {
    WindowFront front(this->mesh(), this->Edges, request.closed, passable, request.options,
      leastKeyOf(labels, limit), limit, field, this->Workspace, &merging);
    isFinished = marchFrom(request.seeds, this->mesh(), front);
  }
  for (const Index vertex : field.reached())
  {
    field.lowerDistance(vertex, field.distance(vertex) + this->Workspace.excesses[vertex]);
  }
  return isFinished;
}

}
