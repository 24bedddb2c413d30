// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Vector3_h
#define geodesic_Vector3_h

#include "base/Lanes.h"

#include <array>
#include <cmath>
#include <cstring>

namespace geodesic
{

/**
 * A point or a direction in space, in the mesh's length unit.
 * @tparam Real  double for one vector, Pair or Quad for two or four at once (see Lanes.h)
 */
template <class Real>
struct Vector3Of
{
  Real x{};
  Real y{};
  Real z{};

  friend constexpr bool operator==(const Vector3Of&, const Vector3Of&) = default;

  friend constexpr Vector3Of operator+(const Vector3Of& a, const Vector3Of& b)
  {
    return { a.x + b.x, a.y + b.y, a.z + b.z };
  }

  friend constexpr Vector3Of operator-(const Vector3Of& a, const Vector3Of& b)
  {
    return { a.x - b.x, a.y - b.y, a.z - b.z };
  }

  GEODESIC_INLINED friend constexpr Vector3Of operator*(Real s, const Vector3Of& a)
  {
    return { s * a.x, s * a.y, s * a.z };
  }

  GEODESIC_INLINED friend constexpr Real dot(const Vector3Of& a, const Vector3Of& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }

  friend constexpr Vector3Of cross(const Vector3Of& a, const Vector3Of& b)
  {
    return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
  }

  GEODESIC_INLINED friend Real norm(const Vector3Of& a) { return root(dot(a, a)); }
};

using Vector3 = Vector3Of<double>;

inline bool isFinite(const Vector3& a)
{
  // Infinity and NaN minus themselves are NaN; a finite number minus itself is 0.
  return (a.x - a.x) + (a.y - a.y) + (a.z - a.z) == 0.0;
}

/** Packs as many vectors as a Real has lanes: vectorAt(i) in lane i. */
template <class Real, class VectorAt>
GEODESIC_INLINED Vector3Of<Real> sideBySide(VectorAt vectorAt) requires(lanes<Real> == 1)
{
  return vectorAt(0);
}

#if GEODESIC_HAS_LANES

/** Packs two vectors: @p a in lane 0, @p b in lane 1. */
inline Vector3Of<Pair> pairOf(const Vector3& a, const Vector3& b)
{
  return { Pair{ a.x, b.x }, Pair{ a.y, b.y }, Pair{ a.z, b.z } };
}

template <class Real, class VectorAt>
GEODESIC_INLINED Vector3Of<Real> sideBySide(VectorAt vectorAt) requires(lanes<Real> > 1)
{
  if constexpr (lanes<Real> == 2)
  {
    return pairOf(vectorAt(0), vectorAt(1));
  }
  else
  {
    // x and y are adjacent in memory, so one load reads both; the shuffles below separate them.
    const auto xy = [&](int i, int j)
    {
      Pair a;
      Pair b;
      std::memcpy(&a, &vectorAt(i), sizeof a);
      std::memcpy(&b, &vectorAt(j), sizeof b);
      return std::array{ a, b };
    };
    const auto [a, c] = xy(0, 2);
    const auto [b, d] = xy(1, 3);
    const Quad even = __builtin_shufflevector(a, c, 0, 1, 2, 3);
    const Quad odd = __builtin_shufflevector(b, d, 0, 1, 2, 3);
    return { __builtin_shufflevector(even, odd, 0, 4, 2, 6),
      __builtin_shufflevector(even, odd, 1, 5, 3, 7),
      lanesOf<Real>([&](int i) { return vectorAt(i).z; }) };
  }
}

#endif

}

#endif
