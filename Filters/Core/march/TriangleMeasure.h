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
  /** See TriangleSlack::isThin(). */
  bool isThin() const { return this->slack < -0.5f * this->longestSide; }

  /** See TriangleSlack::value(); rounded down. */
  float slack;
  /** The length of the longest side, rounded up. */
  float longestSide;
  /** labelMargin(), rounded up. */
  float margin;
};

/** Measures up to 64 triangles, two or four at a time. */
class TriangleMeasurer
{
public:
  /** Largest number of triangles. */
  static constexpr std::size_t Most = 64;

  /** @param mayUseQuads whether four triangles are measured at once if the processor can; the
   * results are the same either way */
  explicit TriangleMeasurer(bool mayUseQuads = true)
    : UsesQuads(mayUseQuads && hasQuads())
  {
  }

  /** Measures @p triangles, at most Most of them. @param positions of the vertices */
  void measure(std::span<const Triangle> triangles, std::span<const Vector3> positions);

  /** The result for triangle @p i of the last measure(). */
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
