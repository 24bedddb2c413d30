// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_FieldArray_h
#define geodesic_bridge_FieldArray_h

#include "mesh/TriangleMesh.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDoubleArray;
class vtkIdTypeArray;

namespace geodesic
{
class DistanceField;
class SplitMesh;
}

namespace geodesic::bridge
{

/** A field of distances and the input's mesh, or that and the split copy which has the field. */
struct FieldOnInput
{
  const TriangleMesh& mesh;
  const DistanceField& field;
  const SplitMesh* split = nullptr;
  /** The points that are asked for: all, or those of one block. */
  Index firstPoint = 0;
  Index numberOfPoints = mesh.numberOfPoints();
};

/** The distances at the input's points, @p unreached where there is none; one component. */
vtkSmartPointer<vtkDoubleArray> distanceArray(
  const FieldOnInput& input, double unreached, const char* name);

/** The numbers of the nearest seeds at the input's points, -1 where there is none. */
vtkSmartPointer<vtkIdTypeArray> nearestSeedArray(const FieldOnInput& input, const char* name);

/** How many of the points have a distance. */
vtkIdType numberOfReachedPoints(const FieldOnInput& input);

}

#endif
