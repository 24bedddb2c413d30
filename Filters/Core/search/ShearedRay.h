// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ShearedRay_h
#define geodesic_ShearedRay_h

#include "base/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace geodesic
{

/**
 * A ray, tested against triangles and boxes. Triangles are moved and sheared to coordinates in
 * which the ray runs from 0 along the axis in which its direction is longest. S. Woop, C. Benthin,
 * I. Wald, Watertight Ray/Triangle Intersection, JCGT 2 (2013).
 */
class ShearedRay
{
public:
  ShearedRay(const Vector3& origin, const Vector3& direction)
    : Origin(origin)
  {
    const std::array<double, 3> d = componentsOf(direction);
    this->Along = static_cast<int>(std::max_element(d.begin(), d.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      d.begin());
    this->ShearX = d[(this->Along + 1) % 3] / d[this->Along];
    this->ShearY = d[(this->Along + 2) % 3] / d[this->Along];
    this->Scale = 1.0 / d[this->Along];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Inverse[axis] = 1.0 / d[axis];
    }
  }

  /** Where the ray crosses a triangle's plane within the triangle. */
  struct Crossing
  {
    std::array<double, 3> weights;
    /** Distance from the origin, in lengths of the direction; negative behind the origin. */
    double along;
  };

  /** Where the line of the ray crosses a triangle; nothing where it misses or is parallel to it. */
  std::optional<Crossing> crossing(const std::array<Vector3, 3>& corners) const
  {
    const Vector3 a = this->sheared(corners[0]);
    const Vector3 b = this->sheared(corners[1]);
    const Vector3 c = this->sheared(corners[2]);
    // For the two triangles of an edge, the numbers of that edge are exactly opposite, so that the
    // ray cannot miss both.
    const double u = c.x * b.y - c.y * b.x;
    const double v = a.x * c.y - a.y * c.x;
    const double w = b.x * a.y - b.y * a.x;
    const double sum = u + v + w;
    const bool isBeside = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
    if (isBeside || sum == 0.0)
    {
      return {};
    }
    const std::array<double, 3> weights{ u / sum, v / sum, w / sum };
    return Crossing{ weights, weights[0] * a.z + weights[1] * b.z + weights[2] * c.z };
  }

  /** Where the ray enters a box, in lengths of the direction: 0 from inside, infinity where it
   * misses. */
  double entry(const std::array<double, 3>& low, const std::array<double, 3>& high) const
  {
    // A factor above all rounding errors of this function, so that no box that is touched is
    // missed.
    constexpr double wider = 1.0 + 1e-15;
    const std::array<double, 3> origin = componentsOf(this->Origin);
    double first = 0.0;
    double last = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::isinf(this->Inverse[axis]))
      {
        if (origin[axis] < low[axis] || origin[axis] > high[axis])
        {
          return std::numeric_limits<double>::infinity();
        }
        continue;
      }
      const double a = (low[axis] - origin[axis]) * this->Inverse[axis];
      const double b = (high[axis] - origin[axis]) * this->Inverse[axis];
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b) * wider);
    }
    return first <= last ? first : std::numeric_limits<double>::infinity();
  }

private:
  static std::array<double, 3> componentsOf(const Vector3& a) { return { a.x, a.y, a.z }; }

  Vector3 sheared(const Vector3& point) const
  {
    const std::array<double, 3> p = componentsOf(point - this->Origin);
    return { p[(this->Along + 1) % 3] - this->ShearX * p[this->Along],
      p[(this->Along + 2) % 3] - this->ShearY * p[this->Along], this->Scale * p[this->Along] };
  }

  Vector3 Origin;
  std::array<double, 3> Inverse;
  int Along;
  double ShearX;
  double ShearY;
  double Scale;
};

}

#endif
