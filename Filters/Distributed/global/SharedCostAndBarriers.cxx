// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "global/SharedCostAndBarriers.h"

#include "mesh/TriangleMesh.h"
#include "pieces/SharedPoints.h"

#include <map>
#include <set>
#include <span>

namespace geodesic::distributed
{

void shareCost(RankGroup& ranks, const DistributedSurface& surface, std::vector<double>& cost)
{
  const std::span<const Index> shared = surface.shared().vertices();
  std::vector<StartValue> own;
  for (std::size_t i = 0; i < shared.size() && !cost.empty(); ++i)
  {
    own.push_back({ shared[i], 0, cost[shared[i]], false });
  }
  // The costs are sorted, so that their sums are the same on all ranks to the last bit.
  std::map<Index, std::multiset<double>> costsOf;
  for (const StartValue& other : surface.shared().exchange(ranks, own))
  {
    costsOf[other.vertex].insert(other.value);
  }
  for (auto& [vertex, costs] : costsOf)
  {
    costs.insert(cost[vertex]);
    if (*costs.begin() == *costs.rbegin())
    {
      continue;
    }
    double sum = 0.0;
    for (const double value : costs)
    {
      sum += value;
    }
    cost[vertex] = sum / static_cast<double>(costs.size());
  }
}

void shareExcluded(RankGroup& ranks, const DividedMesh& mesh, std::vector<std::uint8_t>& excluded)
{
  std::vector<StartValue> own;
  for (const Index vertex : mesh.shared().vertices())
  {
    if (!excluded.empty() && excluded[vertex])
    {
      own.push_back({ vertex, 0, 0.0, false });
    }
  }
  for (const StartValue& other : mesh.shared().exchange(ranks, own))
  {
    excluded.resize(mesh.mesh().numberOfVertices(), 0);
    excluded[other.vertex] = 1;
  }
}

}
