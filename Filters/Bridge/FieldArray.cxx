// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldArray.h"

#include "DistanceField.h"
#include "TriangleMesh.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

namespace geodesic::bridge
{
namespace
{

bool isReached(const TriangleMesh& mesh, const DistanceField& field, Index point)
{
  const Index vertex = mesh.vertexOfPoint(point);
  return vertex != NoIndex && field.isReached(vertex);
}

}

vtkSmartPointer<vtkDoubleArray> distanceArray(
  const TriangleMesh& mesh, const DistanceField& field, double unreached, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(mesh.numberOfPoints());
  double* values = array->GetPointer(0);
  for (Index i = 0; i < mesh.numberOfPoints(); ++i)
  {
    values[i] = isReached(mesh, field, i) ? field.distance(mesh.vertexOfPoint(i)) : unreached;
  }
  return array;
}

vtkSmartPointer<vtkIdTypeArray> nearestSeedArray(
  const TriangleMesh& mesh, const DistanceField& field, const char* name)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(mesh.numberOfPoints());
  vtkIdType* values = array->GetPointer(0);
  for (Index i = 0; i < mesh.numberOfPoints(); ++i)
  {
    values[i] = isReached(mesh, field, i)
      ? static_cast<vtkIdType>(field.nearestSeed(mesh.vertexOfPoint(i)))
      : -1;
  }
  return array;
}

vtkIdType numberOfReachedPoints(const TriangleMesh& mesh, const DistanceField& field)
{
  vtkIdType count = 0;
  for (Index i = 0; i < mesh.numberOfPoints(); ++i)
  {
    count += isReached(mesh, field, i) ? 1 : 0;
  }
  return count;
}

}
