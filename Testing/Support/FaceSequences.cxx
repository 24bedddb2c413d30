// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSequences.h"

#include "base/PlanePoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesic::testing
{
namespace
{

/** Positive where b lies to the left of a, as seen from the origin. */
double turn(const PlanePoint& a, const PlanePoint& b)
{
  return a.x * b.y - a.y * b.x;
}

/** Follows all straight lines from one point, which lies at the origin of the plane. */
class Lines
{
public:
  Lines(const Surface& surface, std::vector<double>& distances)
    : Given(surface)
    , Used(surface.triangles.size(), false)
    , Distances(distances)
  {
  }

  void from(Index source)
  {
    this->Distances[source] = 0.0;
    for (std::size_t t = 0; t < this->Given.triangles.size(); ++t)
    {
      const Triangle& corners = this->Given.triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        if (corners[k] == source)
        {
          this->start(t, source, corners[(k + 1) % 3], corners[(k + 2) % 3]);
        }
      }
    }
  }

private:
  /** A corner, and where it lies in the plane. */
  struct Laid
  {
    Index point;
    PlanePoint place;
  };

  const Vector3& at(Index point) const { return this->Given.points[point]; }

  void start(std::size_t triangle, Index source, Index first, Index second)
  {
    const Laid right{ first, { norm(this->at(first) - this->at(source)), 0.0 } };
    const Laid left{ second, this->placed({ source, {} }, right, second) };
    this->reach(right);
    this->reach(left);
    this->Used[triangle] = true;
    this->goThrough(right, left, right.place, left.place);
    this->Used[triangle] = false;
  }

  /** Where a point comes to lie to the left of the way from one laid corner to another. */
  PlanePoint placed(const Laid& a, const Laid& b, Index point) const
  {
    const Vector3 edge = this->at(b.point) - this->at(a.point);
    const Vector3 side = this->at(point) - this->at(a.point);
    const double length = norm(edge);
    const double along = dot(side, edge) / length;
    const double off = norm(cross(edge, side)) / length;
    const double x = (b.place.x - a.place.x) / length;
    const double y = (b.place.y - a.place.y) / length;
    return { a.place.x + along * x - off * y, a.place.y + along * y + off * x };
  }

  void reach(const Laid& corner)
  {
    double& known = this->Distances[corner.point];
    known = std::min(known, std::hypot(corner.place.x, corner.place.y));
  }

  /** Goes on through an edge, with lines between two directions. */
  void goThrough(
    const Laid& right, const Laid& left, const PlanePoint& rightmost, const PlanePoint& leftmost)
  {
    for (std::size_t t = 0; t < this->Given.triangles.size(); ++t)
    {
      const Triangle& corners = this->Given.triangles[t];
      const auto has = [&](Index point)
      { return std::find(corners.begin(), corners.end(), point) != corners.end(); };
      if (this->Used[t] || !has(right.point) || !has(left.point))
      {
        continue;
      }
      const Index apex = *std::find_if(corners.begin(), corners.end(),
        [&](Index corner) { return corner != right.point && corner != left.point; });
      // Seen from the source the new corner lies behind the edge, to the left of the way from its
      // left to its right end.
      const Laid next{ apex, this->placed(left, right, apex) };
      const bool isLeftOfRight = turn(rightmost, next.place) >= 0.0;
      const bool isRightOfLeft = turn(leftmost, next.place) <= 0.0;
      this->Used[t] = true;
      if (isLeftOfRight && isRightOfLeft)
      {
        this->reach(next);
      }
      if (isLeftOfRight)
      {
        this->goThrough(right, next, rightmost, isRightOfLeft ? next.place : leftmost);
      }
      if (isRightOfLeft)
      {
        this->goThrough(next, left, isLeftOfRight ? next.place : rightmost, leftmost);
      }
      this->Used[t] = false;
    }
  }

  const Surface& Given;
  std::vector<bool> Used;
  std::vector<double>& Distances;
};

}

std::vector<std::vector<double>> leastOfFaceSequences(const Surface& surface)
{
  const std::size_t n = surface.points.size();
  std::vector<std::vector<double>> all(
    n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (Index source = 0; source < n; ++source)
  {
    Lines(surface, all[source]).from(source);
  }
  for (std::size_t middle = 0; middle < n; ++middle)
  {
    for (std::size_t a = 0; a < n; ++a)
    {
      for (std::size_t b = 0; b < n; ++b)
      {
        all[a][b] = std::min(all[a][b], all[a][middle] + all[middle][b]);
      }
    }
  }
  return all;
}

}
