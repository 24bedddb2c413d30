// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/SurfaceNormals.h"

#include "vtkDataArray.h"

namespace geodesic::bridge
{
namespace
{

Vector3 normalized(const Vector3& v)
{
  const double length = norm(v);
  return length > 0.0 ? 1.0 / length * v : Vector3{ 0.0, 0.0, 1.0 };
}

/** The normal of a triangle on its front, twice its area long. */
Vector3 normalOf(const TriangleMesh& mesh, const Triangle& t)
{
  return cross(
    mesh.position(t[1]) - mesh.position(t[0]), mesh.position(t[2]) - mesh.position(t[0]));
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

Vector3 SurfaceNormals::at(const PathPoint& point)
{
  Vector3 normal;
  for (Index vertex : point.carriers())
  {
    normal = normal + weightOf(point, vertex) * this->atVertex(vertex);
  }
  return normalized(normal);
}

void SurfaceNormals::makeAll()
{
  std::vector<Vector3> all(this->Mesh.numberOfVertices());
  for (const Triangle& t : this->Mesh.triangles())
  {
    const Vector3 normal = normalOf(this->Mesh, t);
    for (const Index corner : t)
    {
      all[corner] = all[corner] + normal;
    }
  }
  for (Index vertex = 0; vertex < this->Mesh.numberOfVertices(); ++vertex)
  {
    all[vertex] = normalized(this->OfInput(vertex).value_or(all[vertex]));
  }
  this->All = std::move(all);
}

const Vector3& SurfaceNormals::atVertex(Index vertex)
{
  if (!this->All.empty())
  {
    return this->All[vertex];
  }
  const auto [known, isNew] = this->Made.try_emplace(vertex);
  if (isNew)
  {
    known->second = this->makeAtVertex(vertex);
  }
  return known->second;
}

Vector3 SurfaceNormals::makeAtVertex(Index vertex) const
{
  if (const std::optional<Vector3> normal = this->OfInput(vertex))
  {
    return normalized(*normal);
  }
  Vector3 sum;
  for (const Index triangle : this->Mesh.trianglesWith({ &vertex, 1 }))
  {
    sum = sum + normalOf(this->Mesh, this->Mesh.triangle(triangle));
  }
  return normalized(sum);
}

}
