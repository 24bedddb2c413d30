// Sizes of triangles that are known, and what is made of them, which has to be on the safe side.

#include "TriangleBlock.h"
#include "LabelMargin.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

using namespace geodesic;

namespace
{

/** A triangle with sides of 3, 4 and 5, one of no height, and one that is a point. */
const std::vector<Vector3> Positions{ { 0.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, { 0.0, 0.0, 4.0 },
  { 0.0, 0.0, 1.0 }, { 0.0, 3.0, 0.0 } };
const std::vector<Triangle> Triangles{ { 0, 1, 2 }, { 2, 3, 0 }, { 1, 4, 1 } };

std::vector<TriangleMeasure> measuresOf(std::span<const Triangle> triangles)
{
  std::vector<TriangleMeasure> measures(triangles.size());
  TriangleBlock(triangles, Positions).measure(measures);
  return measures;
}

}

TEST(TriangleBlock, LengthsAreThoseOfAllSides)
{
  const TriangleBlock block(Triangles, Positions);
  EXPECT_DOUBLE_EQ(block.sumOfLengths(), 12.0 + 8.0 + 0.0);
  EXPECT_DOUBLE_EQ(block.longestSide(), 5.0);
  EXPECT_DOUBLE_EQ(TriangleBlock({ &Triangles[1], 1 }, Positions).longestSide(), 4.0);
}

TEST(TriangleBlock, MeasuresAreRoundedToTheSafeSide)
{
  const std::vector<TriangleMeasure> measures = measuresOf(Triangles);
  const std::vector<double> slacks{ 2.0 * 2.4 - 5.0, -4.0, 0.0 };
  const std::vector<double> longestSides{ 5.0, 4.0, 0.0 };
  const std::vector<double> margins{ labelMargin(5.0, 2.4), 5.0 * 4.0, 0.0 };
  for (std::size_t t = 0; t < Triangles.size(); ++t)
  {
    EXPECT_LT(measures[t].slack, slacks[t]);
    EXPECT_NEAR(measures[t].slack, slacks[t], 1e-6);
    EXPECT_GT(measures[t].longestSide, longestSides[t]);
    EXPECT_NEAR(measures[t].longestSide, longestSides[t], 1e-6);
    EXPECT_GT(measures[t].margin, margins[t]);
    EXPECT_NEAR(measures[t].margin, margins[t], 1e-5);
  }
}

TEST(TriangleBlock, ThinIsLessThanAQuarterOfTheLongestSideHigh)
{
  const std::vector<TriangleMeasure> measures = measuresOf(Triangles);
  EXPECT_FALSE(measures[0].isThin());
  EXPECT_TRUE(measures[1].isThin());
  // 4 long, and a little higher than 1 or lower.
  const std::vector<Vector3> flat{ { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 1.0, 1.01, 0.0 },
    { 1.0, 0.99, 0.0 } };
  const std::vector<Triangle> triangles{ { 0, 1, 2 }, { 0, 1, 3 } };
  std::vector<TriangleMeasure> two(2);
  TriangleBlock(triangles, flat).measure(two);
  EXPECT_FALSE(two[0].isThin());
  EXPECT_TRUE(two[1].isThin());
}

TEST(TriangleBlock, ATriangleIsMeasuredTheSameInEveryPlace)
{
  std::vector<Triangle> full;
  for (std::size_t i = 0; i < TriangleBlock::Size; ++i)
  {
    full.push_back(Triangles[i % Triangles.size()]);
  }
  const std::vector<TriangleMeasure> measures = measuresOf(full);
  for (std::size_t i = 0; i < full.size(); ++i)
  {
    const TriangleMeasure alone = measuresOf({ &full[i], 1 })[0];
    EXPECT_EQ(measures[i].slack, alone.slack);
    EXPECT_EQ(measures[i].longestSide, alone.longestSide);
    EXPECT_EQ(measures[i].margin, alone.margin);
  }
}
