// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SeedResolver_h
#define geodesic_bridge_SeedResolver_h

#include "InputSurface.h"
#include "Seed.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkIdList;

namespace geodesic::bridge
{

/**
 * One seed at each position, projected to the nearest point of the surface.
 * @param coordinates x y z of one after the other
 * @throws std::invalid_argument where the length is no multiple of 3 or a coordinate is not finite
 */
std::vector<Seed> seedsAtPositions(
  const InputSurface& surface, std::span<const double> coordinates);

/**
 * The vertices that stand for points of the input.
 * @param ids   may be null: none
 * @param role  what the points are, for the message
 * @throws std::invalid_argument for an id that does not exist, or whose point no cell uses
 */
std::vector<Index> verticesAtPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role);

/** One seed at each point; throws as verticesAtPoints. */
std::vector<Seed> seedsAtPoints(const TriangleMesh& mesh, vtkIdList* ids);

/**
 * One flag a vertex, set for the points in the list; empty where the list is null or empty. Points
 * that no cell uses are excluded anyway.
 * @throws std::invalid_argument for an id that does not exist
 */
std::vector<std::uint8_t> maskOfPoints(
  const TriangleMesh& mesh, vtkIdList* ids, const std::string& role);

}

#endif
