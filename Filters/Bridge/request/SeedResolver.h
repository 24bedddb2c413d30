// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_SeedResolver_h
#define geodesic_bridge_SeedResolver_h

#include "input/ArrayValues.h"
#include "input/InputSurface.h"
#include "request/PointResolver.h"
#include "request/SelectedElements.h"
#include "solve/Seed.h"

#include <map>
#include <span>
#include <vector>

namespace geodesic::bridge
{

/** Makes one seed at each vertex. */
std::vector<Seed> seedsAtVertices(const TriangleMesh& mesh, std::span<const Index> vertices);

/** For each value, the vertices of the points or cells that have it. */
using RegionsByValue = std::map<double, std::vector<Index>>;

/** Makes a region for each value of the array except 0 and NaN. */
RegionsByValue regionsOfArray(const InputSurface& surface, const ChosenArray& array);

/**
 * Makes a region of all selected points, under the value 0, and one of all selected cells, under
 * the value 1.
 */
RegionsByValue regionsOfSelection(const InputSurface& surface, const SelectedElements& selected);

}

#endif
