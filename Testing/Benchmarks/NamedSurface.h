// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_NamedSurface_h
#define geodesic_testing_NamedSurface_h

#include "Surfaces.h"

#include <string>

namespace geodesic::testing
{

/**
 * A surface by its name: sphere:LEVELS, torus:POINTS_ACROSS, terrain:CELLS_ALONG_A_SIDE or
 * bunny:SUBDIVISIONS.
 * @throws std::invalid_argument for another name
 */
Surface namedSurface(const std::string& name);

}

#endif
