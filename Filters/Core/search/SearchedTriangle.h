// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SearchedTriangle_h
#define geodesic_SearchedTriangle_h

#include "base/Vector3.h"

#include <algorithm>
#include <array>
#include <limits>

namespace geodesic
{

/** A point of a triangle, as barycentric weights of the corners, and its squared distance to a
 * query. */
struct OnTriangle
{
  std::array<double, 3> weights;
  double squaredDistance;
};

/** The point of the side from corner @p i to corner @p j that is nearest to @p query. */
inline OnTriangle onSide(const std::array<Vector3, 3>& corners, int i, int j, const Vector3& query)
{
  const Vector3 side = corners[j] - corners[i];
  const double length2 = dot(side, side);
  const double t =
    length2 > 0.0 ? std::clamp(dot(query - corners[i], side) / length2, 0.0, 1.0) : 0.0;
  const Vector3 away = query - (corners[i] + t * side);
  OnTriangle result{ { 0.0, 0.0, 0.0 }, dot(away, away) };
  result.weights[i] = 1.0 - t;
  result.weights[j] = t;
  return result;
}

/** Finds the point of a triangle that is nearest to a query. */
class SearchedTriangle
{
public:
  SearchedTriangle(const std::array<Vector3, 3>& corners, const Vector3& query)
    : Corners(corners)
    , Query(query)
    , Side1(corners[1] - corners[0])
    , Side2(corners[2] - corners[0])
    , Normal(cross(this->Side1, this->Side2))
    , SquaredNormal(dot(this->Normal, this->Normal))
    , Height(dot(query - corners[0], this->Normal))
  {
  }

  /** Whether the triangle's plane is already farther from the query than a known distance. False
   * does not mean that the triangle is nearer. */
  bool isBeyond(double squaredDistance) const
  {
    // The normal of a needle is too inexact for this test.
    constexpr double leastSquaredSine = 1e-8;
    return this->Height * this->Height > squaredDistance * this->SquaredNormal &&
      this->SquaredNormal >
      leastSquaredSine * dot(this->Side1, this->Side1) * dot(this->Side2, this->Side2);
  }

  /** The point of the triangle that is nearest to the query. */
  OnTriangle nearest() const
  {
    if (!(this->SquaredNormal > 0.0))
    {
      return this->nearestOnSides({ true, true, true });
    }
    const Vector3 toQuery = this->Query - this->Corners[0];
    const double w1 = dot(cross(toQuery, this->Side2), this->Normal) / this->SquaredNormal;
    const double w2 = dot(cross(this->Side1, toQuery), this->Normal) / this->SquaredNormal;
    const double w0 = 1.0 - w1 - w2;
    if (w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0)
    {
      return { { w0, w1, w2 }, this->Height * this->Height / this->SquaredNormal };
    }
    return this->nearestOnSides({ !(w0 >= 0.0), !(w1 >= 0.0), !(w2 >= 0.0) });
  }

private:
  /** The nearest point on the sides opposite to the corners that are flagged. */
  OnTriangle nearestOnSides(const std::array<bool, 3>& isSearched) const
  {
    OnTriangle best{ {}, std::numeric_limits<double>::infinity() };
    for (int corner = 0; corner < 3; ++corner)
    {
      if (isSearched[corner])
      {
        const OnTriangle found =
          onSide(this->Corners, (corner + 1) % 3, (corner + 2) % 3, this->Query);
        best = found.squaredDistance < best.squaredDistance ? found : best;
      }
    }
    return best;
  }

  const std::array<Vector3, 3>& Corners;
  const Vector3& Query;
  Vector3 Side1;
  Vector3 Side2;
  Vector3 Normal;
  double SquaredNormal;
  double Height;
};

}

#endif
