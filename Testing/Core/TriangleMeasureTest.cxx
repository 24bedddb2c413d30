// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes of triangles that are known, and what is made of them, which has to be on the safe side.

#include "march/TriangleMeasure.h"
#include "march/LabelMargin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace geodesic;

namespace
{

using ThreeCorners = std::array<Vector3, 3>;

/** A triangle with sides of 3, 4 and 5, one of no height, and one that is a point. */
const std::vector<ThreeCorners> Triangles{
  { { { 0.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, { 0.0, 0.0, 4.0 } } },
  { { { 0.0, 0.0, 4.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 } } },
  { { { 0.0, 3.0, 0.0 }, { 0.0, 3.0, 0.0 }, { 0.0, 3.0, 0.0 } } }
};

struct TriangleMeasure
{
  bool isThin() const { return this->slack.isThin(); }

  TriangleSlack slack;
  float longestSide;
  float margin;
};

std::vector<TriangleMeasure> measuresOf(
  const std::vector<ThreeCorners>& all, bool mayUseQuads = true)
{
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
  for (const ThreeCorners& t : all)
  {
    const Index first = static_cast<Index>(positions.size());
    positions.insert(positions.end(), t.begin(), t.end());
    triangles.push_back({ first, first + 1, first + 2 });
  }
  TriangleNumbers numbers;
  TriangleMeasurer(mayUseQuads).measure(triangles, positions, numbers);
  std::vector<TriangleMeasure> measures;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    measures.push_back({ TriangleSlack::from(numbers.ofEntries[i]), numbers.longestSides[i],
      numbers.ofVertices[i] });
  }
  return measures;
}

TriangleMeasure measureOf(const ThreeCorners& t)
{
  return measuresOf({ t })[0];
}

/** How much less a slack may become: it has 8 significant bits, of which the last tells whether the
 * triangle is thin. */
double mostOff(double slack)
{
  return std::abs(slack) / 64.0;
}

/** A triangle of about a size, of which two corners may be far nearer. */
ThreeCorners randomTriangle(double width, int i, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&](double size) {
    return size * Vector3{ number(random), number(random), number(random) };
  };
  ThreeCorners t{ vector(1.0), vector(1.0), {} };
  t[2] = t[0] + (i % 2) * 0.4 * (t[1] - t[0]) + vector(width);
  std::rotate(t.begin(), t.begin() + i % 3, t.end());
  return t;
}

}

TEST(TriangleMeasure, IsRoundedToTheSafeSide)
{
  const std::vector<double> slacks{ 2.0 * 2.4 - 5.0, -4.0, 0.0 };
  const std::vector<double> longestSides{ 5.0, 4.0, 0.0 };
  const std::vector<double> margins{ labelMargin(5.0, 2.4), 6.0 * 4.0, 0.0 };
  for (std::size_t t = 0; t < Triangles.size(); ++t)
  {
    const TriangleMeasure measure = measureOf(Triangles[t]);
    EXPECT_LT(measure.slack.value(), slacks[t]);
    EXPECT_GT(measure.slack.value(), slacks[t] - mostOff(slacks[t]) - 1e-6);
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
  for (int i = 0; i < 20000; ++i)
  {
    const ThreeCorners t = randomTriangle(std::pow(10.0, -i % 13), i, random);
    const double longest = std::max({ norm(t[1] - t[0]), norm(t[2] - t[1]), norm(t[0] - t[2]) });
    const double height = norm(cross(t[1] - t[0], t[2] - t[0])) / longest;
    const TriangleMeasure measure = measureOf(t);
    ASSERT_LT(measure.slack.value(), 2.0 * height - longest);
    ASSERT_GT(measure.slack.value(),
      2.0 * height - longest - mostOff(2.0 * height - longest) - 4e-7 * longest);
    ASSERT_GT(measure.longestSide, longest);
    ASSERT_NEAR(measure.longestSide, longest, 4e-7 * longest);
  }
}

TEST(TriangleMeasure, LongestSideIsAnyOfThree)
{
  const auto [a, b, c] = Triangles[0];
  for (const ThreeCorners& turned :
    { ThreeCorners{ a, b, c }, ThreeCorners{ b, c, a }, ThreeCorners{ c, a, b } })
  {
    EXPECT_NEAR(measureOf(turned).longestSide, 5.0, 1e-6);
  }
}

TEST(TriangleMeasure, ThinIsLessThanAQuarterOfTheLongestSideHigh)
{
  EXPECT_FALSE(measureOf(Triangles[0]).isThin());
  EXPECT_TRUE(measureOf(Triangles[1]).isThin());
  // 4 long, and a little higher than 1 or lower.
  const auto flat = [](double height) -> ThreeCorners {
    return { { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 1.0, height, 0.0 } } };
  };
  const std::vector<TriangleMeasure> two = measuresOf({ flat(1.01), flat(0.99) });
  EXPECT_FALSE(two[0].isThin());
  EXPECT_TRUE(two[1].isThin());
}

// However many there are, wherever one is among them, by two or by four at once.
TEST(TriangleMeasure, IsTheSameAmongOthers)
{
  std::mt19937 random(2);
  std::vector<ThreeCorners> all = Triangles;
  for (int i = 0; all.size() < TriangleNumbers::Most; ++i)
  {
    all.push_back(randomTriangle(std::pow(10.0, -i % 13), i, random));
  }
  std::vector<TriangleMeasure> alone;
  for (const ThreeCorners& t : all)
  {
    alone.push_back(measureOf(t));
  }
  for (const bool mayUseQuads : { false, true })
  {
    for (std::size_t count = 1; count <= all.size(); ++count)
    {
      const std::vector<TriangleMeasure> measures =
        measuresOf({ all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count) }, mayUseQuads);
      for (std::size_t t = 0; t < count; ++t)
      {
        ASSERT_EQ(measures[t].slack.stored(), alone[t].slack.stored());
        ASSERT_EQ(measures[t].longestSide, alone[t].longestSide);
        ASSERT_EQ(measures[t].margin, alone[t].margin);
      }
    }
  }
}
