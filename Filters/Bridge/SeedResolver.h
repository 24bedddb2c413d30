// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SeedResolver_h
#define geodesic_bridge_SeedResolver_h

#include "InputSurface.h"
#include "PointResolver.h"
#include "Seed.h"

#include <map>
#include <span>
#include <vector>

class vtkDataArray;
class vtkIdList;

namespace geodesic::bridge
{

/** One seed at each point; throws as verticesAtPoints. */
std::vector<Seed> seedsAtPoints(const TriangleMesh& mesh, vtkIdList* ids);

/** The vertices of the points or cells that have a value. */
using RegionsByValue = std::map<double, std::vector<Index>>;

/**
 * The regions of each value of the array but 0. NaN is 0.
 * @param isOfCells whether the array belongs to the input's cells
 * @throws std::invalid_argument where the array has several components
 */
RegionsByValue regionsOfArray(const InputSurface& surface, vtkDataArray* array, bool isOfCells);

/**
 * The one region of all these points, or of all these cells; none where the list is empty.
 * @throws std::invalid_argument where none of them belongs to the surface
 */
RegionsByValue regionOfIds(const InputSurface& surface, vtkDataArray* ids, bool areCells);

/** The points of those seeds that are curves. */
std::vector<std::vector<SurfacePoint>> linesAmong(std::span<const Seed> seeds);

}

#endif
