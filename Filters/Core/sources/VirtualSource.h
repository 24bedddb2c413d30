// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VirtualSource_h
#define geodesic_VirtualSource_h

#include "base/Index.h"
#include "sources/SideFrame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace geodesic
{

/** The length of the straight line between two points that differ by (x, y). */
inline double lengthOf(double x, double y)
{
  return std::sqrt(x * x + y * y);
}

/**
 * A source as it is seen through a side of a triangle: unfolded into the triangle's plane, on the
 * other side of that side. Coordinates are those of the side's SideFrame. From the source straight
 * lines reach the *lit* part of the side. Elsewhere the shortest path is bent at the nearer end of
 * that part.
 */
struct VirtualSource
{
  /** The place of the source; y is at most 0. */
  double x;
  double y;
  /** The distance at the source itself. */
  double offset;
  /** The lit part of the side, from @p first to @p last. */
  double first;
  double last;
  /** The distance at the corner opposite to the side. */
  double toThird;
  /** The label (see SeedFront) from which that distance is measured. */
  Index label;

  /** The distance at a point of the lit part. */
  double onSide(double at) const { return this->offset + lengthOf(at - this->x, this->y); }

  /** The distances at the corners of the triangle behind the side: at the opposite corner, at the
   * side's first one and at its second one. */
  std::array<double, 3> distancesAt(const SideFrame& frame) const
  {
    return { this->toThird, this->onSide(this->first) + this->first,
      this->onSide(this->last) + (frame.length - this->last) };
  }

  /** Where the straight line to a point, with toY >= 0, meets the side's line. */
  double crossing(double toX, double toY) const
  {
    const double fall = toY - this->y;
    return fall > 0.0 ? this->x - (toX - this->x) * this->y / fall
                      : std::clamp(this->x, this->first, this->last);
  }

  /** Makes ends of the lit part that are corners of the side but for rounding these corners, and
   * the source itself, if it is at one. */
  void snap(double length, double rounding)
  {
    this->first = this->first < rounding ? 0.0 : this->first;
    this->last = this->last > length - rounding ? length : this->last;
    if (-this->y > rounding)
    {
      return;
    }
    for (const double corner : { 0.0, length })
    {
      if (std::abs(this->x - corner) <= rounding)
      {
        this->x = corner;
        this->y = 0.0;
      }
    }
  }

  /**
   * Fits the source to the distances known at the side's corners, where these are nearly its own:
   * then the same front has come there past other vertices, so the lit part goes on to that corner.
   * The source is moved to where both distances hold, if that is near.
   * @param ownFirst, ownSecond  lengths of the straight lines to the corners
   * @param atFirst, atSecond    the same after the distances at the corners; infinity where none is
   *                             known for the source
   * @param most                 the largest difference that counts as near, as a fraction of the
   *                             side's length and of the source's distance to either corner
   * @return whether it was moved, or its lit part went on
   */
  bool fit(
    double length, double ownFirst, double ownSecond, double atFirst, double atSecond, double most)
  {
    const double tolerance = most * std::min({ length, ownFirst, ownSecond });
    const bool hasFirst = std::abs(atFirst - ownFirst) <= tolerance;
    const bool hasSecond = std::abs(atSecond - ownSecond) <= tolerance;
    const double a = hasFirst ? atFirst : ownFirst;
    const double b = hasSecond ? atSecond : ownSecond;
    // Without a point of these distances from both corners the source stays where it is.
    if (!(hasFirst || hasSecond) || !(std::abs(b - a) < length && a + b >= length))
    {
      return false;
    }
    const double fittedX = (length * length - (b - a) * (b + a)) / (2.0 * length);
    const double fittedY = -std::sqrt(std::max(0.0, (a - fittedX) * (a + fittedX)));
    // Where lines to both corners are almost parallel, a small difference moves the source far: it
    // is another front, and was nearer to what lies behind the side by up to 4 % of the distance.
    constexpr double farthest = 2.0;
    if (lengthOf(fittedX - this->x, fittedY - this->y) > farthest * tolerance)
    {
      return false;
    }
    this->x = fittedX;
    this->y = fittedY;
    this->first = hasFirst ? 0.0 : this->first;
    this->last = hasSecond ? length : this->last;
    return true;
  }
};

/** A virtual source with VirtualSource::distancesAt() its side. */
struct SeenSource
{
  VirtualSource source;
  std::array<double, 3> distances;
};

}

#endif
