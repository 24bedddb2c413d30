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

  explicit MortonCurve(const BoundingBox& box)
    : Low(box.low)
  {
    const Vector3 size = box.high - box.low;
    const double extent = std::max({ size.x, size.y, size.z });
    this->CellsPerUnit = extent > 0.0 ? ((1 << BitsPerAxis) - 1) / extent : 0.0;
  }

  /** How far along the curve a point of the box is, in 63 bits. */
  std::uint64_t codeOf(const Vector3& point) const
  {
    const Vector3 cell = this->CellsPerUnit * (point - this->Low);
    return spread(static_cast<std::int64_t>(cell.x)) |
      spread(static_cast<std::int64_t>(cell.y)) << 1 |
      spread(static_cast<std::int64_t>(cell.z)) << 2;
  }

  /** The first 32 bits of codeOf(), at less cost. */
  std::uint32_t leadingBitsOf(const Vector3& point) const
  {
    // 33 bits, less the last one.
    const Lanes bits = spread(this->cellOf(point) >> (BitsPerAxis - LeadingPerAxis));
    return bits[0] >> 1 | bits[1] | bits[2] << 1;
  }

  /** The other 31 of them. */
  std::uint32_t otherBitsOf(const Vector3& point) const
  {
    constexpr std::uint32_t others = (1u << (BitsPerAxis - LeadingPerAxis)) - 1;
    const Lanes bits = spread(this->cellOf(point) & Lanes{ 2 * others + 1, others, others });
    return bits[0] | bits[1] << 1 | bits[2] << 2;
  }

private:
  /** One number an axis, which the processor treats at once. */
  using Lanes = std::uint32_t __attribute__((vector_size(16)));
  static constexpr int LeadingPerAxis = 11;

  Lanes cellOf(const Vector3& point) const
  {
    const Vector3 cell = this->CellsPerUnit * (point - this->Low);
    return Lanes{ static_cast<std::uint32_t>(static_cast<std::int32_t>(cell.x)),
      static_cast<std::uint32_t>(static_cast<std::int32_t>(cell.y)),
      static_cast<std::uint32_t>(static_cast<std::int32_t>(cell.z)) };
  }

  /** Moves the low 11 bits of each number to every third bit. */
  static Lanes spread(Lanes values)
  {
    values = (values | values << 16) & 0x070000ffu;
    values = (values | values << 8) & 0x0700f00fu;
    values = (values | values << 4) & 0x430c30c3u;
    values = (values | values << 2) & 0x49249249u;
    return values;
  }

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
