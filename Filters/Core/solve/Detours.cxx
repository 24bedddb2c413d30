// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/Detours.h"

#include "base/Interruption.h"
#include "base/Vector3.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"
#include "solve/SolveOptions.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace geodesic
{
namespace
{

/** How much dearer than a detour a triangle is that is bypassed; and so much more that the rounding
 * of its cost, which differs from corner to corner, does not decide. */
constexpr double LeastGain = 1.6 * (1.0 + 1e-9);
/** How much of the way to the cheap part counts. To and fro would be 2; it is less, as edges are of
 * several lengths, and as a triangle that is bypassed for nothing makes a front a little slow only.
 */
constexpr double PartOfWay = 0.7;

/** Spreads the costs of detours from vertex to vertex, the least first: Dijkstra's algorithm. */
class DetourSpreader
{
public:
  /** @param costs  of detours; at first of vertices */
  DetourSpreader(const TriangleMesh& mesh, std::span<const float> longestSides,
    const ClosedTriangles& closed, const SolveOptions& options, std::vector<double>& costs)
    : Mesh(mesh)
    , LongestSides(longestSides)
    , Closed(closed)
    , Options(options)
    , HasBarriers(!closed.isEmpty() || !options.excluded.empty())
    , Costs(costs)
  {
  }

  /** The least detour of a vertex by way of a neighbour, or its own. */
  double leastBeside(Index vertex) const
  {
    double least = this->Costs[vertex];
    const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const double there = this->Costs[ring[i].neighbour()];
      const double gain = least - there;
      const auto [perLength, squaredLength] = this->way(vertex, i);
      // Most neighbours are no way, which is told without a root.
      if ((gain > 0.0) & (gain * gain > perLength * perLength * squaredLength) &&
        this->isOpen(vertex, i))
      {
        least = there + perLength * std::sqrt(squaredLength);
      }
    }
    return least;
  }

  /** Lowers the detour of a vertex; spread() makes its neighbours follow. */
  void lower(Index vertex, double cost)
  {
    if (cost < this->Costs[vertex])
    {
      this->Costs[vertex] = cost;
      this->Lowered.emplace(cost, vertex);
    }
  }

  void spread()
  {
    for (std::size_t step = 0; !this->Lowered.empty(); ++step)
    {
      Interruption::checkAt(step);
      const auto [cost, vertex] = this->Lowered.top();
      this->Lowered.pop();
      const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
      for (std::size_t i = 0; i < ring.size() && cost == this->Costs[vertex]; ++i)
      {
        const auto [perLength, squaredLength] = this->way(vertex, i);
        if (this->isOpen(vertex, i))
        {
          this->lower(ring[i].neighbour(), cost + perLength * std::sqrt(squaredLength));
        }
      }
    }
  }

private:
  bool isOpen(Index vertex, std::size_t entry) const
  {
    return !this->HasBarriers ||
      (this->Closed.isOpenEdge(vertex, entry) &&
        !this->Options.isExcluded(this->Mesh.ring(vertex)[entry].neighbour()));
  }

  struct Way
  {
    /** What each unit of length adds to a detour; infinity where all points are one place. */
    double perLength;
    double squaredLength;
  };
  /** The way between a vertex and the neighbour of a ring entry. */
  Way way(Index vertex, std::size_t entry) const
  {
    const Index neighbour = this->Mesh.ring(vertex)[entry].neighbour();
    const Vector3 edge = this->Mesh.position(neighbour) - this->Mesh.position(vertex);
    const double side = std::max(this->LongestSides[vertex], this->LongestSides[neighbour]);
    const double cost = 0.5 * (this->Options.cost[vertex] + this->Options.cost[neighbour]);
    return { PartOfWay * cost / side, dot(edge, edge) };
  }

  const TriangleMesh& Mesh;
  std::span<const float> LongestSides;
  const ClosedTriangles& Closed;
  const SolveOptions& Options;
  bool HasBarriers;
  std::vector<double>& Costs;
  using Waiting = std::pair<double, Index>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> Lowered;
};

}

Detours::Detours(const TriangleMesh& mesh, std::span<const float> longestSides,
  const ClosedTriangles& closed, const SolveOptions& options, Partition& partition)
  : Limits(options.cost.begin(), options.cost.end())
{
  DetourSpreader spreader(mesh, longestSides, closed, options, this->Limits);
  // Most ways lead to a neighbour: after the first look few detours fall.
  for (Index vertex = 0; vertex < this->Limits.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    this->Limits[vertex] = spreader.leastBeside(vertex);
  }
  for (Index vertex = 0; vertex < this->Limits.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    spreader.lower(vertex, spreader.leastBeside(vertex));
  }
  bool isLowered = true;
  while (isLowered)
  {
    spreader.spread();
    std::vector<StartValue> own;
    for (const Index vertex : partition.sharedVertices())
    {
      own.push_back({ vertex, 0, this->Limits[vertex], false });
    }
    double lowered = 0.0;
    for (const StartValue& other : partition.exchange(own))
    {
      lowered = other.value < this->Limits[other.vertex] ? 1.0 : lowered;
      spreader.lower(other.vertex, other.value);
    }
    const std::vector<double> all = partition.gather({ &lowered, 1 });
    isLowered = *std::max_element(all.begin(), all.end()) > 0.0;
  }
  for (double& limit : this->Limits)
  {
    limit *= LeastGain;
  }
}

void Detours::bypassAt(std::span<const Index> vertices)
{
  for (const Index vertex : this->AtSeeds)
  {
    this->Limits[vertex] = std::abs(this->Limits[vertex]);
  }
  this->AtSeeds.assign(vertices.begin(), vertices.end());
  for (const Index vertex : vertices)
  {
    this->Limits[vertex] = -std::abs(this->Limits[vertex]);
  }
}

}
