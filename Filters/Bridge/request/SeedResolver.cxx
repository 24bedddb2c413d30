// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/SeedResolver.h"

#include <cmath>
#include <functional>

namespace geodesic::bridge
{
namespace
{

/**
 * Calls @p visit with each vertex and the number of its point, or with each corner of a triangle
 * and the number of the triangle's cell.
 */
void visitVertices(const InputSurface& surface, bool ofCells,
  const std::function<void(Index vertex, Index number)>& visit)
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

std::vector<Seed> seedsAtVertices(const TriangleMesh& mesh, std::span<const Index> vertices)
{
  std::vector<Seed> seeds;
  for (Index vertex : vertices)
  {
    seeds.push_back(Seed::atPoint(mesh.pointAtVertex(vertex)));
  }
  return seeds;
}

RegionsByValue regionsOfArray(const InputSurface& surface, const ChosenArray& array)
{
  RegionsByValue regions;
  visitVertices(surface, array.isOfCells,
    [&](Index vertex, Index number)
    {
      const double value = array.values[number];
      if (value != 0.0 && !std::isnan(value))
      {
        regions[value].push_back(vertex);
      }
    });
  return regions;
}

RegionsByValue regionsOfSelection(const InputSurface& surface, const SelectedElements& selected)
{
  RegionsByValue regions;
  const auto add = [&](bool ofCells, const std::vector<std::uint8_t>& flags)
  {
    visitVertices(surface, ofCells,
      [&](Index vertex, Index number)
      {
        if (flags[number] != 0)
        {
          regions[ofCells ? 1.0 : 0.0].push_back(vertex);
        }
      });
  };
  add(false, selected.points);
  add(true, selected.cells);
  return regions;
}

}
