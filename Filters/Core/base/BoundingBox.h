// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BoundingBox_h
#define geodesic_BoundingBox_h

#include "base/Vector3.h"

#include <algorithm>
#include <limits>

namespace geodesic
{

/**
 * The smallest axis-aligned box that holds all points added to it. Before the first one it is
 * empty: low is above high.
 */
struct BoundingBox
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low{ infinity, infinity, infinity };
  Vector3 high{ -infinity, -infinity, -infinity };

  /** Grows the box until it holds another box, given by its two corners. */
  void add(const Vector3& lowest, const Vector3& highest)
  {
    const auto [lx, ly, lz] = lowest;
    const auto [hx, hy, hz] = highest;
    this->low = { std::min(this->low.x, lx), std::min(this->low.y, ly), std::min(this->low.z, lz) };
    this->high = { std::max(this->high.x, hx), std::max(this->high.y, hy),
      std::max(this->high.z, hz) };
  }
  void add(const Vector3& point) { this->add(point, point); }

  /** Whether a point is inside or on a side. */
  bool contains(const Vector3& p) const
  {
    return p.x >= this->low.x && p.y >= this->low.y && p.z >= this->low.z && p.x <= this->high.x &&
      p.y <= this->high.y && p.z <= this->high.z;
  }

  /**
   * Returns the point of the box that is nearest to @p p.
   * @pre at least one point has been added
   */
  Vector3 nearestTo(const Vector3& p) const
  {
    return { std::clamp(p.x, this->low.x, this->high.x), std::clamp(p.y, this->low.y, this->high.y),
      std::clamp(p.z, this->low.z, this->high.z) };
  }
};

}

#endif
