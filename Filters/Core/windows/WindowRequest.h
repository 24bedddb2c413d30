// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowRequest_h
#define geodesic_WindowRequest_h

#include "solve/Seed.h"
#include "solve/SeedFront.h"

#include <span>

namespace geodesic
{

class Partition;
class StopLimit;
class TriangleMesh;
class WindowFront;

/**
 * Checks that a front of windows can serve a request.
 * @param distances  what is asked for, to begin a message: "Exact distances"
 * @throws std::invalid_argument for a cost, or on a surface in several pieces
 */
void checkWindowRequest(const char* distances, bool hasCost, const Partition& partition);

/** The least key of any seed in a front's queue: its value, and the part of what is left from there
 * to the goal. */
double leastKeyOf(std::span<const Label> labels, const StopLimit& limit);

/** Starts a front at its seeds and marches to the end. @return false when cancelled */
bool marchFrom(std::span<const Seed> seeds, const TriangleMesh& mesh, WindowFront& front);

}

#endif
