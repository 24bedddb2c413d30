// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointSource.h"

#include "DataSetLeaves.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

namespace geodesic::bridge
{
namespace
{

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
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    if (type == VTK_LINE || type == VTK_POLY_LINE)
    {
      data->GetCellPoints(cell, points);
      if (points->GetNumberOfIds() == 0)
      {
        continue;
      }
      std::vector<std::size_t>& line = source.lines.emplace_back();
      for (const vtkIdType id : *points)
      {
        line.push_back(first + static_cast<std::size_t>(id));
      }
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
