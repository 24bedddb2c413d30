// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/FieldArray.h"

#include "solve/DistanceField.h"
#include "split/SplitMesh.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

namespace geodesic::bridge
{
namespace
{

/**
 * Calls @p visit with each of the input's points and its vertex in the field, or NoIndex if the
 * field does not reach the point, and the sign there.
 */
template <class Visit>
void visitPoints(const FieldOnInput& input, Visit&& visit)
{
  for (Index point = 0; point < input.numberOfPoints; ++point)
  {
    Index vertex = input.mesh.vertexOfPoint(input.firstPoint + point);
    const double sign = input.signs.empty() || vertex == NoIndex ? 1.0 : input.signs[vertex];
    if (input.split && vertex != NoIndex)
    {
      vertex = input.split->vertexOf(vertex);
    }
    visit(point, vertex != NoIndex && input.field.isReached(vertex) ? vertex : NoIndex, sign);
  }
}

}

vtkSmartPointer<vtkDoubleArray> distanceArray(
  const FieldOnInput& input, double unreached, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(input.numberOfPoints);
  double* values = array->GetPointer(0);
  visitPoints(input,
    [&](Index point, Index vertex, double sign)
    { values[point] = vertex == NoIndex ? unreached : sign * input.field.distance(vertex); });
  return array;
}

vtkSmartPointer<vtkIdTypeArray> nearestSeedArray(const FieldOnInput& input, const char* name)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(input.numberOfPoints);
  vtkIdType* values = array->GetPointer(0);
  visitPoints(input,
    [&](Index point, Index vertex, double)
    {
      values[point] =
        vertex == NoIndex ? -1 : static_cast<vtkIdType>(input.field.nearestSeed(vertex));
    });
  return array;
}

vtkIdType numberOfReachedPoints(const FieldOnInput& input)
{
  vtkIdType count = 0;
  visitPoints(input, [&](Index, Index vertex, double) { count += vertex == NoIndex ? 0 : 1; });
  return count;
}

}
