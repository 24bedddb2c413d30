// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace geodesic::bridge
{
namespace
{

Vector3 normalized(const Vector3& v)
{
  const double length = norm(v);
  return length > 0.0 ? 1.0 / length * v : Vector3{ 0.0, 0.0, 1.0 };
}

/** The vertices that carry a point, nearest first. */
std::vector<Index> nearestCarriers(const PathPoint& point)
{
  const Carriers carriers = point.carriers();
  std::vector<Index> nearest(carriers.begin(), carriers.end());
  std::stable_sort(nearest.begin(), nearest.end(),
    [&](Index a, Index b) { return weightOf(point, a) > weightOf(point, b); });
  return nearest;
}

}

PathOutput::PathOutput(const InputSurface& surface, const InputBlocks& blocks, double heightOffset)
  : Surface(surface)
  , Mesh(*surface.mesh())
  , Blocks(blocks)
  , HeightOffset(heightOffset)
{
  this->Points->SetDataTypeToDouble();
  this->ArcLengths->SetName("ArcLength");
  this->OriginalPointIds->SetName("OriginalPointIds");
  this->EdgePointIds->SetName("EdgePointIds");
  this->EdgePointIds->SetNumberOfComponents(2);
  this->OriginalBlocks->SetName("OriginalBlocks");
  this->EdgeBlocks->SetName("EdgeBlocks");
  this->EdgeBlocks->SetNumberOfComponents(2);
  this->Normals->SetName("Normals");
  this->Normals->SetNumberOfComponents(3);
  this->Segments->SetName("Segment");
  this->Lengths->SetName("Length");
}

PathOutput::~PathOutput() = default;

double PathOutput::add(const SurfacePath& path, vtkIdType segment, double arcLength)
{
  double length = 0.0;
  // A polyline has two points at least.
  const std::size_t count = std::max<std::size_t>(path.size(), 2);
  this->Lines->InsertNextCell(static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    const PathPoint& point = path[std::min(i, path.size() - 1)];
    const Vector3 position = point.position(this->Mesh);
    if (i > 0)
    {
      length += norm(position - path[i - 1].position(this->Mesh));
    }
    const Vector3 normal = this->normalAt(point);
    const Vector3 raised = position + this->HeightOffset * normal;
    this->Lines->InsertCellPoint(this->Points->InsertNextPoint(raised.x, raised.y, raised.z));
    const std::vector<Index> nearest = nearestCarriers(point);
    const Index first = this->Mesh.pointOfVertex(nearest[0]);
    const Index second = this->Mesh.pointOfVertex(nearest[nearest.size() > 1 ? 1 : 0]);
    const BlockNumbering& numbering = this->Surface.numbering();
    this->ArcLengths->InsertNextValue(arcLength + length);
    this->OriginalPointIds->InsertNextValue(numbering.idOfPoint(first));
    this->OriginalBlocks->InsertNextValue(numbering.flatIndexOf(first));
    for (Index end : { first, second })
    {
      this->EdgePointIds->InsertNextValue(numbering.idOfPoint(end));
      this->EdgeBlocks->InsertNextValue(numbering.flatIndexOf(end));
    }
    this->Normals->InsertNextTuple3(normal.x, normal.y, normal.z);
  }
  this->Segments->InsertNextValue(segment);
  this->Lengths->InsertNextValue(length);
  this->TotalLength += length;
  return length;
}

void PathOutput::writeTo(vtkPolyData* output) const
{
  output->Initialize();
  output->SetPoints(this->Points);
  output->SetLines(this->Lines);
  vtkPointData* pointData = output->GetPointData();
  // A line that is not coloured is hard to see on a surface of the same colour.
  pointData->SetScalars(this->ArcLengths);
  pointData->AddArray(this->OriginalPointIds);
  pointData->AddArray(this->EdgePointIds);
  if (!this->Surface.numbering().hasUniqueIds())
  {
    pointData->AddArray(this->OriginalBlocks);
    pointData->AddArray(this->EdgeBlocks);
  }
  pointData->SetNormals(this->Normals);
  output->GetCellData()->AddArray(this->Segments);
  output->GetCellData()->AddArray(this->Lengths);
  vtkNew<vtkDoubleArray> total;
  total->SetName("TotalLength");
  total->InsertNextValue(this->TotalLength);
  output->GetFieldData()->AddArray(total);
}

Vector3 PathOutput::normalAt(const PathPoint& point) const
{
  Vector3 normal;
  for (Index vertex : point.carriers())
  {
    normal = normal + weightOf(point, vertex) * this->normalAtVertex(vertex);
  }
  return normalized(normal);
}

Vector3 PathOutput::normalAtVertex(Index vertex) const
{
  const BlockNumbering& numbering = this->Surface.numbering();
  const Index point = this->Mesh.pointOfVertex(vertex);
  const std::size_t block = numbering.blockOfPoint(point);
  if (vtkDataArray* normals = this->Blocks[block].surface->GetPointData()->GetNormals())
  {
    double n[3];
    normals->GetTuple(point - numbering.firstPointOf(block), n);
    return normalized({ n[0], n[1], n[2] });
  }
  Vector3 sum;
  const std::span<const RingEntry> ring = this->Mesh.ring(vertex);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (ring[i].opensTriangle())
    {
      // Rings have no orientation; the triangle itself has the input's.
      const std::array<Index, 3> corners{ vertex, ring[i].neighbour(), ring[i + 1].neighbour() };
      const Triangle& t = this->Mesh.triangle(this->Mesh.trianglesWith(corners).front());
      sum = sum +
        cross(this->Mesh.position(t[1]) - this->Mesh.position(t[0]),
          this->Mesh.position(t[2]) - this->Mesh.position(t[0]));
    }
  }
  return normalized(sum);
}

}
