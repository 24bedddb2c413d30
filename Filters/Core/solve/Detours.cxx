// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/Detours.h"

#include "base/Interruption.h"
#include "base/Vector3.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace geodesic
{
namespace
{

/** How much dearer than a detour a triangle is that is bypassed. */
constexpr double LeastGain = 1.6;
/**
 * How much of the way to the cheap part counts. The edge between two vertices that are equally far
 * from it is bypassed from 2 / LeastGain on. As edges differ, and by what is left out fronts are
 * only a little slow, it is less.
 */
constexpr double PartOfWay = 0.7;

/** Spreads the costs of detours from vertex to vertex, the least first: Dijkstra's algorithm. */
class DetourSpreader
{
public:
  DetourSpreader(const TriangleMesh& mesh, std::span<const double> cost,
    std::span<const float> longestSides, std::vector<double>& detours)
    : Mesh(mesh)
    , Cost(cost)
    , LongestSides(longestSides)
    , Detours(detours)
  {
  }

  /** The least detour of a vertex by way of a neighbour, or its own. */
  double leastBeside(Index vertex) const
  {
    double least = this->Detours[vertex];
    for (const RingEntry& entry : this->Mesh.ring(vertex))
    {
      const Index neighbour = entry.neighbour();
      const double gain = least - this->Detours[neighbour];
      const auto [perLength, squaredLength] = this->wayBetween(vertex, neighbour);
      // Most neighbours are no way, which is told without a root.
      if ((gain > 0.0) & (gain * gain > perLength * perLength * squaredLength))
      {
        least = this->Detours[neighbour] + perLength * std::sqrt(squaredLength);
      }
    }
    return least;
  }

  /** Lowers the detour of a vertex; spread() makes its neighbours follow. */
  void lower(Index vertex, double detour)
  {
    if (detour < this->Detours[vertex])
    {
      this->Detours[vertex] = detour;
      this->Lowered.emplace(detour, vertex);
    }
  }

  void spread()
  {
    while (!this->Lowered.empty())
    {
      const auto [detour, vertex] = this->Lowered.top();
      this->Lowered.pop();
      if (detour == this->Detours[vertex])
      {
        for (const RingEntry& entry : this->Mesh.ring(vertex))
        {
          const Index neighbour = entry.neighbour();
          const auto [perLength, squaredLength] = this->wayBetween(vertex, neighbour);
          this->lower(neighbour, detour + perLength * std::sqrt(squaredLength));
        }
      }
    }
  }

private:
  struct Way
  {
    /** What each unit of length adds to a detour; infinity where all points are one place. */
    double perLength;
    double squaredLength;
  };
  /** The way between neighbours. */
  Way wayBetween(Index a, Index b) const
  {
    const Vector3 edge = this->Mesh.position(b) - this->Mesh.position(a);
    const double side = std::max(this->LongestSides[a], this->LongestSides[b]);
    return { 0.5 * PartOfWay * (this->Cost[a] + this->Cost[b]) / side, dot(edge, edge) };
  }

  const TriangleMesh& Mesh;
  std::span<const double> Cost;
  std::span<const float> LongestSides;
  std::vector<double>& Detours;
  using Waiting = std::pair<double, Index>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> Lowered;
};

}

Detours::Detours(const TriangleMesh& mesh, std::span<const double> cost,
  std::span<const float> longestSides, Partition& partition)
  : Limits(cost.begin(), cost.end())
{
  DetourSpreader spreader(mesh, cost, longestSides, this->Limits);
  // Most ways lead to a neighbour: after the first look few detours fall.
  for (Index vertex = 0; vertex < cost.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    this->Limits[vertex] = spreader.leastBeside(vertex);
  }
  for (Index vertex = 0; vertex < cost.size(); ++vertex)
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

}
