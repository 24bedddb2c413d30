// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/PathAttributes.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace geodesic::bridge
{

vtkIdType InputPathAttributes::idOf(Index vertex) const
{
  return this->Surface.numbering().idOfPoint(this->mesh().pointOfVertex(vertex));
}

vtkIdType InputPathAttributes::blockOf(Index vertex) const
{
  return this->Surface.numbering().flatIndexOf(this->mesh().pointOfVertex(vertex));
}

std::optional<Vector3> InputPathAttributes::normalOf(Index vertex) const
{
  const BlockNumbering& numbering = this->Surface.numbering();
  const Index point = this->mesh().pointOfVertex(vertex);
  const std::size_t block = numbering.blockOfPoint(point);
  vtkDataArray* normals = this->Blocks[block].surface->GetPointData()->GetNormals();
  if (!normals)
  {
    return std::nullopt;
  }
  double n[3];
  normals->GetTuple(point - numbering.firstPointOf(block), n);
  return Vector3{ n[0], n[1], n[2] };
}

std::vector<ObjectVersion> InputPathAttributes::versions() const
{
  std::vector<ObjectVersion> versions;
  for (const InputBlock& block : this->Blocks)
  {
    versions.emplace_back(block.surface->GetPointData()->GetNormals());
    versions.emplace_back(block.globalPointIds());
  }
  return versions;
}

}
