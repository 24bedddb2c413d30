// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/MarchingSolver.h"

#include "solve/CostedStart.h"
#include "solve/Partition.h"

#include <utility>

namespace geodesic
{

MarchingSolver::MarchingSolver(
  std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds)
  : FrontSolver(std::move(mesh))
  , Bounds(std::move(bounds))
{
}

bool MarchingSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const AgreedMargins margins(*this->Bounds, request.front.labels.size(), request.partition);
  if (!request.hasCost)
  {
    const UnitCost cost(this->mesh(), margins.ofVertices(), request.partition);
    const auto starts = unitStarts(request.front, request.partition);
    return this->marchFrom(starts, cost, request, limit, field);
  }
  if (!this->DiscSolver)
  {
    this->DiscSolver = this->another();
  }
  const VertexCost cost(
    this->mesh(), request.options.cost, margins.ofVertices(), request.partition);
  const auto starts = costedStarts(
    this->mesh(), request.front, request.options, request.partition, *this->DiscSolver);
  return this->marchFrom(starts, cost, request, limit, field);
}

}
