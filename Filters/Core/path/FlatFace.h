// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FlatFace_h
#define geodesic_FlatFace_h

#include "base/PlanePoint.h"
#include "base/Vector3.h"

#include <array>

namespace geodesic
{

/**
 * A face laid into the plane, its corners in counterclockwise order, the first one at the origin
 * and the second one on the x axis; and the way back. @pre the face has an area
 */
struct FlatFace
{
  std::array<PlanePoint, 3> corners;
  Vector3 origin;
  Vector3 right;
  Vector3 up;

  FlatFace(const Vector3& a, const Vector3& b, const Vector3& c)
    : origin(a)
  {
    const double length = norm(b - a);
    this->right = (1.0 / length) * (b - a);
    const double x = dot(c - a, this->right);
    const Vector3 height = (c - a) - x * this->right;
    const double y = norm(height);
    this->up = (1.0 / y) * height;
    this->corners = { PlanePoint{ 0.0, 0.0 }, PlanePoint{ length, 0.0 }, PlanePoint{ x, y } };
  }
  Vector3 inSpace(const PlanePoint& p) const
  {
    return this->origin + p.x * this->right + p.y * this->up;
  }
};

}

#endif
