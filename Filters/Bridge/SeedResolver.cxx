// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedResolver.h"

#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>

namespace geodesic::bridge
{
namespace
{

/** Calls @p visit with each vertex and the number of its point, or of a cell that it is a corner
 * of. */
void visitVertices(const InputSurface& surface, bool ofCells,
  const std::function<void(Index vertex, vtkIdType id)>& visit)
{
  const TriangleMesh& mesh = *surface.mesh();
  if (ofCells)
  {
    for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
    {
      for (Index vertex : mesh.triangle(t))
      {
        visit(vertex, surface.cellOfTriangle(t));
      }
    }
    return;
  }
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    if (mesh.vertexOfPoint(point) != NoIndex)
    {
      visit(mesh.vertexOfPoint(point), point);
    }
  }
}

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

RegionsByValue regionsOfArray(const InputSurface& surface, vtkDataArray* array, bool isOfCells)
{
  if (array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("SeedArray \"" + std::string(array->GetName()) + "\" has " +
      std::to_string(array->GetNumberOfComponents()) + " components; give an array of one.");
  }
  RegionsByValue regions;
  visitVertices(surface, isOfCells,
    [&](Index vertex, vtkIdType id)
    {
      const double value = array->GetComponent(id, 0);
      if (value != 0.0 && !std::isnan(value))
      {
        regions[value].push_back(vertex);
      }
    });
  return regions;
}

RegionsByValue regionOfIds(const InputSurface& surface, vtkDataArray* ids, bool areCells)
{
  std::set<vtkIdType> wanted;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    wanted.insert(static_cast<vtkIdType>(ids->GetComponent(i, 0)));
  }
  std::vector<Index> vertices;
  visitVertices(surface, areCells,
    [&](Index vertex, vtkIdType id)
    {
      if (wanted.count(id) > 0)
      {
        vertices.push_back(vertex);
      }
    });
  if (vertices.empty() && !wanted.empty())
  {
    throw std::invalid_argument(std::string("SeedSelection selects no ") +
      (areCells ? "cell" : "point") + " of the surface, of " + std::to_string(wanted.size()) +
      " that it names. Select others.");
  }
  return vertices.empty() ? RegionsByValue{} : RegionsByValue{ { 1.0, std::move(vertices) } };
}

std::vector<std::vector<SurfacePoint>> linesAmong(std::span<const Seed> seeds)
{
  std::vector<std::vector<SurfacePoint>> lines;
  for (const Seed& seed : seeds)
  {
    if (seed.kind == Seed::Kind::Curve)
    {
      lines.push_back(seed.points);
    }
  }
  return lines;
}

}
