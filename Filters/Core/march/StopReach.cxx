// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/StopReach.h"

#include "base/Interruption.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace geodesic
{
namespace
{

constexpr float PartsOfLongestSide = 2.0f;
constexpr double PartOfEdge = 0.5;

/** Spreads reaches from vertex to vertex, the largest first. */
class ReachSpreader
{
public:
  ReachSpreader(const TriangleMesh& mesh, std::span<const double> cost, std::vector<float>& reaches)
    : Mesh(mesh)
    , Cost(cost)
    , Reaches(reaches)
  {
  }

  /** Raises the reach of a vertex; spread() makes its neighbours follow. */
  void raise(Index vertex, float reach)
  {
    if (reach > this->Reaches[vertex])
    {
      this->Reaches[vertex] = reach;
      this->Raised.emplace(reach, vertex);
    }
  }

  void raiseNeighbours(Index vertex)
  {
    const float reach = this->Reaches[vertex];
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Index neighbour = ring[i].neighbour();
      if (reach > this->Reaches[neighbour])
      {
        this->raise(neighbour, static_cast<float>(reach - this->fallTo(vertex, i)));
      }
    }
  }

  void spread()
  {
    while (!this->Raised.empty())
    {
      const auto [reach, vertex] = this->Raised.top();
      this->Raised.pop();
      if (reach == this->Reaches[vertex])
      {
        this->raiseNeighbours(vertex);
      }
    }
  }

private:
  /** @param entry of the neighbour in the ring of the vertex */
  double fallTo(Index vertex, std::size_t entry) const
  {
    const Index neighbour = this->Mesh.ring(vertex)[entry].neighbour();
    const double length = norm(this->Mesh.toNeighbour(vertex, entry));
    const double cost =
      this->Cost.empty() ? 1.0 : std::min(this->Cost[neighbour], this->Cost[vertex]);
    return PartOfEdge * cost * length;
  }

  const TriangleMesh& Mesh;
  std::span<const double> Cost;
  std::vector<float>& Reaches;
  std::priority_queue<std::pair<float, Index>> Raised;
};

std::vector<float> ownReaches(
  const TriangleMesh& mesh, std::span<const double> cost, const Partition& partition)
{
  const std::span<const float> sides =
    partition.isDivided() ? partition.longestSides() : mesh.rings().longestSides();
  std::vector<float> reaches(sides.begin(), sides.end());
  for (Index vertex = 0; vertex < reaches.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    reaches[vertex] *= PartsOfLongestSide;
    if (!cost.empty())
    {
      double dearest = cost[vertex];
      for (const RingEntry& entry : mesh.ring(vertex))
      {
        dearest = std::max(dearest, cost[entry.neighbour()]);
      }
      reaches[vertex] *= static_cast<float>(dearest);
    }
  }
  return reaches;
}

}

std::vector<float> stopReaches(
  const TriangleMesh& mesh, std::span<const double> cost, Partition& partition)
{
  std::vector<float> reaches = ownReaches(mesh, cost, partition);
  ReachSpreader spreader(mesh, cost, reaches);
  for (Index vertex = 0; vertex < reaches.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    spreader.raiseNeighbours(vertex);
  }
  bool isRaised = true;
  while (isRaised)
  {
    spreader.spread();
    std::vector<StartValue> own;
    for (const Index vertex : partition.sharedVertices())
    {
      own.push_back({ vertex, 0, reaches[vertex], false });
    }
    double raised = 0.0;
    for (const StartValue& other : partition.exchange(own))
    {
      const auto reach = static_cast<float>(other.value);
      raised = reach > reaches[other.vertex] ? 1.0 : raised;
      spreader.raise(other.vertex, reach);
    }
    const std::vector<double> all = partition.gather({ &raised, 1 });
    isRaised = *std::max_element(all.begin(), all.end()) > 0.0;
  }
  return reaches;
}

}
