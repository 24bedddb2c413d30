// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/PathOutput.h"

#include "output/SurfaceNormals.h"

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

PathOutput::PathOutput(double heightOffset, bool namesBlocks)
  : HeightOffset(heightOffset)
  , NamesBlocks(namesBlocks)
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

double PathOutput::add(
  const PathAttributes& attributes, const SurfacePath& path, vtkIdType segment, double arcLength)
{
  const TriangleMesh& mesh = attributes.mesh();
  const SurfaceNormals normals(mesh, [&](Index vertex) { return attributes.normalOf(vertex); });
  double length = 0.0;
  // A polyline needs at least two points.
  const std::size_t count = std::max<std::size_t>(path.size(), 2);
  this->Lines->InsertNextCell(static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    const PathPoint& point = path[std::min(i, path.size() - 1)];
    const Vector3 position = point.position(mesh);
    if (i > 0)
    {
      length += norm(position - path[i - 1].position(mesh));
    }
    const Vector3 normal = normals.at(point);
    const Vector3 raised = position + this->HeightOffset * normal;
    this->Lines->InsertCellPoint(this->Points->InsertNextPoint(raised.x, raised.y, raised.z));
    const std::vector<Index> nearest = nearestCarriers(point);
    const Index first = nearest[0];
    const Index second = nearest[nearest.size() > 1 ? 1 : 0];
    this->ArcLengths->InsertNextValue(arcLength + length);
    this->OriginalPointIds->InsertNextValue(attributes.idOf(first));
    this->OriginalBlocks->InsertNextValue(attributes.blockOf(first));
    for (Index end : { first, second })
    {
      this->EdgePointIds->InsertNextValue(attributes.idOf(end));
      this->EdgeBlocks->InsertNextValue(attributes.blockOf(end));
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
  pointData->SetScalars(this->ArcLengths);
  pointData->AddArray(this->OriginalPointIds);
  pointData->AddArray(this->EdgePointIds);
  if (this->NamesBlocks)
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

}
