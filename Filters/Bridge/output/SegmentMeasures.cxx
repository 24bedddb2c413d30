// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/SegmentMeasures.h"

#include "base/Vector3.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace geodesic::bridge
{
namespace
{

Vector3 positionOf(vtkPoints* points, vtkIdType id)
{
  double position[3];
  points->GetPoint(id, position);
  return { position[0], position[1], position[2] };
}

Vector3 middleOf(vtkPoints* points, const vtkIdType* ids, vtkIdType count)
{
  double length = 0.0;
  for (vtkIdType i = 1; i < count; ++i)
  {
    length += norm(positionOf(points, ids[i]) - positionOf(points, ids[i - 1]));
  }
  double left = 0.5 * length;
  for (vtkIdType i = 1; i < count; ++i)
  {
    const Vector3 from = positionOf(points, ids[i - 1]);
    const Vector3 step = positionOf(points, ids[i]) - from;
    const double part = norm(step);
    if (part >= left && part > 0.0)
    {
      return from + (left / part) * step;
    }
    left -= part;
  }
  return positionOf(points, ids[count - 1]);
}

}

void measureSegments(
  vtkPolyData* paths, vtkIdType count, vtkDoubleArray* lengths, vtkDoubleArray* middles)
{
  lengths->SetNumberOfTuples(count);
  lengths->Fill(-1.0);
  middles->SetNumberOfComponents(3);
  middles->SetNumberOfTuples(count);
  middles->Fill(0.0);
  vtkDataArray* segments = paths->GetCellData()->GetArray("Segment");
  vtkDataArray* values = paths->GetCellData()->GetArray("Length");
  for (vtkIdType line = 0; line < paths->GetNumberOfLines(); ++line)
  {
    const auto segment = static_cast<vtkIdType>(segments->GetComponent(line, 0));
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    paths->GetLines()->GetCellAtId(line, size, ids);
    const Vector3 middle = middleOf(paths->GetPoints(), ids, size);
    lengths->SetValue(segment, values->GetComponent(line, 0));
    middles->SetTuple3(segment, middle.x, middle.y, middle.z);
  }
}

}
