// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleMeasure_h
#define geodesic_TriangleMeasure_h

#include "base/Index.h"
#include "base/Vector3.h"

#include <array>
#include <cstddef>
#include <span>

namespace geodesic
{

/** The sizes of a triangle that bound its updates; see UpdateBounds. */
struct TriangleMeasure
{
  /** TriangleSlack::isThin */
  bool isThin() const { return this->slack < -0.5f * this->longestSide; }

  /** TriangleSlack::value */
  float slack;
  /** Rounded up. */
  float longestSide;
  /** labelMargin(), rounded up. */
  float margin;
};

/** Measures some triangles, several at a time. */
class TriangleMeasurer
{
public:
  /** How many triangles it takes. */
  static constexpr std::size_t Most = 64;

  /** @param mayUseQuads whether four are measured at once where the processor can; the measures are
   * the same either way */
  explicit TriangleMeasurer(bool mayUseQuads = true)
    : UsesQuads(mayUseQuads && hasQuads())
  {
  }

  /** Measures at most Most triangles with corners at some of @p positions. */
  void measure(std::span<const Triangle> triangles, std::span<const Vector3> positions);

  /** The measure of one of the triangles. */
  TriangleMeasure operator[](std::size_t i) const
  {
    return { this->Slacks[i], this->LongestSides[i], this->Margins[i] };
  }

private:
  template <class Real>
  void measureAll(std::span<const Triangle> triangles, std::span<const Vector3> positions);
  void measureByFour(std::span<const Triangle> triangles, std::span<const Vector3> positions);
  void measureByTwo(std::span<const Triangle> triangles, std::span<const Vector3> positions);

  bool UsesQuads;
  std::array<float, Most> Slacks;
  std::array<float, Most> LongestSides;
  std::array<float, Most> Margins;
};

}

#endif
