// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/InputSurface.h"

#include "input/InputGeometry.h"
#include "input/ObjectVersion.h"
#include "input/PolyDataTriangles.h"
#include "input/VersionCache.h"
#include "march/UpdateBounds.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
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
  /** Of cells without faces, whose numbers come before those of the others. */
  vtkIdType faceless;

  friend bool operator==(const BlockPlace&, const BlockPlace&) = default;
};

/** Identifies the points and cells of an input. */
struct InputVersion
{
  PointIdentity identity;
  std::vector<ObjectVersion> points;
  /** The arrays of cells, of ghost cells, and of ids if they matter. */
  std::vector<ObjectVersion> cells;
  std::vector<BlockPlace> places;

  friend bool operator==(const InputVersion&, const InputVersion&) = default;
};

InputVersion versionOf(const InputBlocks& blocks, const PointIdentity& identity)
{
  InputVersion version{ identity, {}, {}, {} };
  for (const InputBlock& block : blocks)
  {
    vtkPolyData* surface = block.surface;
    version.points.emplace_back(surface->GetPoints());
    version.cells.insert(version.cells.end(),
      { surface->GetPolys(), surface->GetStrips(), surface->GetCellGhostArray() });
    if (identity.by == PointIdentity::By::GlobalIds)
    {
      version.cells.emplace_back(block.globalPointIds());
    }
    version.places.push_back({ block.flatIndex, block.block, block.name,
      surface->GetNumberOfVerts() + surface->GetNumberOfLines() });
  }
  return version;
}

/** Whether points of equal coordinates are one vertex; nothing where kindsOfPoints() decides. */
std::optional<CoincidentPoints> coincidentPoints(
  const InputBlocks& blocks, const PointIdentity& identity)
{
  if (identity.by == PointIdentity::By::Nothing)
  {
    return CoincidentPoints::Separate;
  }
  const bool isWithinBlocks = !identity.acrossBlocks && blocks.size() > 1;
  if (identity.by == PointIdentity::By::Coordinates && !isWithinBlocks)
  {
    return CoincidentPoints::Merge;
  }
  return {};
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
  const InputBlocks& blocks, const PointIdentity& identity, const ThreadTeam& team)
{
  static VersionCache<InputVersion, const InputSurface> known;
  return known.get(versionOf(blocks, identity),
    [&](const InputVersion& version, const auto& held)
    {
      InputGeometry geometry(blocks, identity.rank);
      for (const auto& other : held)
      {
        const bool canMove =
          other.version.identity == version.identity && other.version.places == version.places;
        if (auto surface = canMove
            ? moved(*other.made, other.version.cells == version.cells, geometry, identity, team)
            : nullptr)
        {
          return surface;
        }
      }
      auto surface = built(geometry, identity, team);
      if (!identity.rank)
      {
        checkNotEmpty(*surface->mesh(), blocks);
      }
      return surface;
    });
}

InputSurface::InputSurface(BlockNumbering numbering, std::shared_ptr<const TriangleMesh> mesh)
  : Numbering(std::move(numbering))
  , Mesh(std::move(mesh))
  , ClosestPoints(std::make_unique<const PointSearch>(this->Mesh))
{
}

std::shared_ptr<const InputSurface> InputSurface::built(
  InputGeometry& geometry, const PointIdentity& identity, const ThreadTeam& team)
{
  SurfaceTriangles& triangles = geometry.triangles();
  const auto coincident = coincidentPoints(geometry.blocks(), identity);
  auto mesh = coincident
    ? std::make_shared<const TriangleMesh>(
        geometry.points(), triangles.corners, *coincident, team, &updateMeasurer())
    : std::make_shared<const TriangleMesh>(geometry.points(), triangles.corners,
        kindsOfPoints(geometry.blocks(), identity, geometry.points()), team, &updateMeasurer());
  const std::shared_ptr<InputSurface> surface(
    new InputSurface(geometry.numbering(), std::move(mesh)));
  surface->Cells = sourceCellsOf(std::move(triangles.cells));
  surface->IsCutByPositions = triangles.areCutByPositions;
  return surface;
}

std::shared_ptr<const InputSurface> InputSurface::moved(const InputSurface& held, bool hasSameCells,
  InputGeometry& geometry, const PointIdentity& identity, const ThreadTeam& team)
{
  const TriangleMesh& mesh = *held.mesh();
  if (geometry.points().size() != mesh.numberOfPoints())
  {
    return nullptr;
  }
  const bool keepsTriangles = hasSameCells ? !held.IsCutByPositions
                                           : geometry.blocks().size() == 1 &&
      held.Cells->cells.empty() && areTrianglesOf(geometry.blocks()[0].surface, mesh, team);
  if (!keepsTriangles && !mesh.isMadeOf(geometry.triangles().corners))
  {
    return nullptr;
  }
  const auto coincident = coincidentPoints(geometry.blocks(), identity);
  auto movedMesh = coincident
    ? mesh.withPositions(geometry.points(), *coincident, team)
    : mesh.withPositions(
        geometry.points(), kindsOfPoints(geometry.blocks(), identity, geometry.points()), team);
  if (!movedMesh)
  {
    return nullptr;
  }
  const std::shared_ptr<InputSurface> surface(new InputSurface(
    geometry.numbering(), std::make_shared<const TriangleMesh>(std::move(*movedMesh))));
  surface->Cells =
    keepsTriangles ? held.Cells : sourceCellsOf(std::move(geometry.triangles().cells));
  surface->IsCutByPositions =
    keepsTriangles ? held.IsCutByPositions : geometry.triangles().areCutByPositions;
  return surface;
}

std::shared_ptr<const InputSurface::SourceCells> InputSurface::sourceCellsOf(
  std::vector<Index> cells)
{
  SourceCells source;
  source.first = cells.empty() ? 0 : cells.front();
  for (Index t = 0; t < cells.size(); ++t)
  {
    if (cells[t] != source.first + t)
    {
      source.cells = std::move(cells);
      break;
    }
  }
  return std::make_shared<const SourceCells>(std::move(source));
}

Index InputSurface::cellOfTriangle(Index triangle) const
{
  const Index source = this->Mesh->sourceOfTriangle(triangle);
  return this->Cells->cells.empty() ? this->Cells->first + source : this->Cells->cells[source];
}

}
