// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/InputGeometry.h"

#include "vtkPolyData.h"

namespace geodesic::bridge
{

InputGeometry::InputGeometry(const InputBlocks& blocks, std::optional<int> rank)
  : Blocks(blocks)
  , Numbering(blocks, rank)
{
}

std::span<const Vector3> InputGeometry::points()
{
  if (!this->Points)
  {
    vtkIdType count = 0;
    for (const InputBlock& block : this->Blocks)
    {
      count += block.surface->GetNumberOfPoints();
    }
    this->Points.emplace().reserve(count);
    for (const InputBlock& block : this->Blocks)
    {
      appendPoints(block.surface, *this->Points);
    }
  }
  return *this->Points;
}

SurfaceTriangles& InputGeometry::triangles()
{
  if (!this->Triangles)
  {
    // Polygons can give more triangles than are reserved.
    vtkIdType count = 0;
    for (const InputBlock& block : this->Blocks)
    {
      count += block.surface->GetNumberOfPolys();
    }
    SurfaceTriangles& triangles = this->Triangles.emplace();
    triangles.corners.reserve(count);
    triangles.cells.reserve(count);
    for (std::size_t i = 0; i < this->Blocks.size(); ++i)
    {
      appendTriangles(this->Blocks[i].surface, this->points(), this->Numbering.firstPointOf(i),
        this->Numbering.firstCellOf(i), triangles);
    }
  }
  return *this->Triangles;
}

}
