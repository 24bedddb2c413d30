// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs of triangles are cut where the space filling curve jumps.

#include "search/BvhSplit.h"
#include "Solving.h"

#include <gtest/gtest.h>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

Surface moved(Surface surface, const Vector3& by)
{
  for (Vector3& p : surface.points)
  {
    p = p + by;
  }
  return surface;
}

}

TEST(BvhSplit, ARunIsCutBetweenPartsOfASurface)
{
  // 800 triangles, and 200 far from them.
  const auto mesh = meshOf(
    joined(planeGrid(20, 20, 1.0, 1.0), moved(planeGrid(10, 10, 0.5, 0.5), { 9.0, 8.0, 7.0 })));
  EXPECT_EQ(BvhSplit(*mesh).cut(0, 1000), 800u);
}

TEST(BvhSplit, PartsAreNotTooSmall)
{
  // 800 triangles, and 18 far from them.
  const auto mesh = meshOf(
    joined(planeGrid(20, 20, 1.0, 1.0), moved(planeGrid(3, 3, 0.5, 0.5), { 9.0, 8.0, 7.0 })));
  const BvhSplit cuts(*mesh);
  for (Index first : { 0u, 1u, 300u })
  {
    for (Index size : { 2u, 3u, 8u, 100u, 500u })
    {
      const Index cut = cuts.cut(first, first + size);
      EXPECT_GE(cut - first, std::max(size / 8, 1u));
      EXPECT_GE(first + size - cut, std::max(size / 8, 1u));
    }
  }
  const Index cut = cuts.cut(0, 818);
  EXPECT_LE(cut, 818u - 818u / 8u);
}

// All triangles round one point: the curve does not jump.
TEST(BvhSplit, WithoutAJumpTheMiddleIsCut)
{
  constexpr Index triangles = 64;
  Surface fan{ { { 0.0, 0.0, 0.0 } }, {} };
  for (Index i = 0; i <= triangles; ++i)
  {
    fan.points.push_back({ 1.0, static_cast<double>(i) / triangles, 0.0 });
  }
  for (Index i = 1; i <= triangles; ++i)
  {
    fan.triangles.push_back({ 0, i, i + 1 });
  }
  const BvhSplit cuts(*meshOf(fan));
  EXPECT_EQ(cuts.cut(0, triangles), triangles / 2);
  EXPECT_EQ(cuts.cut(10, 20), 15u);
}
