// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceCurve_h
#define geodesic_SurfaceCurve_h

#include "path/PathPoint.h"

#include <span>
#include <string>

namespace geodesic
{

class DistanceSolver;

/**
 * The curve on the surface through some points. Between consecutive points it is the straight
 * segment if they share a face, else the shortest path.
 * @param solver a fast marching solver on the mesh; its field is overwritten
 * @param points at least one
 * @param name   what the points are, for the message
 * @throws std::invalid_argument if no path over the surface joins two consecutive points
 */
SurfacePath joinedCurve(
  DistanceSolver& solver, std::span<const SurfacePoint> points, const std::string& name);

/** Throws the exception of joinedCurve() for a curve without a path from point i - 1 to point @p i.
 */
[[noreturn]] void throwUnjoined(const std::string& name, std::size_t i);

}

#endif
