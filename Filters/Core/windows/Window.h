// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Window_h
#define geodesic_Window_h

#include "base/Index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesic
{

/**
 * A part of an edge and the source whose straight lines reach it through the same faces. The faces
 * are laid in the plane of the edge, with the edge on the x axis from its lower vertex on, and the
 * source at a height y >= 0 over the axis. All half-edges of the edge see the same numbers.
 * J. Mitchell, D. Mount, C. Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16
 * (1987).
 */
struct Window
{
  /** The part of the edge, from @p first to @p last. */
  double first;
  double last;
  /** Where the source lies. */
  double x;
  double y;
  /** The distance at the source. */
  double offset;
  /** The number of the seed from which that distance is measured. */
  Index seed;
  /** By how much the shortest path to any of its points may be longer than the window says; 0
   * unless windows were merged (see WindowMerging). */
  float excess = 0.0F;

  /** Length of the straight line from the source to a point of the edge. */
  double lineTo(double at) const
  {
    const double along = at - this->x;
    return std::sqrt(along * along + this->y * this->y);
  }
  double distanceAt(double at) const { return this->offset + this->lineTo(at); }
  /** The least distance of any of the window's points. */
  double leastDistance() const
  {
    return this->distanceAt(std::clamp(this->x, this->first, this->last));
  }
};

/** An excess in single precision, no less than it was. */
inline float excessOf(double excess)
{
  const float single = static_cast<float>(excess);
  return single < excess ? std::nextafter(single, std::numeric_limits<float>::infinity()) : single;
}

}

#endif
