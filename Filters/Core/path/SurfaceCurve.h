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
 * The curve on the surface through some points: where consecutive ones share a face the straight
 * segment, else the shortest path.
 * @param solver a fast marching solver on the mesh; its field is overwritten
 * @param name   what the points are, for the message
 * @throws std::invalid_argument where no way over the surface joins two consecutive points
 */
SurfacePath joinedCurve(
  DistanceSolver& solver, std::span<const SurfacePoint> points, const std::string& name);

/** Throws what joinedCurve does where no way leads to point @p i of a curve. */
[[noreturn]] void throwUnjoined(const std::string& name, std::size_t i);

}

#endif
