// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey/LandmarkOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using namespace geodesic;

std::vector<Vector3> onSphere(std::size_t count)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Vector3> points;
  while (points.size() < count)
  {
    const double x = normal(random);
    const double y = normal(random);
    const double z = normal(random);
    const Vector3 point{ x, y, z };
    points.push_back((1.0 / norm(point)) * point);
  }
  return points;
}

/** The area that discs take, each round a landmark as far as the farthest one after it, in areas of
 * the sphere and for each landmark. */
double areaMarched(std::span<const Vector3> points, std::span<const std::size_t> order)
{
  double area = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    double least = 1.0;
    for (const std::size_t later : order.subspan(i))
    {
      least = std::min(least, dot(points[order[i]], points[later]));
    }
    area += 0.5 * (1.0 - least);
  }
  return area / static_cast<double>(order.size());
}

TEST(LandmarkOrder, NamesEachLandmarkOnce)
{
  for (const std::size_t count : { 0u, 1u, 2u, 100u })
  {
    std::vector<std::size_t> order = landmarkOrder(onSphere(count));
    ASSERT_EQ(order.size(), count);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_EQ(order[i], i);
    }
  }
}

TEST(LandmarkOrder, KeepsOrderWhereAllAreOnePoint)
{
  const std::vector<Vector3> points(5, Vector3{ 1.0, 2.0, 3.0 });
  EXPECT_EQ(landmarkOrder(points), (std::vector<std::size_t>{ 0, 1, 2, 3, 4 }));
}

// A cap of the part x of the sphere fits into a disc of the part 4 x (1 - x) round a point of its
// border: in the mean over x, 5/6.
TEST(LandmarkOrder, LeavesEverSmallerDiscs)
{
  const std::vector<Vector3> points = onSphere(1000);
  std::vector<std::size_t> asTheyCome(points.size());
  std::iota(asTheyCome.begin(), asTheyCome.end(), std::size_t{ 0 });
  EXPECT_GT(areaMarched(points, asTheyCome), 0.97);
  EXPECT_NEAR(areaMarched(points, landmarkOrder(points)), 5.0 / 6.0, 0.01);
}

}
