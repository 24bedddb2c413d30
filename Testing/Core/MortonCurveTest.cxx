// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Places along the curve, by the bits of three coordinates in turn.

#include "mesh/MortonCurve.h"

#include <gtest/gtest.h>

#include <random>

using namespace geodesic;

TEST(MortonCurve, LeadingAndOtherBitsAreThoseOfTheCode)
{
  BoundingBox box;
  box.add({ -1.0, 2.0, 5.0 });
  box.add({ 3.0, 6.0, 8.0 });
  const MortonCurve curve(box);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 10000; ++i)
  {
    const Vector3 point{ -1.0 + 4.0 * part(random), 2.0 + 4.0 * part(random),
      5.0 + 3.0 * part(random) };
    ASSERT_EQ(curve.leadingBitsOf(point), curve.codeOf(point) >> 31);
    ASSERT_EQ(curve.otherBitsOf(point), curve.codeOf(point) & 0x7fffffffu);
  }
  for (const Vector3& corner : { box.low, box.high })
  {
    EXPECT_EQ(curve.leadingBitsOf(corner), curve.codeOf(corner) >> 31);
    EXPECT_EQ(curve.otherBitsOf(corner), curve.codeOf(corner) & 0x7fffffffu);
  }
  EXPECT_EQ(curve.codeOf(box.low), 0u);
}
