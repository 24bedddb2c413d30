// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/HubVertices.h"

#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"
#include "solve/StartValue.h"

#include <algorithm>
#include <map>

namespace geodesic
{
namespace
{

double trianglesAt(const TriangleMesh& mesh, Index vertex)
{
  const auto ring = mesh.ring(vertex);
  return static_cast<double>(std::count_if(
    ring.begin(), ring.end(), [](const RingEntry& entry) { return entry.opensTriangle(); }));
}

}

std::vector<Index> hubVertices(
  const TriangleMesh& mesh, std::span<const Index> among, Partition& partition)
{
  std::map<Index, double> counts;
  std::vector<StartValue> own;
  for (const Index vertex : partition.sharedVertices())
  {
    own.push_back({ vertex, 0, trianglesAt(mesh, vertex), false });
    counts[vertex] = own.back().value;
  }
  for (const StartValue& other : partition.exchange(own))
  {
    counts[other.vertex] += other.value;
  }
  for (const Index vertex : among)
  {
    if (mesh.ring(vertex).size() > MostTrianglesElsewhere)
    {
      counts.try_emplace(vertex, trianglesAt(mesh, vertex));
    }
  }
  std::vector<Index> hubs;
  for (const auto& [vertex, count] : counts)
  {
    if (count > static_cast<double>(MostTrianglesElsewhere))
    {
      hubs.push_back(vertex);
    }
  }
  return hubs;
}

bool hasHubs(const TriangleMesh& mesh, Partition& partition)
{
  std::vector<Index> largest;
  for (Index vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    if (mesh.ring(vertex).size() > MostTrianglesElsewhere)
    {
      largest.push_back(vertex);
    }
  }
  const double isAny = hubVertices(mesh, largest, partition).empty() ? 0.0 : 1.0;
  const std::vector<double> all = partition.gather({ &isAny, 1 });
  return *std::max_element(all.begin(), all.end()) > 0.0;
}

}
