#include "DijkstraSolver.h"

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
  const auto propose = [&](Index vertex, double distance, Index seed)
  {
    const bool isExcluded = !request.options.excluded.empty() && request.options.excluded[vertex];
    const double old = field.distance(vertex);
    const bool isBetter = distance < old || (distance == old && seed < field.nearestSeed(vertex));
    if (isBetter && distance <= limit.value() && !isExcluded)
    {
      field.setDistance(vertex, distance);
      field.setNearestSeed(vertex, seed);
      this->Heap.push_back({ distance, vertex, seed });
      std::push_heap(this->Heap.begin(), this->Heap.end(), isAfter);
    }
  };

  this->Heap.clear();
  for (const SeedCorner& corner : request.corners)
  {
    propose(corner.vertex, corner.distance + request.seeds[corner.seed].value, corner.seed);
  }
  MarchControl control(request.options, limit);
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
    for (const RingEntry& entry : mesh.ring(trial.vertex))
    {
      const Index neighbour = entry.neighbour();
      propose(neighbour, trial.distance + norm(mesh.position(neighbour) - centre), trial.seed);
    }
  }
  return !control.isCancelled();
}

}
