// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Points along the curve, also where very many of them are in a few of its first cells.

#include "mesh/SpatialOrder.h"
#include "mesh/MortonCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

using namespace geodesic;

namespace
{

/** Clusters of 1 to some hundred points, far apart, by how many there are; every @p copiesEach-th
 * point has a copy. */
std::vector<Vector3> clusters(int copiesEach)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&](double size) {
    return size * Vector3{ number(random), number(random), number(random) };
  };
  std::vector<Vector3> points;
  for (int size = 1; size < 600; size += 1 + size / 20)
  {
    const Vector3 centre = vector(1.0);
    for (int i = 0; i < size; ++i)
    {
      points.push_back(centre + vector(1e-5));
      if (copiesEach > 0 && i % copiesEach == 0)
      {
        points.push_back(points.back());
      }
    }
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

std::vector<Index> sortedByCode(
  const std::vector<Vector3>& points, const std::vector<std::uint8_t>& used)
{
  BoundingBox box;
  std::vector<Index> order;
  for (Index i = 0; i < points.size(); ++i)
  {
    if (used[i])
    {
      box.add(points[i]);
      order.push_back(i);
    }
  }
  const MortonCurve curve(box);
  const auto key = [&](Index i)
  { return std::tuple(curve.codeOf(points[i]), points[i].x, points[i].y, points[i].z, i); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  return order;
}

}

TEST(SpatialOrder, IsByTheWholeCodeThenByCoordinates)
{
  for (const int copiesEach : { 0, 7, 1 })
  {
    const std::vector<Vector3> points = clusters(copiesEach);
    std::vector<std::uint8_t> used(points.size(), 1);
    for (std::size_t i = 0; i < used.size(); i += 5)
    {
      used[i] = 0;
    }
    const std::vector<Index> expected = sortedByCode(points, used);
    for (const unsigned threads : { 1, 2, 5 })
    {
      const BulkVector<Index> order = spatialOrder(points, used, ThreadTeam(threads));
      ASSERT_EQ(std::vector<Index>(order.begin(), order.end()), expected)
        << copiesEach << ", " << threads;
    }
  }
}
