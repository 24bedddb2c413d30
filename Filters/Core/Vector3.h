#ifndef geodesic_Vector3_h
#define geodesic_Vector3_h

#include <cmath>

namespace geodesic
{

/** A point or a direction in space, in the mesh's length unit. */
struct Vector3
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

constexpr Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}

constexpr Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

constexpr Vector3 operator*(double s, const Vector3& a)
{
  return { s * a.x, s * a.y, s * a.z };
}

constexpr double dot(const Vector3& a, const Vector3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vector3 cross(const Vector3& a, const Vector3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

inline double norm(const Vector3& a)
{
  return std::sqrt(dot(a, a));
}

inline bool isFinite(const Vector3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}

#endif
