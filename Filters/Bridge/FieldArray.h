// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_FieldArray_h
#define geodesic_bridge_FieldArray_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDoubleArray;
class vtkIdTypeArray;

namespace geodesic
{
class DistanceField;
class TriangleMesh;
}

namespace geodesic::bridge
{

/** The distances at the input's points, @p unreached where there is none; one component. */
vtkSmartPointer<vtkDoubleArray> distanceArray(
  const TriangleMesh& mesh, const DistanceField& field, double unreached, const char* name);

/** The numbers of the nearest seeds at the input's points, -1 where there is none. */
vtkSmartPointer<vtkIdTypeArray> nearestSeedArray(
  const TriangleMesh& mesh, const DistanceField& field, const char* name);

/** How many of the input's points have a distance. */
vtkIdType numberOfReachedPoints(const TriangleMesh& mesh, const DistanceField& field);

}

#endif
