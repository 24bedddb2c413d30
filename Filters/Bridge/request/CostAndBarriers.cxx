// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/CostAndBarriers.h"

#include "base/NumberText.h"

#include "vtkIdList.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace geodesic::bridge
{
namespace
{

bool isSet(double value)
{
  return value != 0.0 && !std::isnan(value);
}

}

std::vector<double> costOfValues(const InputSurface& surface, std::span<const double> values,
  CostMeaning meaning, const std::string& role)
{
  const TriangleMesh& mesh = *surface.mesh();
  std::vector<double> cost(mesh.numberOfVertices(), 0.0);
  std::vector<Index> count(mesh.numberOfVertices(), 0);
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    const Index vertex = mesh.vertexOfPoint(point);
    if (vertex == NoIndex)
    {
      continue;
    }
    const double value = values[point];
    if (!(value > 0.0 && std::isfinite(value)))
    {
      throw std::invalid_argument(role + " is " + textOf(value) + " at " +
        surface.numbering().nameOfPoint(point) +
        "; it must be positive and finite at every point of the surface. Take, for example, the "
        "absolute value plus a small constant.");
    }
    cost[vertex] += meaning == CostMeaning::Cost ? value : 1.0 / value;
    ++count[vertex];
  }
  for (Index v = 0; v < cost.size(); ++v)
  {
    // A vertex without points belongs only to triangles without an area, which no front crosses.
    cost[v] = count[v] > 0 ? cost[v] / count[v] : 1.0;
  }
  return cost;
}

std::vector<double> costOfArray(
  const InputSurface& surface, const ChosenArray& array, CostMeaning meaning)
{
  if (array.isOfCells)
  {
    throw std::invalid_argument(
      array.role + " is a cell array; give a point array, for example by Cell Data to Point Data.");
  }
  return costOfValues(surface, array.values, meaning, array.role);
}

void excludePoints(const TriangleMesh& mesh, vtkIdList* ids, Barriers& barriers)
{
  const vtkIdType count = ids ? ids->GetNumberOfIds() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType id = ids->GetId(i);
    if (id < 0 || id >= static_cast<vtkIdType>(mesh.numberOfPoints()))
    {
      throw std::invalid_argument("Exclusion point id " + std::to_string(id) +
        " does not exist: the input has " + std::to_string(mesh.numberOfPoints()) +
        " points, numbered from 0.");
    }
    const Index vertex = mesh.vertexOfPoint(static_cast<Index>(id));
    if (vertex != NoIndex)
    {
      barriers.excluded.resize(mesh.numberOfVertices(), 0);
      barriers.excluded[vertex] = 1;
    }
  }
}

void addBarrierArray(const InputSurface& surface, const ChosenArray& array, Barriers& barriers)
{
  const TriangleMesh& mesh = *surface.mesh();
  if (array.isOfCells)
  {
    barriers.closed.resize(mesh.numberOfTriangles(), 0);
    for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
    {
      barriers.closed[t] |= isSet(array.values[surface.cellOfTriangle(t)]);
    }
    return;
  }
  barriers.excluded.resize(mesh.numberOfVertices(), 0);
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    const Index vertex = mesh.vertexOfPoint(point);
    if (vertex != NoIndex && isSet(array.values[point]))
    {
      barriers.excluded[vertex] = 1;
    }
  }
}

}
