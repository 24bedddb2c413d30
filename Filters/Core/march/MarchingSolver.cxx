// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/MarchingSolver.h"

#include "march/LabelDensity.h"
#include "march/StopReach.h"
#include "mesh/TriangleMesh.h"
#include "solve/CostedStart.h"
#include "solve/Partition.h"
#include "solve/StopLimit.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geodesic
{
MarchingSolver::MarchingSolver(
  std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const UpdateBounds> bounds)
  : FrontSolver(std::move(mesh))
  , Bounds(std::move(bounds))
{
}

bool MarchingSolver::renewFor(const TriangleMesh& mesh)
{
  this->Bounds = std::make_shared<UpdateBounds>(mesh);
  this->UnitReaches.reset();
  this->DiscSolver.reset();
  this->Lines.reset();
  this->WaysSolver.reset();
  return true;
}

bool MarchingSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const AgreedMargins margins(*this->Bounds, request.front.labels.size(), request.partition);
  if (!request.hasCost)
  {
    const UnitCost cost(this->mesh(), margins.ofVertices(), request.partition);
    if (limit.isPossible())
    {
      limit.setReaches(this->unitReaches(request.partition));
    }
    const auto starts = unitStarts(request.front, request.partition);
    return this->marchAtCost(starts, cost, request, limit, field);
  }
  if (!this->DiscSolver)
  {
    this->DiscSolver = this->another();
  }
  // The margins of several labels are this run's own.
  const bool isOneLabel = request.front.labels.size() == 1;
  if (!request.keepsSurface || !isOneLabel || !this->IsCostOfOneLabel)
  {
    this->LastCost.emplace(
      this->mesh(), margins.ofVertices(), request.closed, request.options, request.partition);
    this->IsCostOfOneLabel = isOneLabel;
    this->CostReaches.reset();
  }
  const VertexCost& cost = *this->LastCost;
  if (limit.isPossible())
  {
    if (!this->CostReaches)
    {
      this->CostReaches = stopReaches(this->mesh(), request.options.cost, request.partition);
    }
    limit.setReaches(*this->CostReaches);
  }
  std::vector<Index> atJumps;
  const auto starts = costedStarts(this->mesh(), request.front, request.closed, request.options,
    request.partition, *this->DiscSolver, atJumps);
  this->LastCost->bypassAt(atJumps);
  return this->marchAtCost(starts, cost, request, limit, field);
}

std::span<const float> MarchingSolver::unitReaches(Partition& partition)
{
  const double isMissing = this->UnitReaches ? 0.0 : 1.0;
  const std::vector<double> all = partition.gather({ &isMissing, 1 });
  if (*std::max_element(all.begin(), all.end()) > 0.0)
  {
    this->UnitReaches = stopReaches(this->mesh(), {}, partition);
  }
  return *this->UnitReaches;
}

template <class Cost>
bool MarchingSolver::marchAtCost(std::span<const StartValue> starts, const Cost& cost,
  const Request& request, StopLimit& limit, DistanceField& field)
{
  // Where costs are spread so much, the margin of a dear vertex holds nearly all labels.
  const bool areSpread = cost.queueOrder() == QueueOrder::ByValue;
  const bool areDense = labelsAreDense(this->mesh(), request.front, areSpread, request.partition);
  if (areDense || (request.front.labels.size() > 1 && cost.jumps()))
  {
    return this->marchWithinBounds(starts, cost, request, areDense, limit, field);
  }
  return this->marchFrom(starts, cost, request, nullptr, limit, field);
}

}
