// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds of runs of triangles against the triangles themselves, by CGAL, and against formulas on
// the sphere.

#include "search/BvhBounds.h"
#include "ExactDistances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Corners, three a triangle. */
using Corners = std::vector<Vector3>;

Vector3 randomVector(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double x = uniform(random);
  const double y = uniform(random);
  return { x, y, uniform(random) };
}

double distanceTo(const Corners& corners, const Vector3& query)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    least = std::min(least, distanceToTriangle(corners[i], corners[i + 1], corners[i + 2], query));
  }
  return least;
}

FourBvhBounds::SquaredDistances squaredDistances(const BvhBounds& bounds, const Vector3& query)
{
  FourBvhBounds four;
  for (std::size_t run = 0; run < FourBvhBounds::Runs; ++run)
  {
    four.set(run, bounds);
  }
  return four.squaredDistances(query);
}

void expectNothingNearer(const BvhBounds& bounds, const Corners& corners, std::mt19937& random)
{
  for (double reach : { 0.1, 1.0, 10.0 })
  {
    for (int i = 0; i < 20; ++i)
    {
      const Vector3 query = reach * randomVector(random);
      const double truth = distanceTo(corners, query);
      for (double least : squaredDistances(bounds, query).least)
      {
        EXPECT_LE(std::sqrt(least), truth + 1e-12);
      }
    }
  }
}

/** Small triangles that touch the unit sphere, with the circles round them within an angle. */
Corners capOfSphere(const Vector3& direction, double angle, std::mt19937& random)
{
  const Vector3 middle = (1.0 / norm(direction)) * direction;
  const auto anyWhere = [&]
  {
    for (;;)
    {
      const Vector3 p = middle + angle * randomVector(random);
      const Vector3 onSphere = (1.0 / norm(p)) * p;
      if (std::acos(std::min(dot(onSphere, middle), 1.0)) < angle)
      {
        return onSphere;
      }
    }
  };
  Corners corners;
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 a = anyWhere();
    Vector3 b = anyWhere();
    const Vector3 c = anyWhere();
    // Normals point outwards.
    const bool isOutwards = dot(cross(b - a, c - a), a) > 0.0;
    corners.insert(corners.end(), { a, isOutwards ? b : c, isOutwards ? c : b });
  }
  return corners;
}

}

TEST(BvhBounds, NothingOfARunIsNearer)
{
  std::mt19937 random(5);
  for (double flatness : { 0.0, 1e-6, 0.1, 1.0 })
  {
    std::vector<BvhBounds> runs;
    Corners all;
    for (int run = 0; run < 4; ++run)
    {
      const Vector3 middle = randomVector(random);
      Corners corners;
      for (int i = 0; i < 12; ++i)
      {
        const Vector3 x = randomVector(random);
        corners.push_back(middle + 0.3 * Vector3{ x.x, x.y, flatness * x.z + 0.5 * x.x });
      }
      runs.push_back(BvhBounds::ofTriangles(corners));
      expectNothingNearer(runs.back(), corners, random);
      all.insert(all.end(), corners.begin(), corners.end());
    }
    expectNothingNearer(BvhBounds::ofRuns(runs), all, random);
    expectNothingNearer(BvhBounds::ofTriangles(all), all, random);
  }
}

// A run of one triangle twice, with opposite normals.
TEST(BvhBounds, NormalsMayCancel)
{
  std::mt19937 random(6);
  const Vector3 a = randomVector(random);
  const Vector3 b = randomVector(random);
  const Vector3 c = randomVector(random);
  const Corners corners{ a, b, c, a, c, b };
  const BvhBounds bounds = BvhBounds::ofTriangles(corners);
  EXPECT_EQ(bounds.axis(), Vector3());
  expectNothingNearer(bounds, corners, random);
  const std::vector<BvhBounds> runs{ bounds, bounds };
  expectNothingNearer(BvhBounds::ofRuns(runs), corners, random);
}

// A cap of the angle s lies in a cylinder of the height s^2 / 2, so that squares of distances are
// known up to some s^2. A box that is askew is about s high.
TEST(BvhBounds, ASmoothRunIsBoundedToSecondOrder)
{
  std::mt19937 random(8);
  const Vector3 middle{ 1.0, 2.0, 3.0 };
  const Vector3 besides{ 3.0, 0.0, -1.0 };
  for (double angle : { 0.1, 0.03, 0.01 })
  {
    std::vector<BvhBounds> runs;
    Corners all;
    for (int i = 0; i < 4; ++i)
    {
      const Corners corners = capOfSphere(middle + angle * randomVector(random), angle, random);
      runs.push_back(BvhBounds::ofTriangles(corners));
      all.insert(all.end(), corners.begin(), corners.end());
    }
    for (double radius : { 0.3, 1.5 })
    {
      const Vector3 towards = (1.0 / norm(middle)) * middle + 4.0 * angle / norm(besides) * besides;
      const Vector3 query = radius / norm(towards) * towards;
      const double truth = distanceTo(all, query);
      const double allowed = 5.0 * angle * angle;
      EXPECT_NEAR(
        squaredDistances(BvhBounds::ofTriangles(all), query).least[0], truth * truth, allowed);
      EXPECT_NEAR(
        squaredDistances(BvhBounds::ofRuns(runs), query).least[0], truth * truth, 2.0 * allowed);
    }
  }
}

TEST(BvhBounds, EachRunHasItsOwn)
{
  std::mt19937 random(9);
  FourBvhBounds four;
  std::vector<BvhBounds> runs;
  for (std::size_t run = 0; run < FourBvhBounds::Runs; ++run)
  {
    Corners corners(6);
    std::generate(corners.begin(), corners.end(), [&] { return randomVector(random); });
    runs.push_back(BvhBounds::ofTriangles(corners));
    four.set(run, runs.back());
  }
  const Vector3 query{ 1.0, 2.0, -3.0 };
  const auto [least, toCentre] = four.squaredDistances(query);
  for (std::size_t run = 0; run < FourBvhBounds::Runs; ++run)
  {
    EXPECT_EQ(least[run], squaredDistances(runs[run], query).least[0]);
    const Vector3 x = query - runs[run].centre();
    EXPECT_NEAR(toCentre[run], dot(x, x), 1e-12);
    EXPECT_EQ(four.low(run)[1], runs[run].low[1]);
    EXPECT_EQ(four.high(run)[2], runs[run].high[2]);
  }
}
