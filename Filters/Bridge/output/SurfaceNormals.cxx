// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/SurfaceNormals.h"

#include "vtkDataArray.h"

#include <array>
#include <span>

namespace geodesic::bridge
{
namespace
{

Vector3 normalized(const Vector3& v)
{
  const double length = norm(v);
  return length > 0.0 ? 1.0 / length * v : Vector3{ 0.0, 0.0, 1.0 };
}

}

SurfaceNormals::SurfaceNormals(const TriangleMesh& mesh, vtkDataArray* inputNormals)
  : SurfaceNormals(mesh,
      [&mesh, inputNormals](Index vertex) -> std::optional<Vector3>
      {
        if (!inputNormals)
        {
          return std::nullopt;
        }
        double n[3];
        inputNormals->GetTuple(mesh.pointOfVertex(vertex), n);
        return Vector3{ n[0], n[1], n[2] };
      })
{
}

Vector3 SurfaceNormals::at(const PathPoint& point) const
{
  Vector3 normal;
  for (Index vertex : point.carriers())
  {
    normal = normal + weightOf(point, vertex) * this->atVertex(vertex);
  }
  return normalized(normal);
}

Vector3 SurfaceNormals::atVertex(Index vertex) const
{
  if (const std::optional<Vector3> normal = this->OfInput(vertex))
  {
    return normalized(*normal);
  }
  Vector3 sum;
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (ring[i].opensTriangle())
    {
      // Rings have no orientation, but the triangle has the orientation of the input's face.
      const std::array<Index, 3> corners{ vertex, ring[i].neighbour(), ring[i + 1].neighbour() };
      const Triangle& t = this->Mesh.triangle(this->Mesh.trianglesWith(corners).front());
      sum = sum +
        cross(this->Mesh.position(t[1]) - this->Mesh.position(t[0]),
          this->Mesh.position(t[2]) - this->Mesh.position(t[0]));
    }
  }
  return normalized(sum);
}

}
