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

/** One seed at each vertex. */
std::vector<Seed> seedsAtVertices(const TriangleMesh& mesh, std::span<const Index> vertices);

/** The vertices of the points or cells that have a value. */
using RegionsByValue = std::map<double, std::vector<Index>>;

/** The regions of each value of the array but 0. NaN is 0. */
RegionsByValue regionsOfArray(const InputSurface& surface, const ChosenArray& array);

/** The region of all selected points, by 0, and that of all selected cells, by 1. */
RegionsByValue regionsOfSelection(const InputSurface& surface, const SelectedElements& selected);

}

#endif
