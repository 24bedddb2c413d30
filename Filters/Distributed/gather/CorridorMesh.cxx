// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gather/CorridorMesh.h"

#include "path/PathPoint.h"

#include <algorithm>

namespace geodesic::distributed
{
namespace
{

TriangleMesh meshOf(const Corridor& corridor)
{
  std::vector<Vector3> points;
  for (const PatchVertex& vertex : corridor.vertices())
  {
    points.push_back(vertex.position);
  }
  std::vector<Triangle> triangles;
  for (const PatchTriangle& triangle : corridor.triangles())
  {
    triangles.push_back({ triangle.corners[0], triangle.corners[1], triangle.corners[2] });
  }
  // One thread is enough for a small mesh, while other ranks of this machine have work as well.
  return TriangleMesh(points, triangles, CoincidentPoints::Separate, ThreadTeam(1));
}

}

CorridorMesh::CorridorMesh(const Corridor& corridor, bool hasCost)
  : Vertices(corridor.vertices())
  , Mesh(meshOf(corridor))
  , Field(this->Mesh.numberOfVertices())
{
  for (Index v = 0; v < this->Mesh.numberOfVertices(); ++v)
  {
    const PatchVertex& vertex = this->vertex(v);
    this->VertexOf.emplace(vertex.vertex, v);
    if (hasCost)
    {
      this->Cost.push_back(vertex.cost);
    }
    this->Excluded.push_back(vertex.isExcluded ? 1 : 0);
    this->Incomplete.push_back(corridor.isComplete(this->Mesh.pointOfVertex(v)) ? 0 : 1);
  }
  for (Index t = 0; t < this->Mesh.numberOfTriangles(); ++t)
  {
    const Index source = this->Mesh.sourceOfTriangle(t);
    this->Closed.push_back(corridor.triangles()[source].isClosed ? 1 : 0);
  }
}

std::optional<Vector3> CorridorMesh::normalOf(Index vertex) const
{
  const PatchVertex& known = this->vertex(vertex);
  return known.hasNormal ? std::optional(known.normal) : std::nullopt;
}

SolveOptions CorridorMesh::options() const
{
  SolveOptions options;
  options.cost = this->Cost;
  options.excluded = this->Excluded;
  options.closedTriangles = this->Closed;
  options.incomplete = this->Incomplete;
  return options;
}

std::vector<SurfacePoint> CorridorMesh::pointsOf(std::span<const GlobalPoint> points) const
{
  std::vector<SurfacePoint> local;
  for (const GlobalPoint& point : points)
  {
    PathPoint path{ {}, point.weights };
    for (int c = 0; c < 3; ++c)
    {
      path.corners[c] = this->find(point.corners[c]);
    }
    local.push_back(surfacePointOf(this->Mesh, path));
  }
  return local;
}

const DistanceField& CorridorMesh::fieldOf(const Corridor& corridor, StopReason reason)
{
  this->Field.reset();
  for (Index v = 0; v < this->Mesh.numberOfVertices(); ++v)
  {
    const PatchVertex& now = corridor.vertices()[this->Mesh.pointOfVertex(v)];
    if (now.distance < DistanceField::Unreached)
    {
      this->Field.setDistance(v, now.distance);
      this->Field.setNearestSeed(v, now.nearestSeed);
    }
  }
  this->Field.finish(DistanceField::Unreached, reason);
  return this->Field;
}

}
