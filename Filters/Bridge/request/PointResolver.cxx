// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/PointResolver.h"

#include "filter/VtkVersions.h"
#include "mesh/Carriers.h"

#include "vtkIdList.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace geodesic::bridge
{
namespace
{

[[noreturn]] void throwNoPoint(const std::string& role, vtkIdType id, vtkIdType count)
{
  throw std::invalid_argument(role + " point id " + std::to_string(id) + " does not exist: " +
    (count > 0 ? "the input has " + std::to_string(count) + " points, numbered from 0"
               : std::string("it is none of the input's GlobalPointIds")) +
    ". Choose one of them.");
}

[[noreturn]] void throwNotOnSurface(const std::string& role, vtkIdType id)
{
  throw std::invalid_argument(role + " point id " + std::to_string(id) +
    " is not on the surface: no triangle, polygon or strip uses it. Choose another point.");
}

/** The shortest height of a triangle, which is the one over its longest side. */
double shortestHeight(const TriangleMesh& mesh, Index triangle)
{
  const Triangle& corners = mesh.triangle(triangle);
  const Vector3 a = mesh.position(corners[1]) - mesh.position(corners[0]);
  const Vector3 b = mesh.position(corners[2]) - mesh.position(corners[0]);
  return norm(cross(a, b)) / std::max({ norm(a), norm(b), norm(b - a) });
}

}

SurfacePoint snappedAsSingle(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const Vector3 p = mesh.positionOf(point);
  const double largest = std::max({ std::abs(p.x), std::abs(p.y), std::abs(p.z) });
  const double blur = 4.0 * std::numeric_limits<float>::epsilon() * largest;
  return snapped(point, std::min(blur / shortestHeight(mesh, point.triangle), 0.01));
}

std::vector<Vector3> positionsAt(std::span<const double> coordinates, const std::string& property)
{
  if (coordinates.size() % 3 != 0)
  {
    throw std::invalid_argument(property + " has " + std::to_string(coordinates.size()) +
      " numbers, which is not a multiple of 3. Give x, y and z of each point.");
  }
  std::vector<Vector3> positions;
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const Vector3 position{ coordinates[i], coordinates[i + 1], coordinates[i + 2] };
    if (!isFinite(position))
    {
      std::ostringstream message;
      message << "Point " << i / 3 << " of " << property << " is at (" << position.x << ", "
              << position.y << ", " << position.z << "); give three finite numbers.";
      throw std::invalid_argument(message.str());
    }
    positions.push_back(position);
  }
  return positions;
}

Index vertexAtPoint(const TriangleMesh& mesh, vtkIdType id, const std::string& role)
{
  const auto count = static_cast<vtkIdType>(mesh.numberOfPoints());
  if (id < 0 || id >= count)
  {
    throwNoPoint(role, id, count);
  }
  const Index vertex = mesh.vertexOfPoint(static_cast<Index>(id));
  if (vertex == NoIndex)
  {
    throwNotOnSurface(role, id);
  }
  return vertex;
}

std::vector<Index> verticesAtPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role)
{
  std::vector<Index> vertices;
  const vtkIdType count = ids ? ids->GetNumberOfIds() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices.push_back(vertexAtPoint(mesh, ids->GetId(i), role));
  }
  return vertices;
}

std::vector<Index> verticesWithIds(
  const InputSurface& surface, vtkIdList* ids, const std::string& role)
{
  const BlockNumbering& numbering = surface.numbering();
  if (!ids || ids->GetNumberOfIds() == 0)
  {
    return {};
  }
  if (!numbering.hasUniqueIds())
  {
    throw std::invalid_argument(role + " point id " + std::to_string(ids->GetId(0)) +
      " could be in any of the input's " + std::to_string(numbering.numberOfBlocks()) +
      " blocks. Make GlobalPointIds for all blocks, " + MakeGlobalIdsOfBlocks +
      ", and give those, or give positions.");
  }
  const auto points = numbering.pointsWithIds({ ids->begin(), ids->end() });
  std::vector<Index> vertices;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const vtkIdType id = ids->GetId(static_cast<vtkIdType>(i));
    const auto isVertex = [&](Index point)
    { return surface.mesh()->vertexOfPoint(point) != NoIndex; };
    const auto point = std::find_if(points[i].begin(), points[i].end(), isVertex);
    if (id < 0 || (points[i].empty() && id >= numbering.numberOfIds()))
    {
      throwNoPoint(role, id, numbering.numberOfIds());
    }
    if (point == points[i].end())
    {
      throwNotOnSurface(role, id);
    }
    vertices.push_back(surface.mesh()->vertexOfPoint(*point));
  }
  return vertices;
}

Triangle targetAt(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const Carriers carriers = carriersOf(mesh, point);
  return { carriers[0], carriers[carriers.size() / 2], carriers[carriers.size() - 1] };
}

Triangle targetAt(Index vertex)
{
  return { vertex, vertex, vertex };
}

}
