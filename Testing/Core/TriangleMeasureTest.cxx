// Sizes of triangles that are known, and what is made of them, which has to be on the safe side.

#include "TriangleMeasure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace geodesic;

namespace
{

using Corners = std::array<Vector3, 3>;

/** A triangle with sides of 3, 4 and 5, one of no height, and one that is a point. */
const std::vector<Corners> Triangles{
  { { { 0.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, { 0.0, 0.0, 4.0 } } },
  { { { 0.0, 0.0, 4.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 } } },
  { { { 0.0, 3.0, 0.0 }, { 0.0, 3.0, 0.0 }, { 0.0, 3.0, 0.0 } } }
};

std::array<TriangleMeasure, 2> measuresOf(const Corners& t, const Corners& u)
{
  return geodesic::measuresOf(pairOf(t[0], u[0]), pairOf(t[1], u[1]), pairOf(t[2], u[2]));
}

TriangleMeasure measureOf(const Corners& t)
{
  return measuresOf(t, t)[0];
}

}

TEST(TriangleMeasure, IsRoundedToTheSafeSide)
{
  const std::vector<double> slacks{ 2.0 * 2.4 - 5.0, -4.0, 0.0 };
  const std::vector<double> longestSides{ 5.0, 4.0, 0.0 };
  const std::vector<double> margins{ labelMargin(5.0, 2.4), 5.0 * 4.0, 0.0 };
  for (std::size_t t = 0; t < Triangles.size(); ++t)
  {
    const TriangleMeasure measure = measureOf(Triangles[t]);
    EXPECT_LT(measure.slack, slacks[t]);
    EXPECT_NEAR(measure.slack, slacks[t], 1e-6);
    EXPECT_GT(measure.longestSide, longestSides[t]);
    EXPECT_NEAR(measure.longestSide, longestSides[t], 1e-6);
    EXPECT_GT(measure.margin, margins[t]);
    EXPECT_NEAR(measure.margin, margins[t], 1e-5);
  }
}

// Whichever corner is the far one of a needle; the truth by the cross product, which loses nothing.
TEST(TriangleMeasure, IsOnTheSafeSideForNeedles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&](double size) {
    return size * Vector3{ number(random), number(random), number(random) };
  };
  for (int i = 0; i < 20000; ++i)
  {
    const double width = std::pow(10.0, -i % 13);
    Corners t{ vector(1.0), vector(1.0), {} };
    t[2] = t[0] + (i % 2) * 0.4 * (t[1] - t[0]) + vector(width);
    std::rotate(t.begin(), t.begin() + i % 3, t.end());
    const double longest = std::max({ norm(t[1] - t[0]), norm(t[2] - t[1]), norm(t[0] - t[2]) });
    const double height = norm(cross(t[1] - t[0], t[2] - t[0])) / longest;
    const TriangleMeasure measure = measureOf(t);
    ASSERT_LT(measure.slack, 2.0 * height - longest);
    ASSERT_NEAR(measure.slack, 2.0 * height - longest, 4e-7 * longest);
    ASSERT_GT(measure.longestSide, longest);
    ASSERT_NEAR(measure.longestSide, longest, 4e-7 * longest);
  }
}

TEST(TriangleMeasure, LongestSideIsAnyOfThree)
{
  const auto [a, b, c] = Triangles[0];
  for (const Corners& turned : { Corners{ a, b, c }, Corners{ b, c, a }, Corners{ c, a, b } })
  {
    EXPECT_NEAR(measureOf(turned).longestSide, 5.0, 1e-6);
  }
}

TEST(TriangleMeasure, ThinIsLessThanAQuarterOfTheLongestSideHigh)
{
  EXPECT_FALSE(measureOf(Triangles[0]).isThin());
  EXPECT_TRUE(measureOf(Triangles[1]).isThin());
  // 4 long, and a little higher than 1 or lower.
  const auto flat = [](double height) -> Corners {
    return { { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 1.0, height, 0.0 } } };
  };
  const std::array<TriangleMeasure, 2> two = measuresOf(flat(1.01), flat(0.99));
  EXPECT_FALSE(two[0].isThin());
  EXPECT_TRUE(two[1].isThin());
}

TEST(TriangleMeasure, IsTheSameBesideAnyOther)
{
  for (const Corners& t : Triangles)
  {
    const TriangleMeasure alone = measureOf(t);
    for (const Corners& u : Triangles)
    {
      for (const TriangleMeasure& measure : { measuresOf(t, u)[0], measuresOf(u, t)[1] })
      {
        EXPECT_EQ(measure.slack, alone.slack);
        EXPECT_EQ(measure.longestSide, alone.longestSide);
        EXPECT_EQ(measure.margin, alone.margin);
      }
    }
  }
}
