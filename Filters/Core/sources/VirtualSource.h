// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VirtualSource_h
#define geodesic_VirtualSource_h

#include "base/Index.h"
#include "sources/SideFrame.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

/** The shortest path from a virtual source to a point. */
struct PathFromSource
{
  double distance;
  /** The distance at its last bend, or at the source where it is straight. */
  double offset;
};

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
  /** The label (see SeedFront) from which that distance is measured. */
  Index label;

  /** Length of the straight line to a point. */
  double lineTo(double toX, double toY) const
  {
    const double alongX = toX - this->x;
    const double alongY = toY - this->y;
    return std::sqrt(alongX * alongX + alongY * alongY);
  }
  /** The distance at a point of the lit part. */
  double onSide(double at) const { return this->offset + this->lineTo(at, 0.0); }

  /** Where the straight line to a point, with toY >= 0, meets the side's line. */
  double crossing(double toX, double toY) const
  {
    const double fall = toY - this->y;
    return fall > 0.0 ? this->x - (toX - this->x) * this->y / fall
                      : std::clamp(this->x, this->first, this->last);
  }

  /** The path to a point with toY >= 0: a straight line, or one bent at an end of the lit part. */
  PathFromSource pathTo(double toX, double toY) const
  {
    const double meets = this->crossing(toX, toY);
    if (meets >= this->first && meets <= this->last)
    {
      return { this->offset + this->lineTo(toX, toY), this->offset };
    }
    const double bend = meets < this->first ? this->first : this->last;
    const double atBend = this->onSide(bend);
    return { atBend + std::sqrt((toX - bend) * (toX - bend) + toY * toY), atBend };
  }
  /** The same to the side's corners. */
  PathFromSource pathToFirst() const
  {
    const double atBend = this->onSide(this->first);
    return { atBend + this->first, this->first > 0.0 ? atBend : this->offset };
  }
  PathFromSource pathToSecond(double length) const
  {
    const double atBend = this->onSide(this->last);
    return { atBend + (length - this->last), this->last < length ? atBend : this->offset };
  }

  /** The least distance of the lit part. */
  double leastDistance() const
  {
    return this->onSide(std::clamp(this->x, this->first, this->last));
  }

  /** Moves the source to a corner of the side that it is at but for rounding. */
  void snap(double length, double tolerance)
  {
    if (-this->y > tolerance)
    {
      return;
    }
    for (const double corner : { 0.0, length })
    {
      if (std::abs(this->x - corner) <= tolerance)
      {
        this->x = corner;
        this->y = 0.0;
      }
    }
  }

  /**
   * Fits the source to the distances known at the side's corners, where these are nearly its own:
   * then the same front has come there past other vertices, so the lit part goes on to that corner.
   * The source is moved to where both distances hold.
   * @param atFirst, atSecond  distances at the corners; infinity where none is known for the label
   * @param most  the largest difference that counts as near, as a fraction of the side's length and
   *              of the source's distance to either corner
   */
  void fit(double length, double atFirst, double atSecond, double most)
  {
    const double ownFirst = this->lineTo(0.0, 0.0);
    const double ownSecond = this->lineTo(length, 0.0);
    const double tolerance = most * std::min({ length, ownFirst, ownSecond });
    const bool hasFirst = std::abs(atFirst - this->offset - ownFirst) <= tolerance;
    const bool hasSecond = std::abs(atSecond - this->offset - ownSecond) <= tolerance;
    const double a = hasFirst ? atFirst - this->offset : ownFirst;
    const double b = hasSecond ? atSecond - this->offset : ownSecond;
    // Without a point of these distances from both corners the source stays where it is.
    if (!(hasFirst || hasSecond) || !(std::abs(b - a) < length && a + b >= length))
    {
      return;
    }
    this->x = (length * length - (b - a) * (b + a)) / (2.0 * length);
    this->y = -std::sqrt(std::max(0.0, (a - this->x) * (a + this->x)));
    this->first = hasFirst ? 0.0 : this->first;
    this->last = hasSecond ? length : this->last;
  }
};

}

#endif
