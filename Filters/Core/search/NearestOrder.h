// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestOrder_h
#define geodesic_NearestOrder_h

#include "base/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace geodesic
{

/**
 * Decides which of two points of a surface counts as the nearest to a query: the nearer one, and of
 * two that are as near but for rounding the one with the lesser x, else y, else z. So the answer
 * depends neither on the order of the triangles nor on the pieces that a surface is cut into.
 */
class NearestOrder
{
public:
  struct Candidate
  {
    double distance = std::numeric_limits<double>::infinity();
    Vector3 position;
  };

  explicit NearestOrder(const Vector3& query)
    : Size(std::max({ std::abs(query.x), std::abs(query.y), std::abs(query.z) }))
  {
  }

  /** How much farther than a candidate another may be, so that only rounding tells them apart. */
  double blur(const Candidate& nearer) const { return 1e-13 * (this->Size + nearer.distance); }

  bool isBefore(const Candidate& a, const Candidate& b) const
  {
    const double blurred = this->blur(a.distance < b.distance ? a : b);
    if (std::abs(a.distance - b.distance) <= blurred)
    {
      const Vector3 apart = a.position - b.position;
      for (const double along : { apart.x, apart.y, apart.z })
      {
        if (std::abs(along) > 10.0 * blurred)
        {
          return along < 0.0;
        }
      }
    }
    return a.distance < b.distance;
  }

private:
  double Size;
};

}

#endif
