// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNearestOnLines.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "base/Vector3.h"

#include <algorithm>
#include <limits>

using geodesic::Vector3;

vtkStandardNewMacro(vtkNearestOnLines);

namespace
{

Vector3 pointOf(vtkPolyData* lines, vtkIdType id)
{
  double position[3];
  lines->GetPoint(id, position);
  return { position[0], position[1], position[2] };
}

Vector3 nearestOnSegment(const Vector3& query, const Vector3& from, const Vector3& to)
{
  const Vector3 along = to - from;
  const double length2 = dot(along, along);
  const double part = length2 > 0.0 ? dot(query - from, along) / length2 : 0.0;
  return from + std::clamp(part, 0.0, 1.0) * along;
}

}

vtkNearestOnLines::vtkNearestOnLines() = default;

vtkNearestOnLines::~vtkNearestOnLines() = default;

void vtkNearestOnLines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Line: " << this->Answer[0] << "\n";
}

void vtkNearestOnLines::SetInputConnection(vtkAlgorithmOutput* input)
{
  if (input != this->Input)
  {
    this->Input = input;
    this->Producer = input ? input->GetProducer() : nullptr;
    this->Modified();
  }
}

void vtkNearestOnLines::SetArrayName(const char* name)
{
  this->ArrayName = name ? name : "";
  this->Modified();
}

void vtkNearestOnLines::Find()
{
  std::fill(this->Answer + 1, this->Answer + 4, 0.0);
  this->Answer[0] = -1.0;
  auto* lines = this->Producer
    ? vtkPolyData::SafeDownCast(this->Producer->GetOutputDataObject(this->Input->GetIndex()))
    : nullptr;
  vtkDataArray* names = lines ? lines->GetCellData()->GetArray(this->ArrayName.c_str()) : nullptr;
  if (!names || names->GetNumberOfTuples() < lines->GetNumberOfCells())
  {
    return;
  }
  const Vector3 query{ this->Position[0], this->Position[1], this->Position[2] };
  double least = std::numeric_limits<double>::infinity();
  // The cells of vertices come before those of lines.
  vtkIdType cell = lines->GetNumberOfVerts();
  auto line = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell(), ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    line->GetCurrentCell(count, ids);
    for (vtkIdType i = 1; i < count; ++i)
    {
      const Vector3 nearest =
        nearestOnSegment(query, pointOf(lines, ids[i - 1]), pointOf(lines, ids[i]));
      const double distance = norm(nearest - query);
      if (distance < least)
      {
        least = distance;
        this->Answer[0] = names->GetComponent(cell, 0);
        this->Answer[1] = nearest.x;
        this->Answer[2] = nearest.y;
        this->Answer[3] = nearest.z;
      }
    }
  }
}
