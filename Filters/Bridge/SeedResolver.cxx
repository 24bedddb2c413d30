// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedResolver.h"

#include "vtkIdList.h"

#include <sstream>
#include <stdexcept>

namespace geodesic::bridge
{
namespace
{

/** The vertex of a point, NoIndex where no cell uses the point. */
Index vertexAt(const TriangleMesh& mesh, vtkIdType id, const std::string& role)
{
  if (id < 0 || id >= static_cast<vtkIdType>(mesh.numberOfPoints()))
  {
    throw std::invalid_argument(role + " point id " + std::to_string(id) +
      " does not exist: the input has " + std::to_string(mesh.numberOfPoints()) +
      " points, numbered from 0.");
  }
  return mesh.vertexOfPoint(static_cast<Index>(id));
}

}

std::vector<Seed> seedsAtPositions(const InputSurface& surface, std::span<const double> coordinates)
{
  if (coordinates.size() % 3 != 0)
  {
    throw std::invalid_argument("SeedPositions has " + std::to_string(coordinates.size()) +
      " numbers, which is no multiple of 3: give x, y and z of each seed.");
  }
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const Vector3 position{ coordinates[i], coordinates[i + 1], coordinates[i + 2] };
    if (!isFinite(position))
    {
      std::ostringstream message;
      message << "Seed " << i / 3 << " of SeedPositions is at (" << position.x << ", " << position.y
              << ", " << position.z << "); give three finite numbers.";
      throw std::invalid_argument(message.str());
    }
    seeds.push_back(Seed::atPoint(surface.closestPoints().closestPoint(position).point));
  }
  return seeds;
}

std::vector<Index> verticesAtPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role)
{
  std::vector<Index> vertices;
  const vtkIdType count = ids ? ids->GetNumberOfIds() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Index vertex = vertexAt(mesh, ids->GetId(i), role);
    if (vertex == NoIndex)
    {
      throw std::invalid_argument(role + " point id " + std::to_string(ids->GetId(i)) +
        " is not on the surface: no triangle, polygon or strip uses it. Choose another point.");
    }
    vertices.push_back(vertex);
  }
  return vertices;
}

std::vector<Seed> seedsAtPoints(const TriangleMesh& mesh, vtkIdList* ids)
{
  std::vector<Seed> seeds;
  for (Index vertex : verticesAtPoints(mesh, ids, "Seed"))
  {
    seeds.push_back(Seed::atPoint(mesh.pointAtVertex(vertex)));
  }
  return seeds;
}

std::vector<std::uint8_t> maskOfPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role)
{
  std::vector<std::uint8_t> mask;
  const vtkIdType count = ids ? ids->GetNumberOfIds() : 0;
  if (count > 0)
  {
    mask.resize(mesh.numberOfVertices(), 0);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Index vertex = vertexAt(mesh, ids->GetId(i), role);
    if (vertex != NoIndex)
    {
      mask[vertex] = 1;
    }
  }
  return mask;
}

}
