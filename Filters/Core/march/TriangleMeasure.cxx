// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/TriangleMeasure.h"

#include "base/Lanes.h"
#include "march/LabelMargin.h"

#include <algorithm>
#include <limits>

namespace geodesic
{

#if GEODESIC_HAS_LANES

void TriangleMeasurer::measure(
  std::span<const Triangle> triangles, std::span<const Vector3> positions)
{
  if (this->UsesQuads)
  {
    this->measureByFour(triangles, positions);
  }
  else
  {
    this->measureByTwo(triangles, positions);
  }
}

[[gnu::flatten, GEODESIC_QUADS]] void TriangleMeasurer::measureByFour(
  std::span<const Triangle> triangles, std::span<const Vector3> positions)
{
  this->measureAll<Quad>(triangles, positions);
}

[[gnu::flatten]] void TriangleMeasurer::measureByTwo(
  std::span<const Triangle> triangles, std::span<const Vector3> positions)
{
  this->measureAll<Pair>(triangles, positions);
}

#else

void TriangleMeasurer::measure(
  std::span<const Triangle> triangles, std::span<const Vector3> positions)
{
  this->measureAll<double>(triangles, positions);
}

#endif

template <class Real>
GEODESIC_INLINED void TriangleMeasurer::measureAll(
  std::span<const Triangle> triangles, std::span<const Vector3> positions)
{
  // These exceed the relative and the absolute error of rounding to a float.
  constexpr double relative = std::numeric_limits<float>::epsilon();
  constexpr double absolute = std::numeric_limits<float>::denorm_min();
  static_assert(Most % lanes<Real> == 0);

  const auto measureSome = [&](const Triangle* some, std::size_t i)
  {
    const auto corners = [&](int c)
    {
      const auto corner = [&](std::size_t lane) -> const Vector3&
      { return positions[some[lane][c]]; };
      return sideBySide<Real>(corner);
    };
    const Vector3Of<Real> a = corners(0);
    const Vector3Of<Real> ab = corners(1) - a;
    const Vector3Of<Real> ac = corners(2) - a;
    const Real squareB = dot(ab, ab);
    const Real squareC = dot(ac, ac);
    const Real product = dot(ab, ac);
    const Real squareA = squareB + squareC - 2.0 * product;
    const Real longest = root(largest(squareA, largest(squareB, squareC)));
    const Real doubleArea = root(largest(squareB * squareC - product * product, Real()));
    // A triangle whose longest side is 0 has no height.
    const Real leastHeight =
      doubleArea / largest(longest, Real() + std::numeric_limits<double>::min());
    // A height near 0 is off by up to 3e-8 of the side, by the rounding of the squares.
    const Real slack = 2.0 * leastHeight - longest * (1.0 + 1.5 * relative) - absolute;
    storeFloats(least(slack, Real() + std::numeric_limits<float>::max()), &this->Slacks[i]);
    storeFloats(longest * (1.0 + relative) + absolute, &this->LongestSides[i]);
    storeFloats(labelMargin(longest, leastHeight) * (1.0 + relative) + absolute, &this->Margins[i]);
  };
  std::size_t i = 0;
  for (; i + lanes<Real> <= triangles.size(); i += lanes<Real>)
  {
    measureSome(&triangles[i], i);
  }
  if (i < triangles.size())
  {
    std::array<Triangle, lanes<Real>> last;
    last.fill(triangles.back());
    std::copy(triangles.begin() + i, triangles.end(), last.begin());
    measureSome(last.data(), i);
  }
}

}
