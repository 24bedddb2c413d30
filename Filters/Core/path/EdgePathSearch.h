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
 * A path across faces is usually shorter than any path along edges. On rough surfaces fast marching
 * may be wrong about it, so the search makes sure. The field is a lower bound of the length that is
 * left, because fast marching's update includes paths along edges (see EikonalUpdate.h). So the
 * search, an A*, visits only vertices that a shorter path can pass: few, since edges rarely run
 * along the shortest path.
 * @param weighted  mesh and barriers; costs have no effect
 * @param field     fast marching distances from @p from, final up to its largest distance
 * @param from, to  ends of the path
 * @param length    to be shorter than, in mesh length units
 * @return the path from @p from to @p to; nothing if none is shorter
 * @throws SearchCancelled
 */
std::optional<SurfacePath> shorterEdgePath(const WeightedMesh& weighted, const DistanceField& field,
  const PathPoint& from, const PathPoint& to, double length);

}

#endif
