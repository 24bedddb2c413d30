// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PlanePoint_h
#define geodesic_PlanePoint_h

namespace geodesic
{

/** A point in the plane that faces are laid in. */
struct PlanePoint
{
  double x = 0.0;
  double y = 0.0;
};

constexpr PlanePoint operator-(const PlanePoint& a, const PlanePoint& b)
{
  return { a.x - b.x, a.y - b.y };
}

/** Twice the area of a triangle: positive where a, b and c are counterclockwise. */
inline double orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}

#endif
