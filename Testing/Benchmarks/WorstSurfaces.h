// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_WorstSurfaces_h
#define geodesic_testing_WorstSurfaces_h

#include "Surfaces.h"

#include <string>

namespace geodesic::testing
{

/** A surface, and two of its points that lie far apart. */
struct WorstSurface
{
  Surface surface;
  Index from = 0;
  Index to = 0;
};

/**
 * A surface of the worst cases by its name; throws std::invalid_argument where there is none.
 * @param tiny of some hundred points only, to try whether the cases run
 */
WorstSurface worstSurface(const std::string& name, bool tiny);

/** The hilly square of about as many points: what a surface without difficulties takes. */
Surface ordinarySurface(std::size_t points);
/** Triangles that share no points. */
Surface trianglesApart(Index triangles);
/** The surface with one coordinate of its points divided by @p factor. */
Surface flattened(Surface surface, double Vector3::*axis, double factor);

}

#endif
