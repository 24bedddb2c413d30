#include "DijkstraSolver.h"

#include "ClosedFans.h"
#include "CostedStart.h"
#include "MarchControl.h"
#include "StopLimit.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <tuple>

namespace geodesic
{

DijkstraSolver::DijkstraSolver(std::shared_ptr<const TriangleMesh> mesh)
  : DistanceSolver(std::move(mesh))
{
}

bool DijkstraSolver::march(const Request& request, StopLimit& limit, DistanceField& field)
{
  const TriangleMesh& mesh = this->mesh();
  // Nearest first; of equally near ones the smaller seed.
  const auto isAfter = [](const Trial& a, const Trial& b)
  { return std::tie(a.distance, a.seed) > std::tie(b.distance, b.seed); };
  const auto costOf = [&](Index vertex)
  { return request.options.cost.empty() ? 1.0 : request.options.cost[vertex]; };
  const auto propose = [&](Index vertex, double distance, Index seed)
  {
    const double old = field.distance(vertex);
    const bool isBetter = distance < old || (distance == old && seed < field.nearestSeed(vertex));
    if (isBetter && distance <= limit.value() && !request.options.isExcluded(vertex))
    {
      field.setDistance(vertex, distance);
      field.setNearestSeed(vertex, seed);
      this->Heap.push_back({ distance, vertex, seed });
      std::push_heap(this->Heap.begin(), this->Heap.end(), isAfter);
    }
  };

  this->Heap.clear();
  for (const FrontStart& start : request.front.starts)
  {
    const Label& label = request.front.labels[start.label];
    const bool isCosted = !request.options.cost.empty() && label.shape == FrontShape::Round;
    const double atOrigin =
      isCosted ? costAt(mesh, request.options.cost, label.origin) : costOf(start.vertex);
    const double meanCost = 0.5 * (atOrigin + costOf(start.vertex));
    propose(start.vertex, label.value + start.length * meanCost, label.seed);
  }
  MarchControl control(request.options, limit, mesh.numberOfVertices());
  while (!this->Heap.empty() && control.mayGoOn())
  {
    std::pop_heap(this->Heap.begin(), this->Heap.end(), isAfter);
    const Trial trial = this->Heap.back();
    this->Heap.pop_back();
    if (trial.distance > field.distance(trial.vertex) ||
      trial.seed != field.nearestSeed(trial.vertex))
    {
      continue;
    }
    const Vector3 centre = mesh.position(trial.vertex);
    const std::span<const RingEntry> ring = mesh.ring(trial.vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (request.closed.isOpenEdge(trial.vertex, i))
      {
        const Index neighbour = ring[i].neighbour();
        const double length = norm(mesh.position(neighbour) - centre);
        const double meanCost = 0.5 * (costOf(trial.vertex) + costOf(neighbour));
        propose(neighbour, trial.distance + length * meanCost, trial.seed);
      }
    }
  }
  return !control.isCancelled();
}

}
