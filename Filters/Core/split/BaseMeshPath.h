// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BaseMeshPath_h
#define geodesic_BaseMeshPath_h

#include "path/PathPoint.h"

#include <functional>

namespace geodesic
{

/** Gives the place of a split mesh's vertex on the base mesh. */
using OriginOf = std::function<PathPoint(Index vertex)>;

/** The place of a split mesh's point on the base mesh. */
PathPoint basePoint(const PathPoint& point, const OriginOf& originOf);

/**
 * A path of the split mesh as a path on the base mesh.
 * @param split  the split mesh
 * @return the path without its points inside faces of the base mesh at which it does not bend
 */
SurfacePath basePath(const TriangleMesh& split, const SurfacePath& path, const OriginOf& originOf);

}

#endif
