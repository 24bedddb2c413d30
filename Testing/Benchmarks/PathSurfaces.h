// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_PathSurfaces_h
#define geodesic_testing_PathSurfaces_h

#include "Subject.h"

#include <string>
#include <vector>

namespace geodesic::testing
{

/** Curved surfaces: true distances are the exact ones on the polyhedron, by CGAL. */
std::vector<std::string> curvedSurfaces();

/** Surfaces that unroll to the plane, where true distances are straight lines. */
std::vector<std::string> flatSurfaces();

/** Surfaces of a million points, without truth. */
std::vector<std::string> largeSurfaces();

/**
 * A surface of the path benchmarks, built when first asked for.
 * @param name of one of the lists above
 */
Subject& pathSubject(const std::string& name);

}

#endif
