#ifndef geodesic_Vector3_h
#define geodesic_Vector3_h

#include "Pair.h"

#include <cmath>

namespace geodesic
{

/**
 * A point or a direction in space, in the mesh's length unit.
 * @tparam Real  double, or Pair for two at once
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

  friend constexpr Vector3Of operator*(Real s, const Vector3Of& a)
  {
    return { s * a.x, s * a.y, s * a.z };
  }

  friend constexpr Real dot(const Vector3Of& a, const Vector3Of& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }

  friend constexpr Vector3Of cross(const Vector3Of& a, const Vector3Of& b)
  {
    return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
  }

  friend Real norm(const Vector3Of& a) { return root(dot(a, a)); }
};

using Vector3 = Vector3Of<double>;

inline bool isFinite(const Vector3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/** Both side by side. */
inline Vector3Of<Pair> pairOf(const Vector3& a, const Vector3& b)
{
  return { Pair{ a.x, b.x }, Pair{ a.y, b.y }, Pair{ a.z, b.z } };
}

}

#endif
