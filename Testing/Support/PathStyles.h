// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_PathStyles_h
#define geodesic_testing_PathStyles_h

#include "path/PathFinder.h"

namespace geodesic::testing
{

inline constexpr PathStyle Straight{ PathOrder::Edges, true };
inline constexpr PathStyle Traced{ PathOrder::Edges, false };
inline constexpr PathStyle AlongEdges{ PathOrder::Vertices, false };

}

#endif
