// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_AngleSum_h
#define geodesic_AngleSum_h

#include "base/Vector3.h"

#include <cmath>
#include <numbers>

namespace geodesic
{

/** An angle counts as 180 degrees if it differs by less than this, in radians. What a path could
 * gain is proportional to the square of the difference. */
constexpr double RoundingOfAngles = 1e-7;

/** The sum of angles between vectors, as long as it is at most 180 degrees. It is held as a
 * direction in the plane, which each angle turns: that takes no inverse tangent. */
class AngleSum
{
public:
  /** Adds the angle between two vectors; 0 if one of them has no length. @return whether the sum
   * is at most 180 degrees, by RoundingOfAngles; if not, nothing may be added any more */
  bool add(const Vector3& a, const Vector3& b)
  {
    const double along = dot(a, b);
    const double across = norm(cross(a, b));
    const double size = std::abs(along) + across;
    if (!(size > 0.0))
    {
      return true;
    }
    const bool areObtuse = this->X < 0.0 && along < 0.0;
    const double x = (this->X * along - this->Y * across) / size;
    this->Y = (this->X * across + this->Y * along) / size;
    this->X = x;
    // Two obtuse angles, and what lies in the lower half of the plane, make more than 180 degrees.
    return (!areObtuse && this->Y >= 0.0) ||
      (this->X < 0.0 && std::abs(this->Y) < RoundingOfAngles * -this->X);
  }

  /** In radians. @pre it is at most 180 degrees */
  double value() const
  {
    const double angle = std::atan2(this->Y, this->X);
    return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
  }

private:
  double X = 1.0;
  double Y = 0.0;
};

}

#endif
