// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sources/VirtualSourceSolver.h"

#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"
#include "sources/SourcePropagation.h"

#include <algorithm>
#include <stdexcept>

namespace geodesic
{
namespace
{

void checkServes(bool isDivided, bool hasCost, const SeedFront& front)
{
  if (isDivided)
  {
    throw std::invalid_argument("Virtual source propagation works on a surface in one piece only; "
                                "use fast marching on several ranks.");
  }
  if (hasCost)
  {
    throw std::invalid_argument("Virtual source propagation measures lengths only; use fast "
                                "marching for costs.");
  }
  const auto straight = std::find_if(front.labels.begin(), front.labels.end(),
    [](const Label& label) { return label.shape == FrontShape::Straight; });
  if (straight != front.labels.end())
  {
    throw std::invalid_argument("Seed " + std::to_string(straight->seed) +
      " is a curve or a region, but virtual source propagation measures from points only; use fast "
      "marching, or points as seeds.");
  }
}

}

VirtualSourceSolver::VirtualSourceSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
  , Workspace(this->mesh())
{
}

bool VirtualSourceSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  request.partition.together(
    [&] { checkServes(request.partition.isDivided(), request.hasCost, request.front); });
  SourcePropagation propagation(
    this->mesh(), request.front, request.closed, request.options, limit, field, this->Workspace);
  return propagation.run();
}

}
