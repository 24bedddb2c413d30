// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "march/TriangleMeasure.h"

#include "base/Lanes.h"
#include "march/LabelMargin.h"

#include <algorithm>
#include <array>
#include <limits>

namespace geodesic
{

namespace
{

template <class Real>
GEODESIC_INLINED void measureAll(
  std::span<const Triangle> triangles, std::span<const Vector3> positions, TriangleNumbers& numbers)
{
  // These exceed the relative and the absolute error of rounding to a float.
  constexpr double relative = std::numeric_limits<float>::epsilon();
  constexpr double absolute = std::numeric_limits<float>::denorm_min();
  static_assert(TriangleNumbers::Most % lanes<Real> == 0);
  std::array<float, TriangleNumbers::Most> slacks{};

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
    storeFloats(least(slack, Real() + std::numeric_limits<float>::max()), &slacks[i]);
    storeFloats(longest * (1.0 + relative) + absolute, &numbers.longestSides[i]);
    storeFloats(
      labelMargin(longest, leastHeight) * (1.0 + relative) + absolute, &numbers.ofVertices[i]);
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
  // For all of the arrays, whose size is known, so that the compiler can treat several at a time.
  for (std::size_t t = 0; t < TriangleNumbers::Most; ++t)
  {
    const bool isThin = slacks[t] < -0.5f * numbers.longestSides[t];
    numbers.ofEntries[t] = TriangleSlack(slacks[t], isThin).stored();
  }
}

#if GEODESIC_HAS_LANES

[[gnu::flatten, GEODESIC_QUADS]] void measureByFour(
  std::span<const Triangle> triangles, std::span<const Vector3> positions, TriangleNumbers& numbers)
{
  measureAll<Quad>(triangles, positions, numbers);
}

[[gnu::flatten]] void measureByTwo(
  std::span<const Triangle> triangles, std::span<const Vector3> positions, TriangleNumbers& numbers)
{
  measureAll<Pair>(triangles, positions, numbers);
}

#endif

}

void TriangleMeasurer::measure(std::span<const Triangle> triangles,
  std::span<const Vector3> positions, TriangleNumbers& numbers) const
{
#if GEODESIC_HAS_LANES
  (this->UsesQuads ? measureByFour : measureByTwo)(triangles, positions, numbers);
#else
  measureAll<double>(triangles, positions, numbers);
#endif
}

}
