// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_Position_h
#define seeds_Position_h

#include <array>

namespace seeds
{

/** x, y and z in space, in the data's unit of length. */
using Position = std::array<double, 3>;

inline Position operator+(const Position& a, const Position& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Position operator-(const Position& a, const Position& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Position operator*(double s, const Position& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

inline double dot(const Position& a, const Position& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}

#endif
