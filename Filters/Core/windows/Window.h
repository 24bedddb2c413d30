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
 * The source is a point or, of a straight front, a line from which parallel lines come at a right
 * angle: a point infinitely far away.
 * J. Mitchell, D. Mount, C. Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16
 * (1987).
 */
struct Window
{
  /** The part of the edge, from @p first to @p last. */
  double first;
  double last;
  /** Where the source lies. Of a straight front the direction in which it goes, of length 1: along
   * the edge, and down through it. */
  double x;
  double y;
  /** The distance at the source. Of a straight front that at the edge's lower vertex, below 0 where
   * its lines do not come there. */
  double offset;
  /** The number of the seed from which that distance is measured; below 2^31. */
  Index seed : 31;
  bool isStraight : 1 = false;
  /** By how much the shortest path to any of its points may be longer than the window says; 0
   * unless windows were merged (see WindowMerging). */
  float excess = 0.0F;

  /** The distance at a point of the edge less the offset: the length of the straight line to it. */
  double lineTo(double at) const
  {
    if (this->isStraight)
    {
      return this->x * at;
    }
    const double along = at - this->x;
    return std::sqrt(along * along + this->y * this->y);
  }
  double distanceAt(double at) const { return this->offset + this->lineTo(at); }
  /** The least distance of any of the window's points. */
  double leastDistance() const
  {
    return this->distanceAt(this->isStraight ? (this->x > 0.0 ? this->first : this->last)
                                             : std::clamp(this->x, this->first, this->last));
  }
  /** The place on the edge's line where the line from the source to a point below it passes.
   * @param depth  of the point below the edge; at least 0, as is its sum with y */
  double placeTowards(double px, double depth) const
  {
    if (this->isStraight)
    {
      return depth > 0.0 ? px - this->x * (depth / this->y) : px;
    }
    const double height = this->y + depth;
    return height > 0.0 ? this->x + (px - this->x) * (this->y / height) : this->x;
  }
  /** Measures all from the other end of the edge. */
  void turn(double length)
  {
    const double from = length - this->last;
    this->last = length - this->first;
    this->first = from;
    this->offset = this->isStraight ? this->offset + this->x * length : this->offset;
    this->x = this->isStraight ? -this->x : length - this->x;
  }
};
static_assert(sizeof(Window) == 48);

/** The place on the edge's line where the lines of two windows have one direction: between it and
 * either end, the difference of their distances grows or falls throughout. Not finite if there is
 * none. */
inline double turningPoint(const Window& a, const Window& b)
{
  if (a.isStraight != b.isStraight)
  {
    const Window& straight = a.isStraight ? a : b;
    const Window& round = a.isStraight ? b : a;
    return round.x + round.y * (straight.x / straight.y);
  }
  return a.isStraight ? std::numeric_limits<double>::infinity()
                      : (a.x * b.y - b.x * a.y) / (b.y - a.y);
}

/** An excess in single precision, no less than it was. */
inline float excessOf(double excess)
{
  const float single = static_cast<float>(excess);
  return single < excess ? std::nextafter(single, std::numeric_limits<float>::infinity()) : single;
}

}

#endif
