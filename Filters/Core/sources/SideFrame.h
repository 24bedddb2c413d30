// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SideFrame_h
#define geodesic_SideFrame_h

#include "base/Vector3.h"

namespace geodesic
{

/** A triangle laid in the plane: a side on the x axis, its first corner in the origin, its second
 * one at (length, 0), and the third corner above, at (x, height). */
struct SideFrame
{
  /** @param first, second, third  positions of the corners; of a side without length only the
   * length has a meaning */
  SideFrame(const Vector3& first, const Vector3& second, const Vector3& third)
  {
    const Vector3 side = second - first;
    const Vector3 rest = third - first;
    this->length = norm(side);
    this->x = dot(side, rest) / this->length;
    this->height = norm(cross(side, rest)) / this->length;
  }

  double length;
  double x;
  double height;
};

}

#endif
