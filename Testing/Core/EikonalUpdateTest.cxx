// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The update of one triangle: right where a source exists, monotone everywhere.

#include "march/EikonalUpdate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace geodesic;

namespace
{

/** The third corner at (x, h) over an edge of length 1 along the x axis. */
FlatTriangle triangleTo(double x, double h)
{
  return { 1.0, x, h * h };
}

/** Random triangles over an edge of length 1, needles and obtuse ones among them. */
FlatTriangle randomTriangle(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double height = std::pow(10.0, -8.0 * uniform(random));
  return triangleTo(3.0 * uniform(random) - 1.0, height);
}

}

// The source lies at (x, -y) below the edge; where the straight line to v crosses the edge it is
// the truth.
TEST(EikonalUpdate, IsExactForAPointSource)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int checked = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const double foot = 2.0 * uniform(random) - 0.5;
    const double height = 0.05 + uniform(random);
    const double x = 4.0 * uniform(random) - 2.0;
    const double y = 0.01 + 3.0 * uniform(random);
    const double crossing = x + (foot - x) * y / (y + height);
    if (crossing > 0.0 && crossing < 1.0)
    {
      const double value =
        pointSourceUpdate(triangleTo(foot, height), std::hypot(x, y), std::hypot(x - 1.0, y));
      EXPECT_NEAR(value, std::hypot(x - foot, y + height), 1e-11);
      ++checked;
    }
  }
  EXPECT_GT(checked, 10000);
}

// A front that advances in a direction has distance w times the way in that direction, everywhere.
TEST(EikonalUpdate, IsExactForAStraightFront)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int checked = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const double foot = 2.0 * uniform(random) - 0.5;
    const double height = 0.05 + uniform(random);
    const double w = 0.1 + 3.0 * uniform(random);
    const double sine = 2.0 * uniform(random) - 1.0;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double crossing = foot - height * sine / cosine;
    if (crossing > 0.0 && crossing < 1.0)
    {
      const double value = straightFrontUpdate(triangleTo(foot, height), 5.0, 5.0 + w * sine, w);
      EXPECT_NEAR(value, 5.0 + w * (sine * foot + cosine * height), 1e-11);
      ++checked;
    }
  }
  EXPECT_GT(checked, 10000);
}

TEST(EikonalUpdate, IsMonotoneInBothValues)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 200000; ++i)
  {
    const FlatTriangle t = randomTriangle(random);
    const double a = 3.0 * uniform(random);
    const double b = 3.0 * uniform(random);
    const double step = std::pow(10.0, -6.0 * uniform(random));
    const double value = pointSourceUpdate(t, a, b);
    EXPECT_LE(value, pointSourceUpdate(t, a + step, b) + 1e-12);
    EXPECT_LE(value, pointSourceUpdate(t, a, b + step) + 1e-12);
    const double w = 0.1 + 3.0 * uniform(random);
    const double straight = straightFrontUpdate(t, a, b, w);
    EXPECT_LE(straight, straightFrontUpdate(t, a + step, b, w) + 1e-12);
    EXPECT_LE(straight, straightFrontUpdate(t, a, b + step, w) + 1e-12);
    const double bypassed = bypassedUpdate(t, a, b, w);
    EXPECT_LE(bypassed, bypassedUpdate(t, a + step, b, w) + 1e-12);
    EXPECT_LE(bypassed, bypassedUpdate(t, a, b + step, w) + 1e-12);
    EXPECT_GE(bypassed, straight);
    EXPECT_GE(bypassedCrossing(t, a, b, w), std::max(a, b));
  }
}

#if GEODESIC_HAS_LANES

namespace
{

/** Compares updates of several triangles at once with those one by one. */
template <class Real>
void expectTheSameAtOnce()
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.0, 3.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20000; ++i)
  {
    std::array<FlatTriangle, lanes<Real>> t;
    FlatTriangleOf<Real> all;
    Real a;
    Real b;
    Real w;
    for (std::size_t k = 0; k < lanes<Real>; ++k)
    {
      t[k] = randomTriangle(random);
      all.squaredEdge[k] = t[k].squaredEdge;
      all.product[k] = t[k].product;
      all.squaredArea[k] = t[k].squaredArea;
      a[k] = uniform(random);
      b[k] = k > 0 && i % 10 == 0 ? infinity : uniform(random);
      w[k] = 1.0 + static_cast<double>(k);
    }
    const Real round = pointSourceCrossing<Real>(all, a, b);
    const Real straight = straightFrontCrossing<Real>(all, a, b, w);
    for (std::size_t k = 0; k < lanes<Real>; ++k)
    {
      EXPECT_EQ(round[k], pointSourceCrossing<double>(t[k], a[k], b[k]));
      EXPECT_EQ(straight[k], straightFrontCrossing<double>(t[k], a[k], b[k], w[k]));
    }
  }
}

}

TEST(EikonalUpdate, TwoAtOnceAreTheSame)
{
  expectTheSameAtOnce<Pair>();
}

TEST(EikonalUpdate, FourAtOnceAreTheSame)
{
  if (!hasQuads())
  {
    GTEST_SKIP() << "This processor does not treat four numbers at once.";
  }
  expectTheSameAtOnce<Quad>();
}

#endif

// What TriangleSlack rests on.
TEST(EikonalUpdate, CrossesNoEdgeBelowTheMeanOfItsEndsAndTheSlack)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 200000; ++i)
  {
    const FlatTriangle t = randomTriangle(random);
    const double a = 3.0 * uniform(random);
    const double b = 3.0 * uniform(random);
    const double slack = 2.0 * std::sqrt(t.squaredArea) - 1.0;
    EXPECT_GE(pointSourceCrossing(t, a, b), 0.5 * (a + b + slack) - 1e-12);
    const double w = 0.1 + 3.0 * uniform(random);
    EXPECT_GE(straightFrontCrossing(t, a, b, w), 0.5 * (a + b + w * slack) - 1e-12);
  }
}

TEST(EikonalUpdate, OneReachedEndIsAWayAlongTheSide)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const FlatTriangle t = triangleTo(0.3, 0.8);
  EXPECT_DOUBLE_EQ(pointSourceUpdate(t, 0.5, infinity), 0.5 + t.lengthFromA());
  EXPECT_DOUBLE_EQ(pointSourceUpdate(t, infinity, 0.5), 0.5 + t.lengthFromB());
}

TEST(EikonalUpdate, IsScaleFree)
{
  const FlatTriangle t = triangleTo(0.3, 0.8);
  const double value = pointSourceUpdate(t, 0.9, 1.2);
  for (double scale : { 1e-50, 1e-30, 1e-6, 1e6, 1e30, 1e50 })
  {
    const double square = scale * scale;
    const FlatTriangle scaled{ square, 0.3 * square, 0.64 * square * square };
    EXPECT_NEAR(pointSourceUpdate(scaled, 0.9 * scale, 1.2 * scale) / scale, value, 1e-12);
  }
}
