// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "request/PointSource.h"

#include "input/DataSetLeaves.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace geodesic::bridge
{
namespace
{

/** @param first the number of the data set's first point in the source */
void appendLine(vtkIdList* points, std::size_t first, PointSource& source)
{
  if (points->GetNumberOfIds() == 0)
  {
    return;
  }
  std::vector<std::size_t>& line = source.lines.emplace_back();
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    line.push_back(first + static_cast<std::size_t>(points->GetId(i)));
  }
}

void append(vtkDataSet* data, PointSource& source)
{
  const std::size_t first = source.coordinates.size() / 3;
  const vtkIdType count = data->GetNumberOfPoints();
  source.coordinates.resize(3 * (first + count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    data->GetPoint(i, source.coordinates.data() + 3 * (first + i));
  }
  vtkNew<vtkIdList> points;
  // VTK 9.1 can't number the cells of a vtkPolyData if a line has no points.
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    vtkCellArray* lines = polyData->GetLines();
    for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
    {
      lines->GetCellAtId(line, points);
      appendLine(points, first, source);
    }
    return;
  }
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    if (type == VTK_LINE || type == VTK_POLY_LINE)
    {
      data->GetCellPoints(cell, points);
      appendLine(points, first, source);
    }
  }
}

}

PointSource::PointSource(vtkDataObject* data)
{
  for (const DataSetLeaf& leaf : leavesOf(data))
  {
    append(leaf.data, *this);
  }
}

}
