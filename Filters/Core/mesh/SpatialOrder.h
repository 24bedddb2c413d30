// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SpatialOrder_h
#define geodesic_SpatialOrder_h

#include "base/BoundingBox.h"
#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"

#include <cstdint>
#include <span>

namespace geodesic
{

/** @throws std::invalid_argument always, with the point's number and position in the message */
[[noreturn]] void throwNotFinite(Index point, const Vector3& position);

/** @throws std::invalid_argument where the position of a point that triangles use is not finite */
inline void checkFinite(Index point, const Vector3& position)
{
  if (!isFinite(position)) [[unlikely]]
  {
    throwNotFinite(point, position);
  }
}

/** Checks that squares of lengths, and lengths in single precision, can hold a surface in a box.
 * @throws std::invalid_argument where the largest coordinate is below 1e-30 (but not 0) or above
 *         1e30 */
void checkMagnitude(const BoundingBox& box);

/**
 * Orders points along a Morton (Z) curve through their bounding cube, so that neighbours on the
 * surface are neighbours in memory.
 * @param points  coordinates
 * @param used    one flag for each point, 1 or 0; 0 leaves the point out
 * @param team    threads to work on; the order does not depend on their number
 * @return the ids of the used points in curve order. Points of equal coordinates stand together, by
 *         increasing id; otherwise the order depends on coordinates alone, not on ids.
 * @throws std::invalid_argument where the coordinates of a used point are not finite, or the
 *         largest one is below 1e-30 (but not 0) or above 1e30
 * Time O(n), memory 16 bytes a point while it runs.
 * G. M. Morton, A computer oriented geodetic data base, IBM (1966).
 */
BulkVector<Index> spatialOrder(
  std::span<const Vector3> points, std::span<const std::uint8_t> used, const ThreadTeam& team);

}

#endif
