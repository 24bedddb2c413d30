// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Inputs_h
#define geodesic_testing_Inputs_h

#include "Surfaces.h"

#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"

#include <cmath>
#include <initializer_list>
#include <string>

namespace geodesic::testing
{

/** The square [0, cells]^2 of unit cells, points row by row, each cell a quadrilateral or two
 * triangles. */
enum class Cells
{
  Triangles,
  Quadrilaterals,
  Strips
};
vtkSmartPointer<vtkPolyData> square(int cells, Cells kind = Cells::Triangles);

vtkSmartPointer<vtkPolyData> polyDataOf(const Surface& surface);

vtkSmartPointer<vtkPolyData> readData(const std::string& file);

vtkSmartPointer<vtkIdList> idList(std::initializer_list<vtkIdType> ids);

/** Runs a filter and returns what it reports as errors, empty if nothing. */
template <class Filter>
std::string errorsOf(Filter* filter)
{
  auto observer = vtkSmartPointer<vtkTest::ErrorObserver>::New();
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  // The executive adds a report of its own.
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  filter->RemoveObserver(observer);
  filter->GetExecutive()->RemoveObserver(observer);
  return observer->GetErrorMessage();
}

inline double distanceBetween(vtkPolyData* surface, vtkIdType a, vtkIdType b)
{
  double p[3];
  double q[3];
  surface->GetPoint(a, p);
  surface->GetPoint(b, q);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}

#endif
