// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathMeeting_h
#define geodesic_PathMeeting_h

#include "path/PathPoint.h"

#include <cstddef>
#include <vector>

namespace geodesic
{

/**
 * Whether a surface bends so little from face to face along a path that paths beside it become the
 * same one when they are straightened. They may be others where it is curved: on a rough surface
 * the best of several is up to 0.4 % shorter.
 */
bool isSmoothAlong(const TriangleMesh& mesh, const SurfacePath& path);

/** Tells where other paths come into the faces of a path. */
class PathMeeting
{
public:
  /** @param path none meets an empty one. Time O(number of its points) */
  explicit PathMeeting(SurfacePath path);

  const SurfacePath& path() const { return this->Path; }

  /**
   * @return the place of the point of the path that lies on the same edge as the last point of
   * another one, if the two have come through some faces together; else 0. Paths of two fronts
   * that meet at one edge part again within a few faces
   */
  std::size_t placeOfMeeting(const SurfacePath& other) const;

private:
  std::size_t slotOf(const PathPoint& point) const;

  SurfacePath Path;
  /** Places by edge; 0 in empty slots, as the first point of a path is no meeting. */
  std::vector<std::size_t> Slots;
};

}

#endif
