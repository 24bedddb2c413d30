#ifndef geodesic_MortonCurve_h
#define geodesic_MortonCurve_h

#include "Vector3.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace geodesic
{

/** The smallest box with the axes' directions round points. */
struct BoundingBox
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low{ infinity, infinity, infinity };
  Vector3 high{ -infinity, -infinity, -infinity };

  void add(const Vector3& lowest, const Vector3& highest)
  {
    const auto [lx, ly, lz] = lowest;
    const auto [hx, hy, hz] = highest;
    this->low = { std::min(this->low.x, lx), std::min(this->low.y, ly), std::min(this->low.z, lz) };
    this->high = { std::max(this->high.x, hx), std::max(this->high.y, hy),
      std::max(this->high.z, hz) };
  }
  void add(const Vector3& point) { this->add(point, point); }
};

/**
 * A Morton (Z) curve through the cube at a box's low corner that holds the box.
 * G. M. Morton, A computer oriented geodetic data base, IBM (1966).
 */
class MortonCurve
{
public:
  static constexpr int BitsPerAxis = 21;
  static constexpr int CodeBits = 3 * BitsPerAxis;

  explicit MortonCurve(const BoundingBox& box)
    : Low(box.low)
  {
    const Vector3 size = box.high - box.low;
    const double extent = std::max({ size.x, size.y, size.z });
    this->CellsPerUnit = extent > 0.0 ? ((1 << BitsPerAxis) - 1) / extent : 0.0;
  }

  /** How far along the curve a point of the box is. */
  std::uint64_t codeOf(const Vector3& point) const
  {
    const Vector3 cell = this->CellsPerUnit * (point - this->Low);
    return spread(static_cast<std::int64_t>(cell.x)) |
      spread(static_cast<std::int64_t>(cell.y)) << 1 |
      spread(static_cast<std::int64_t>(cell.z)) << 2;
  }

private:
  /** Moves the low 21 bits of @p value to every third bit. */
  static std::uint64_t spread(std::uint64_t value)
  {
    value = (value | value << 32) & 0x1f00000000ffffull;
    value = (value | value << 16) & 0x1f0000ff0000ffull;
    value = (value | value << 8) & 0x100f00f00f00f00full;
    value = (value | value << 4) & 0x10c30c30c30c30c3ull;
    value = (value | value << 2) & 0x1249249249249249ull;
    return value;
  }

  Vector3 Low;
  double CellsPerUnit;
};

}

#endif
