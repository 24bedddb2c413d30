// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockParts.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <map>

namespace geodesic::testing
{

vtkSmartPointer<vtkPolyData> partOf(
  vtkPolyData* surface, const std::function<bool(vtkIdType cell)>& isInside)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkIdTypeArray> whole;
  whole->SetName("Whole");
  std::map<vtkIdType, vtkIdType> numbers;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (!isInside(cell))
    {
      continue;
    }
    surface->GetCellPoints(cell, corners);
    faces->InsertNextCell(static_cast<int>(corners->GetNumberOfIds()));
    for (const vtkIdType corner : *corners)
    {
      const auto [entry, isNew] = numbers.emplace(corner, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(surface->GetPoint(corner));
        whole->InsertNextValue(corner);
      }
      faces->InsertCellPoint(entry->second);
    }
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(faces);
  part->GetPointData()->AddArray(whole);
  return part;
}

vtkSmartPointer<vtkPolyData> scatteredPart(vtkPolyData* surface, int part, int parts)
{
  return partOf(
    surface, [=](vtkIdType cell) { return cell * 2654435761u % 65521 % parts == unsigned(part); });
}

vtkSmartPointer<vtkPolyData> squareAt(double x, double y)
{
  vtkNew<vtkTransform> move;
  move->Translate(x, y, 0.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(move);
  moved->SetInputDataObject(square(4));
  moved->Update();
  return moved->GetOutput();
}

vtkSmartPointer<vtkMultiBlockDataSet> blocksOf(
  std::initializer_list<vtkSmartPointer<vtkDataObject>> leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const auto& leaf : leaves)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), leaf);
  }
  return blocks;
}

void setGlobalIds(vtkPolyData* surface, const std::function<vtkIdType(vtkIdType point)>& idOf)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalPointIds");
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    ids->InsertNextValue(idOf(point));
  }
  surface->GetPointData()->SetGlobalIds(ids);
}

void setWholeIds(vtkPolyData* part)
{
  auto* whole = vtkIdTypeArray::SafeDownCast(part->GetPointData()->GetArray("Whole"));
  setGlobalIds(part, [&](vtkIdType point) { return whole->GetValue(point); });
}

}
