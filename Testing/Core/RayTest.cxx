// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays first meet a surface: spheres and planes, whose crossings are known.

#include "Solving.h"
#include "search/ClosestPointTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

Vector3 randomDirection(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return { x, y, normal(random) };
}

}

// The flat faces of the icosphere lie inside the unit sphere, by less than the square of their
// edge.
TEST(Ray, TheFrontOfASphereIsMetNotItsBack)
{
  const ClosestPointTree tree(meshOf(icosphere(5)));
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 d = randomDirection(random);
    const Vector3 outside = (-4.0 / norm(d)) * d;
    const auto found = tree.firstOnRay(outside, 7.0 * d);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, 3.0, 2e-3);
    EXPECT_LE(norm(cross(found->position, d)), 1e-9 * norm(d)) << "not on the ray";
    EXPECT_LT(tree.closestPoint(found->position).distance, 1e-12) << "not on the surface";
  }
}

// Every ray from inside a closed surface meets it; these go through its vertices and edges.
TEST(Ray, NoneSlipsBetweenTriangles)
{
  const Surface surface = icosphere(3);
  const ClosestPointTree tree(meshOf(surface));
  for (const Triangle& t : surface.triangles)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Vector3& a = surface.points[t[side]];
      const Vector3& b = surface.points[t[(side + 1) % 3]];
      EXPECT_TRUE(tree.firstOnRay({}, a));
      EXPECT_TRUE(tree.firstOnRay({}, a + b));
      EXPECT_TRUE(tree.firstOnRay({ 0.01, 0.02, -0.03 }, 0.3 * a + 0.7 * b));
    }
  }
}

TEST(Ray, AlongAnAxisAPlaneIsMetFromBothSidesAndBesideItNot)
{
  const ClosestPointTree tree(meshOf(planeGrid(8, 8, 1.0, 1.0)));
  for (const double x : { 0.0, 0.5, 1.0 })
  {
    const auto above = tree.firstOnRay({ x, 0.25, 2.0 }, { 0.0, 0.0, -1.0 });
    ASSERT_TRUE(above) << x;
    EXPECT_EQ(above->position, (Vector3{ x, 0.25, 0.0 }));
    EXPECT_EQ(above->distance, 2.0);
    EXPECT_TRUE(tree.firstOnRay({ x, 0.25, -2.0 }, { 0.0, 0.0, 5.0 })) << x;
  }
  EXPECT_FALSE(tree.firstOnRay({ 1.01, 0.25, 2.0 }, { 0.0, 0.0, -1.0 }));
  EXPECT_FALSE(tree.firstOnRay({ 0.5, 0.25, 2.0 }, { 0.0, 0.0, 1.0 })) << "behind the origin";
  EXPECT_FALSE(tree.firstOnRay({ 0.5, 0.25, 2.0 }, { 1.0, 0.0, 0.0 })) << "beside the plane";
}

TEST(Ray, IsAsGoodFarFromTheOrigin)
{
  const Vector3 shift{ 1e6, -2e6, 3e6 };
  Surface surface = icosphere(4);
  for (Vector3& p : surface.points)
  {
    p = p + shift;
  }
  const ClosestPointTree tree(meshOf(surface));
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 d = randomDirection(random);
    const auto found = tree.firstOnRay(shift - (3.0 / norm(d)) * d, d);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, 2.0, 1e-2);
  }
}

TEST(Ray, ASurfaceWithoutTrianglesIsMissed)
{
  EXPECT_FALSE(ClosestPointTree(meshOf({})).firstOnRay({}, { 1.0, 0.0, 0.0 }));
}
