// The update of one triangle: right where a source exists, monotone everywhere.

#include "EikonalUpdate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace geodesic;

namespace
{

/** Random triangles, needles and obtuse ones among them. */
FlatTriangle randomTriangle(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double height = std::pow(10.0, -8.0 * uniform(random));
  return { 1.0, 3.0 * uniform(random) - 1.0, height };
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
    const FlatTriangle t{ 1.0, 2.0 * uniform(random) - 0.5, 0.05 + uniform(random) };
    const double x = 4.0 * uniform(random) - 2.0;
    const double y = 0.01 + 3.0 * uniform(random);
    const double crossing = x + (t.x - x) * y / (y + t.h);
    if (crossing > 0.0 && crossing < 1.0)
    {
      const double value = pointSourceUpdate(t, std::hypot(x, y), std::hypot(x - 1.0, y));
      EXPECT_NEAR(value, std::hypot(x - t.x, y + t.h), 1e-11);
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
    const FlatTriangle t{ 1.0, 2.0 * uniform(random) - 0.5, 0.05 + uniform(random) };
    const double w = 0.1 + 3.0 * uniform(random);
    const double sine = 2.0 * uniform(random) - 1.0;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double crossing = t.x - t.h * sine / cosine;
    if (crossing > 0.0 && crossing < 1.0)
    {
      const double value = straightFrontUpdate(t, 5.0, 5.0 + w * sine, w);
      EXPECT_NEAR(value, 5.0 + w * (sine * t.x + cosine * t.h), 1e-11);
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
  }
}

TEST(EikonalUpdate, TwoAtOnceAreTheSame)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.0, 3.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20000; ++i)
  {
    const std::array<FlatTriangle, 2> t{ randomTriangle(random), randomTriangle(random) };
    const FlatTriangleOf<Pair> both{ Pair{ t[0].c, t[1].c }, Pair{ t[0].x, t[1].x },
      Pair{ t[0].h, t[1].h } };
    const Pair a{ uniform(random), uniform(random) };
    const Pair b{ uniform(random), i % 10 == 0 ? infinity : uniform(random) };
    const Pair w{ 1.0, 2.0 };
    const Pair round = pointSourceCrossing(both, a, b);
    const Pair straight = straightFrontCrossing(both, a, b, w);
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_EQ(round[k], pointSourceCrossing(t[k], a[k], b[k]));
      EXPECT_EQ(straight[k], straightFrontCrossing(t[k], a[k], b[k], w[k]));
    }
  }
}

// What RingEntry::slack rests on.
TEST(EikonalUpdate, CrossesNoEdgeBelowTheMeanOfItsEndsAndTheSlack)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 200000; ++i)
  {
    const FlatTriangle t = randomTriangle(random);
    const double a = 3.0 * uniform(random);
    const double b = 3.0 * uniform(random);
    const double slack = 2.0 * t.h - t.c;
    EXPECT_GE(pointSourceCrossing(t, a, b), 0.5 * (a + b + slack) - 1e-12);
    const double w = 0.1 + 3.0 * uniform(random);
    EXPECT_GE(straightFrontCrossing(t, a, b, w), 0.5 * (a + b + w * slack) - 1e-12);
  }
}

TEST(EikonalUpdate, OneReachedEndIsAWayAlongTheSide)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const FlatTriangle t{ 1.0, 0.3, 0.8 };
  EXPECT_DOUBLE_EQ(pointSourceUpdate(t, 0.5, infinity), 0.5 + t.lengthFromA());
  EXPECT_DOUBLE_EQ(pointSourceUpdate(t, infinity, 0.5), 0.5 + t.lengthFromB());
}

TEST(EikonalUpdate, IsScaleFree)
{
  const FlatTriangle t{ 1.0, 0.3, 0.8 };
  const double value = pointSourceUpdate(t, 0.9, 1.2);
  for (double scale : { 1e-30, 1e-6, 1e6, 1e30 })
  {
    const FlatTriangle scaled{ scale, 0.3 * scale, 0.8 * scale };
    EXPECT_NEAR(pointSourceUpdate(scaled, 0.9 * scale, 1.2 * scale) / scale, value, 1e-12);
  }
}
