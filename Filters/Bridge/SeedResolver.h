// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SeedResolver_h
#define geodesic_bridge_SeedResolver_h

#include "ArrayValues.h"
#include "InputSurface.h"
#include "PointResolver.h"
#include "Seed.h"
#include "SelectedElements.h"

#include <span>
#include <vector>

namespace geodesic::bridge
{

/** One seed at each position; throws as surfacePointsAt. */
std::vector<Seed> seedsAtPositions(
  const InputSurface& surface, std::span<const double> coordinates);

/** One seed at each vertex. */
std::vector<Seed> seedsAtVertices(const TriangleMesh& mesh, std::span<const Index> vertices);

/**
 * The points of a source that no line uses, one seed each, then its lines and polylines, one seed
 * each, a curve; all projected to the nearest point of the surface.
 */
std::vector<Seed> seedsOfSource(const InputSurface& surface, const PointSource& source);

/**
 * One seed for each value of the array but 0, by increasing value: all points, or all of all cells,
 * that have it. NaN is 0.
 * @throws std::invalid_argument where every value is 0
 */
std::vector<Seed> seedsOfArray(const InputSurface& surface, const ChosenArray& array);

/**
 * One seed of all selected points, and one of all selected cells; none where the selection is
 * empty.
 * @throws std::invalid_argument where nothing that is selected belongs to the surface
 */
std::vector<Seed> seedsOfSelection(const InputSurface& surface, const SelectedElements& selected);

/** The points of those seeds that are curves. */
std::vector<std::vector<SurfacePoint>> linesAmong(std::span<const Seed> seeds);

}

#endif
