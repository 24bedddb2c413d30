// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SeedResolver_h
#define geodesic_bridge_SeedResolver_h

#include "InputSurface.h"
#include "PointResolver.h"
#include "Seed.h"

#include <span>
#include <vector>

class vtkDataArray;
class vtkIdList;
class vtkPointSet;

namespace geodesic::bridge
{

/** One seed at each position; throws as surfacePointsAt. */
std::vector<Seed> seedsAtPositions(
  const InputSurface& surface, std::span<const double> coordinates);

/** One seed at each point; throws as verticesAtPoints. */
std::vector<Seed> seedsAtPoints(const TriangleMesh& mesh, vtkIdList* ids);

/**
 * The points of a data set that no line uses, one seed each, then its lines and polylines, one
 * seed each, a curve; all projected to the nearest point of the surface.
 */
std::vector<Seed> seedsOfSource(const InputSurface& surface, vtkPointSet* source);

/**
 * One seed for each value of the array but 0, by increasing value: all points, or all of all cells,
 * that have it. NaN is 0.
 * @param isOfCells whether the array belongs to the input's cells
 * @throws std::invalid_argument where every value is 0, or the array has several components
 */
std::vector<Seed> seedsOfArray(const InputSurface& surface, vtkDataArray* array, bool isOfCells);

/**
 * One seed of all these points, or of all these cells; none where the list is empty.
 * @throws std::invalid_argument where none of them belongs to the surface
 */
std::vector<Seed> seedOfIds(const InputSurface& surface, vtkDataArray* ids, bool areCells);

/** The points of those seeds that are curves. */
std::vector<std::vector<SurfacePoint>> linesAmong(std::span<const Seed> seeds);

}

#endif
