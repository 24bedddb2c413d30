// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_FieldArray_h
#define geodesic_bridge_FieldArray_h

#include "mesh/TriangleMesh.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <span>

class vtkDoubleArray;
class vtkIdTypeArray;

namespace geodesic
{
class DistanceField;
class SplitMesh;
}

namespace geodesic::bridge
{

/** A distance field, and the input's mesh on which the field is shown. */
struct FieldOnInput
{
  const TriangleMesh& mesh;
  const DistanceField& field;
  /** The split copy of the mesh that has the field; null if the mesh itself has it. */
  const SplitMesh* split = nullptr;
  /** The points to show: all of them, or those of one block. */
  Index firstPoint = 0;
  Index numberOfPoints = mesh.numberOfPoints();
  /** A sign for each vertex of the mesh, with which distances are multiplied; empty for none. */
  std::span<const std::int8_t> signs{};
};

/**
 * Returns an array of one component: the distance at each of the points, or @p unreached at points
 * without a distance.
 */
vtkSmartPointer<vtkDoubleArray> distanceArray(
  const FieldOnInput& input, double unreached, const char* name);

/**
 * Returns an array of one component: the number of the nearest seed at each of the points, or -1 at
 * points without a distance.
 */
vtkSmartPointer<vtkIdTypeArray> nearestSeedArray(const FieldOnInput& input, const char* name);

/** Returns the number of points that have a distance. */
vtkIdType numberOfReachedPoints(const FieldOnInput& input);

}

#endif
