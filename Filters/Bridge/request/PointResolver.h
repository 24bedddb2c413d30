// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PointResolver_h
#define geodesic_bridge_PointResolver_h

#include "input/InputSurface.h"
#include "mesh/SurfacePoint.h"
#include "request/PointSource.h"

#include "vtkType.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkIdList;

namespace geodesic::bridge
{

/**
 * Makes positions from a list of coordinates, x y z of each position in turn.
 * @param property name of the list in the error message
 * @throws std::invalid_argument if the length is not a multiple of 3, or a coordinate is not finite
 */
std::vector<Vector3> positionsAt(std::span<const double> coordinates, const std::string& property);

/**
 * Moves a point onto an edge or a vertex that is so near that single precision can't tell them
 * apart. Most data sets have coordinates in single precision, and a line along edges should stay on
 * the edges.
 */
SurfacePoint snappedAsSingle(const TriangleMesh& mesh, const SurfacePoint& point);

/**
 * Returns the vertex of a point of the input.
 * @param role  name of the point in the error message
 * @throws std::invalid_argument if the id does not exist, or no cell uses the point
 */
Index vertexAtPoint(const TriangleMesh& mesh, vtkIdType id, const std::string& role);

/**
 * Returns the vertices of several points; @p ids may be null, which means none.
 * @throws as vertexAtPoint()
 */
std::vector<Index> verticesAtPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role);

/**
 * Returns the vertices of points that the user gives by their ids (see BlockNumbering).
 * @throws as vertexAtPoint(), and if the ids are not unique
 */
std::vector<Index> verticesWithIds(
  const InputSurface& surface, vtkIdList* ids, const std::string& role);

/** Returns the target of a march (see SolveOptions::targets) for a point, or for a vertex. */
Triangle targetAt(const TriangleMesh& mesh, const SurfacePoint& point);
Triangle targetAt(Index vertex);

}

#endif
