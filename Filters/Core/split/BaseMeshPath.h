// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BaseMeshPath_h
#define geodesic_BaseMeshPath_h

#include "path/PathPoint.h"

#include <functional>

namespace geodesic
{

/** Where a vertex of a mesh is on the base mesh that it was split from. */
using OriginOf = std::function<PathPoint(Index vertex)>;

/** A point of the split mesh, on the base mesh. */
PathPoint basePoint(const PathPoint& point, const OriginOf& originOf);

/**
 * A path of the split mesh on the base mesh, without the points inside faces that it runs straight
 * through.
 */
SurfacePath basePath(const TriangleMesh& split, const SurfacePath& path, const OriginOf& originOf);

}

#endif
