// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/ExactSolver.h"

#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic
{

ExactSolver::ExactSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
  , Edges(this->mesh())
  , Workspace(this->mesh())
{
}

bool ExactSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  if (request.hasCost || request.partition.isDivided())
  {
    throw std::invalid_argument(std::string("Exact distances can't be measured ") +
      (request.hasCost ? "with costs" : "on a surface in several pieces") +
      "; use the method FastMarching.");
  }
  const std::vector<Label>& labels = request.front.labels;
  double first = DistanceField::Unreached;
  for (const Label& label : labels)
  {
    if (label.shape == FrontShape::Straight)
    {
      throw std::invalid_argument("Seed " + std::to_string(label.seed) +
        " is a curve or a region, but exact distances are measured from points; use the method "
        "FastMarching, or give points along it as seeds.");
    }
    first = std::min(first, label.value);
  }
  WindowFront front(this->mesh(), this->Edges, request.closed, request.options, first, limit, field,
    this->Workspace);
  for (const Label& label : labels)
  {
    front.startAt(label.origin, label.value, label.seed);
  }
  return front.march();
}

}
