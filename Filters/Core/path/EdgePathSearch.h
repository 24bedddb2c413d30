// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgePathSearch_h
#define geodesic_EdgePathSearch_h

#include "path/PathPoint.h"
#include "path/WeightedMesh.h"
#include "solve/DistanceField.h"

#include <optional>

namespace geodesic
{

/**
 * The shortest path along edges from one point to another, if it is shorter than @p length.
 *
 * A path across faces is shorter than any along edges but for rough surfaces, where fast marching
 * may be misled; this is how one can be sure. The field bounds what is left from below, because
 * the update of fast marching allows the ways along edges, so the search (A*) looks only at
 * vertices that a shorter path can pass: few, since edges rarely run along the shortest way.
 * @param field fast marching distances from @p from, final up to its largest distance
 */
std::optional<SurfacePath> shorterEdgePath(const WeightedMesh& weighted, const DistanceField& field,
  const PathPoint& from, const PathPoint& to, double length);

}

#endif
