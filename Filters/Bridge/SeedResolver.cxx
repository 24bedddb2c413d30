// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeedResolver.h"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

namespace geodesic::bridge
{
namespace
{

/** Calls @p visit with each vertex and the number of its point, or of a cell that it is a corner
 * of. */
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

std::vector<Seed> seedsAtPositions(const InputSurface& surface, std::span<const double> coordinates)
{
  std::vector<Seed> seeds;
  for (const SurfacePoint& point : surfacePointsAt(surface, coordinates, "SeedPositions"))
  {
    seeds.push_back(Seed::atPoint(point));
  }
  return seeds;
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

std::vector<Seed> seedsOfSource(const InputSurface& surface, const PointSource& source)
{
  const auto points = surfacePointsOf(surface, source, "SeedSource");
  std::vector<bool> isOnLine(points.size(), false);
  for (const auto& line : source.lines)
  {
    for (std::size_t number : line)
    {
      isOnLine[number] = true;
    }
  }
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!isOnLine[i])
    {
      seeds.push_back(Seed::atPoint(points[i]));
    }
  }
  for (const auto& line : source.lines)
  {
    std::vector<SurfacePoint> curve;
    for (std::size_t number : line)
    {
      curve.push_back(points[number]);
    }
    seeds.push_back(Seed::alongCurve(std::move(curve)));
  }
  return seeds;
}

std::vector<Seed> seedsOfArray(const InputSurface& surface, const ChosenArray& array)
{
  std::map<double, std::vector<Index>> regions;
  visitVertices(surface, array.isOfCells,
    [&](Index vertex, Index number)
    {
      const double value = array.values[number];
      if (value != 0.0 && !std::isnan(value))
      {
        regions[value].push_back(vertex);
      }
    });
  if (regions.empty())
  {
    throw std::invalid_argument(array.role +
      " is 0 on the whole surface, and seeds are where it is not. Choose another one, or None.");
  }
  std::vector<Seed> seeds;
  for (auto& [value, vertices] : regions)
  {
    seeds.push_back(Seed::onRegion(std::move(vertices)));
  }
  return seeds;
}

std::vector<Seed> seedsOfSelection(const InputSurface& surface, const SelectedElements& selected)
{
  std::vector<Seed> seeds;
  const auto add = [&](bool ofCells, const std::vector<std::uint8_t>& flags)
  {
    std::vector<Index> vertices;
    visitVertices(surface, ofCells,
      [&](Index vertex, Index number)
      {
        if (flags[number] != 0)
        {
          vertices.push_back(vertex);
        }
      });
    if (!vertices.empty())
    {
      seeds.push_back(Seed::onRegion(std::move(vertices)));
    }
  };
  add(false, selected.points);
  add(true, selected.cells);
  if (seeds.empty() && !selected.isEmpty)
  {
    throw std::invalid_argument(
      "SeedSelection selects no point of the surface and no cell. Select others.");
  }
  return seeds;
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
