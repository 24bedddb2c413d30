// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ChordWalk_h
#define geodesic_ChordWalk_h

#include "base/PlanePoint.h"
#include "path/PathPoint.h"
#include "path/Strip.h"
#include "path/WeightedMesh.h"

#include <optional>
#include <span>

namespace geodesic
{

/** A strip of faces with the straight line between two points of its first and its last face. */
struct StripChord
{
  /** Two faces at least. */
  std::span<const StripFace> faces;
  /** In the plane of the strip. */
  PlanePoint from;
  PlanePoint to;
  PathPoint end;
};

/**
 * The faces that a straight line crosses which begins as the chord of a strip, and goes on beside
 * the strip where the chord leaves it. Where it comes back into a face of the strip, it turns a
 * little, towards the end as seen from there: the surface beside the strip may be curved.
 * @return a strip between the same points, with the first face of the old one; nothing if the line
 *         leaves the surface or the first face, or does not lead to the end
 * @throws SearchCancelled, IncompleteRing
 * Time O(number of faces).
 */
std::optional<Strip> stripAlongChord(const WeightedMesh& surface, const StripChord& chord);

}

#endif
