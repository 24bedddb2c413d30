// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/DijkstraSolver.h"

#include "solve/CostedStart.h"
#include "solve/Partition.h"

#include <span>

namespace geodesic
{
DijkstraSolver::DijkstraSolver(std::shared_ptr<const TriangleMesh> mesh)
  : FrontSolver(std::move(mesh))
{
}

bool DijkstraSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  EdgeFront front(this->mesh(), request.closed, request.options, limit, field, this->Heap,
    EdgeFront::Counts::LowerOrSmallerSeed);
  for (const StartValue& start : this->starts(request))
  {
    const Label& label = request.front.labels[start.label];
    front.propose(start.vertex, label.seed, label.value + start.value);
  }
  return request.partition.march(front, limit);
}

std::vector<StartValue> DijkstraSolver::starts(const Request& request) const
{
  const std::span<const double> cost = request.options.cost;
  const std::vector<Label>& labels = request.front.labels;
  std::vector<double> atOrigins(labels.size(), 1.0);
  for (std::size_t i = 0; i < labels.size() && request.hasCost; ++i)
  {
    if (labels[i].shape == FrontShape::Round)
    {
      atOrigins[i] = costAtOrigin(this->mesh(), cost, labels[i], request.partition);
    }
  }
  std::vector<StartValue> starts = unitStarts(request.front, request.partition);
  for (StartValue& start : starts)
  {
    const double atVertex = cost.empty() ? 1.0 : cost[start.vertex];
    const bool isRound = labels[start.label].shape == FrontShape::Round;
    start.value *= 0.5 * ((isRound ? atOrigins[start.label] : atVertex) + atVertex);
  }
  return starts;
}

}
