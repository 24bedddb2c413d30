// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/InputSurface.h"

#include "input/ObjectVersion.h"
#include "input/PolyDataTriangles.h"
#include "input/VersionCache.h"
#include "march/UpdateBounds.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic::bridge
{
namespace
{

/** What the surface tells of a block: its place among the others, and its name. */
struct BlockPlace
{
  unsigned int flatIndex;
  unsigned int number;
  std::string name;

  friend bool operator==(const BlockPlace&, const BlockPlace&) = default;
};

/** Identifies the points and cells of an input. */
struct InputVersion
{
  PointIdentity points;
  std::vector<ObjectVersion> parts;
  std::vector<BlockPlace> places;

  friend bool operator==(const InputVersion&, const InputVersion&) = default;
};

InputVersion versionOf(const InputBlocks& blocks, const PointIdentity& points)
{
  InputVersion version{ points, {}, {} };
  for (const InputBlock& block : blocks)
  {
    vtkPolyData* surface = block.surface;
    version.parts.insert(version.parts.end(),
      { surface->GetPoints(), surface->GetPolys(), surface->GetStrips(),
        surface->GetCellGhostArray() });
    if (points.by == PointIdentity::By::GlobalIds)
    {
      version.parts.emplace_back(block.globalPointIds());
    }
    version.places.push_back({ block.flatIndex, block.block, block.name });
  }
  return version;
}

/** Reserves memory for all blocks at once. Polygons can give more triangles than are reserved. */
void reserve(const InputBlocks& blocks, std::vector<Vector3>& points, SurfaceTriangles& triangles)
{
  vtkIdType numberOfPoints = 0;
  vtkIdType numberOfPolygons = 0;
  for (const InputBlock& block : blocks)
  {
    numberOfPoints += block.surface->GetNumberOfPoints();
    numberOfPolygons += block.surface->GetNumberOfPolys();
  }
  points.reserve(numberOfPoints);
  triangles.corners.reserve(numberOfPolygons);
  triangles.cells.reserve(numberOfPolygons);
}

std::shared_ptr<const TriangleMesh> meshOf(const InputBlocks& blocks, const PointIdentity& identity,
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles,
  const ThreadTeam& team)
{
  const bool areAllSeparate = identity.by == PointIdentity::By::Nothing;
  const bool isWithinBlocks = !identity.acrossBlocks && blocks.size() > 1;
  if (areAllSeparate || (identity.by == PointIdentity::By::Coordinates && !isWithinBlocks))
  {
    return std::make_shared<const TriangleMesh>(points, triangles,
      areAllSeparate ? CoincidentPoints::Separate : CoincidentPoints::Merge, team,
      &updateMeasurer());
  }
  return std::make_shared<const TriangleMesh>(
    points, triangles, kindsOfPoints(blocks, identity, points), team, &updateMeasurer());
}

void checkNotEmpty(const TriangleMesh& mesh, const InputBlocks& blocks)
{
  if (mesh.numberOfTriangles() == 0)
  {
    vtkIdType cells = 0;
    for (const InputBlock& block : blocks)
    {
      cells += block.surface->GetNumberOfCells();
    }
    throw std::invalid_argument(
      "The input has no surface: " + std::to_string(mesh.numberOfPoints()) +
      " points, and no triangle, polygon or strip with an area among its " + std::to_string(cells) +
      " cells. Give a surface, for example by Extract Surface.");
  }
}

}

std::shared_ptr<const InputSurface> InputSurface::of(
  const InputBlocks& blocks, const PointIdentity& points, const ThreadTeam& team)
{
  static VersionCache<InputVersion, const InputSurface> known;
  return known.get(versionOf(blocks, points),
    [&]
    {
      auto surface = std::make_shared<const InputSurface>(blocks, points, team);
      if (!points.rank)
      {
        checkNotEmpty(*surface->mesh(), blocks);
      }
      return surface;
    });
}

InputSurface::InputSurface(
  const InputBlocks& blocks, const PointIdentity& identity, const ThreadTeam& team)
  : Numbering(blocks, identity.rank)
{
  std::vector<Vector3> points;
  SurfaceTriangles triangles;
  reserve(blocks, points, triangles);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    appendPoints(blocks[i].surface, points);
    appendTriangles(blocks[i].surface, points, this->Numbering.firstPointOf(i),
      this->Numbering.firstCellOf(i), triangles);
  }
  this->Mesh = meshOf(blocks, identity, points, triangles.corners, team);
  if (triangles.cells.empty())
  {
    return;
  }
  this->FirstCell = triangles.cells.front();
  for (Index t = 0; t < triangles.cells.size(); ++t)
  {
    if (triangles.cells[t] != this->FirstCell + t)
    {
      this->CellOfSource = std::move(triangles.cells);
      break;
    }
  }
}

Index InputSurface::cellOfTriangle(Index triangle) const
{
  const Index source = this->Mesh->sourceOfTriangle(triangle);
  return this->CellOfSource.empty() ? this->FirstCell + source : this->CellOfSource[source];
}

const ClosestPointTree& InputSurface::closestPoints() const
{
  std::call_once(this->ClosestPointsBuilt,
    [this] { this->ClosestPoints = std::make_unique<ClosestPointTree>(this->Mesh); });
  return *this->ClosestPoints;
}

}
