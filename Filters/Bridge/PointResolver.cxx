// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointResolver.h"

#include "SeedFront.h"

#include "vtkCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace geodesic::bridge
{
namespace
{

/** The height over the longest side: the shortest way from a corner to the opposite side. */
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
      " numbers, which is no multiple of 3: give x, y and z of each point.");
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

std::vector<double> coordinatesOf(vtkPointSet* source)
{
  std::vector<double> coordinates(3 * source->GetNumberOfPoints());
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
  {
    source->GetPoint(i, coordinates.data() + 3 * i);
  }
  return coordinates;
}

std::vector<SurfacePoint> surfacePointsAt(
  const InputSurface& surface, std::span<const double> coordinates, const std::string& property)
{
  std::vector<SurfacePoint> points;
  for (const Vector3& position : positionsAt(coordinates, property))
  {
    points.push_back(surface.closestPoints().closestPoint(position).point);
  }
  return points;
}

std::vector<SurfacePoint> surfacePointsOf(
  const InputSurface& surface, vtkPointSet* source, const std::string& property)
{
  std::vector<SurfacePoint> points = surfacePointsAt(surface, coordinatesOf(source), property);
  for (SurfacePoint& point : points)
  {
    point = snappedAsSingle(*surface.mesh(), point);
  }
  return points;
}

std::vector<std::vector<vtkIdType>> linesOf(vtkPointSet* source)
{
  std::vector<std::vector<vtkIdType>> lines;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < source->GetNumberOfCells(); ++cell)
  {
    const int type = source->GetCellType(cell);
    if (type == VTK_LINE || type == VTK_POLY_LINE)
    {
      source->GetCellPoints(cell, points);
      lines.emplace_back(points->begin(), points->end());
    }
  }
  return lines;
}

std::vector<std::vector<SurfacePoint>> surfaceLinesOf(
  const InputSurface& surface, vtkPointSet* source, const std::string& property)
{
  const std::vector<SurfacePoint> points = surfacePointsOf(surface, source, property);
  std::vector<std::vector<SurfacePoint>> lines;
  for (const std::vector<vtkIdType>& ids : linesOf(source))
  {
    std::vector<SurfacePoint>& line = lines.emplace_back();
    for (vtkIdType id : ids)
    {
      line.push_back(points[id]);
    }
  }
  return lines;
}

Index vertexAtPoint(const TriangleMesh& mesh, vtkIdType id, const std::string& role)
{
  if (id < 0 || id >= static_cast<vtkIdType>(mesh.numberOfPoints()))
  {
    throw std::invalid_argument(role + " point id " + std::to_string(id) +
      " does not exist: the input has " + std::to_string(mesh.numberOfPoints()) +
      " points, numbered from 0. Choose one of them.");
  }
  const Index vertex = mesh.vertexOfPoint(static_cast<Index>(id));
  if (vertex == NoIndex)
  {
    throw std::invalid_argument(role + " point id " + std::to_string(id) +
      " is not on the surface: no triangle, polygon or strip uses it. Choose another point.");
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

Triangle targetAt(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const std::vector<Index> carriers = carriersOf(mesh, point);
  return { carriers.front(), carriers[carriers.size() / 2], carriers.back() };
}

Triangle targetAt(Index vertex)
{
  return { vertex, vertex, vertex };
}

}
