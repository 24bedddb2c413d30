// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/OpenVertices.h"

#include "base/Interruption.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"

namespace geodesic
{

std::vector<std::uint8_t> openVertices(const TriangleMesh& mesh, const SolveOptions& options,
  std::span<const std::uint8_t> never, Partition& partition)
{
  const ClosedTriangles closed(mesh, options.closedTriangles);
  std::vector<std::uint8_t> isOpen(mesh.numberOfVertices(), 0);
  for (Index vertex = 0; vertex < isOpen.size(); ++vertex)
  {
    Interruption::checkAt(vertex);
    isOpen[vertex] = closed.hasOpenTriangle(vertex) ? 1 : 0;
  }
  std::vector<StartValue> shared;
  for (const Index vertex : partition.sharedVertices())
  {
    if (isOpen[vertex])
    {
      shared.push_back({ vertex, 0, 0.0, false });
    }
  }
  for (const StartValue& other : partition.exchange(shared))
  {
    isOpen[other.vertex] = 1;
  }
  for (Index vertex = 0; vertex < isOpen.size(); ++vertex)
  {
    const bool isNever =
      options.isExcluded(vertex) || (!never.empty() && never[vertex]) || !partition.owns(vertex);
    isOpen[vertex] = isNever ? 0 : isOpen[vertex];
  }
  return isOpen;
}

Seed seedAtVertex(
  const TriangleMesh& mesh, Index vertex, const Vector3& position, Partition& partition)
{
  std::vector<StartValue> own;
  std::vector<Index> here;
  if (vertex != NoIndex)
  {
    own.push_back({ vertex, 0, 0.0, false });
    here.push_back(vertex);
  }
  for (const StartValue& other : partition.exchange(own))
  {
    here.push_back(other.vertex);
  }
  std::vector<SurfacePoint> points;
  // The triangles of a vertex can all be on other pieces.
  if (!here.empty() && !mesh.ring(here.front()).empty())
  {
    points.push_back(mesh.pointAtVertex(here.front()));
  }
  return Seed::atPosition(position, points);
}

}
