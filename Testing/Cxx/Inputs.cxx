// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkXMLPolyDataReader.h"

namespace geodesic::testing
{

vtkSmartPointer<vtkPolyData> square(int cells, Cells kind)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      points->InsertNextPoint(i, j, 0.0);
    }
  }
  const auto id = [cells](vtkIdType i, vtkIdType j) { return j * (cells + 1) + i; };
  vtkNew<vtkCellArray> faces;
  for (int j = 0; j < cells; ++j)
  {
    if (kind == Cells::Strips)
    {
      faces->InsertNextCell(2 * (cells + 1));
      for (int i = 0; i <= cells; ++i)
      {
        faces->InsertCellPoint(id(i, j));
        faces->InsertCellPoint(id(i, j + 1));
      }
      continue;
    }
    for (int i = 0; i < cells; ++i)
    {
      const vtkIdType corners[4] = { id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) };
      if (kind == Cells::Quadrilaterals)
      {
        faces->InsertNextCell(4, corners);
      }
      else
      {
        faces->InsertNextCell({ corners[0], corners[1], corners[2] });
        faces->InsertNextCell({ corners[0], corners[2], corners[3] });
      }
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  if (kind == Cells::Strips)
  {
    surface->SetStrips(faces);
  }
  else
  {
    surface->SetPolys(faces);
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> polyDataOf(const Surface& surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& p : surface.points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const Triangle& t : surface.triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

vtkSmartPointer<vtkPolyData> readData(const std::string& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((std::string(GEODESICS_DATA_DIRECTORY "/") + file).c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkIdList> idList(std::initializer_list<vtkIdType> ids)
{
  auto list = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType id : ids)
  {
    list->InsertNextId(id);
  }
  return list;
}

}
