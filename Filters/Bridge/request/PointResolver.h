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
 * Positions from their coordinates, x y z of one after the other.
 * @param property what gave them, for the message
 * @throws std::invalid_argument where the length is no multiple of 3 or a coordinate is not finite
 */
std::vector<Vector3> positionsAt(std::span<const double> coordinates, const std::string& property);

/**
 * The point on the edge or vertex that it is as near to as single precision can tell: most data
 * sets have such coordinates, and a line along edges should be one.
 */
SurfacePoint snappedAsSingle(const TriangleMesh& mesh, const SurfacePoint& point);

/**
 * The vertex that stands for a point of the input.
 * @param role  what the point is, for the message
 * @throws std::invalid_argument for an id that does not exist, or whose point no cell uses
 */
Index vertexAtPoint(const TriangleMesh& mesh, vtkIdType id, const std::string& role);

/** The same for several points; @p ids may be null: none. */
std::vector<Index> verticesAtPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role);

/**
 * The vertices of points that the user names by their ids (see BlockNumbering).
 * @throws as vertexAtPoint, and where the ids do not tell points apart
 */
std::vector<Index> verticesWithIds(
  const InputSurface& surface, vtkIdList* ids, const std::string& role);

/** A target of the front (see SolveOptions::targets): the corners round a point, or a vertex. */
Triangle targetAt(const TriangleMesh& mesh, const SurfacePoint& point);
Triangle targetAt(Index vertex);

}

#endif
