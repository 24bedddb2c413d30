// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The shorter side of a bend at a vertex whose faces are one fan, against sums of angles both ways.

#include "path/VertexFan.h"
#include "Solving.h"
#include "mesh/SimpleFan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** A vertex at 0, point 0, with a fan of faces between points 1, 2, 3 and so on, of which the last
 * and the first may have a face, too. */
struct TestedFan
{
  Surface surface;
  Index size;
  bool isClosed;

  Index pointAfter(Index point) const { return point == this->size ? 1 : point + 1; }
  /** The number of the face ahead of a point. */
  std::size_t faceAfter(Index point) const { return point - 1; }
  bool hasFaceAfter(Index point) const { return this->isClosed || point < this->size; }
};

TestedFan randomTestedFan(std::mt19937& random)
{
  TestedFan fan;
  fan.size = std::uniform_int_distribution<Index>(3, 9)(random);
  fan.isClosed = std::bernoulli_distribution()(random);
  std::normal_distribution<double> normal;
  // Some are as narrow as a needle seen from its end, some bend to and fro.
  const double shake = std::uniform_real_distribution<double>(0.0, 1.0)(random);
  fan.surface.points.push_back({});
  for (Index i = 0; i < fan.size; ++i)
  {
    const double turn = 2.0 * std::numbers::pi * i / fan.size;
    const double x = std::cos(turn) + shake * normal(random);
    const double y = std::sin(turn) + shake * normal(random);
    fan.surface.points.push_back({ x, y, shake * normal(random) });
  }
  for (Index point = 1; point <= fan.size; ++point)
  {
    if (fan.hasFaceAfter(point))
    {
      fan.surface.triangles.push_back({ 0, point, fan.pointAfter(point) });
    }
  }
  return fan;
}

/** A direction from the centre of a fan: to one of its points, or into the face ahead of it. */
struct Direction
{
  Index point;
  double fraction;

  Vector3 in(const TestedFan& fan) const
  {
    return (1.0 - this->fraction) * fan.surface.points[this->point] +
      this->fraction * fan.surface.points[fan.pointAfter(this->point)];
  }
};

double angle(const Vector3& p, const Vector3& q)
{
  return std::atan2(norm(cross(p, q)), dot(p, q));
}

/** The angle from one direction ahead to another one; infinite if no way leads there. */
double angleAhead(const TestedFan& fan, const std::vector<std::uint8_t>& closed, const Direction& a,
  const Direction& b)
{
  double sum = 0.0;
  Vector3 at = a.in(fan);
  const auto turn = [&](Index point, const Vector3& next)
  {
    const bool isOpen = fan.hasFaceAfter(point) && closed[fan.faceAfter(point)] == 0;
    sum += isOpen ? angle(at, next) : std::numeric_limits<double>::infinity();
    at = next;
  };
  Index point = a.point;
  for (bool isFirst = a.fraction > 0.0; point != b.point || isFirst; isFirst = false)
  {
    turn(point, fan.surface.points[fan.pointAfter(point)]);
    point = fan.pointAfter(point);
  }
  if (b.fraction > 0.0)
  {
    turn(point, b.in(fan));
  }
  return sum;
}

}

TEST(VertexFan, FindsTheSideWithTheSmallerAngle)
{
  std::mt19937 random(3);
  int found = 0;
  for (int test = 0; test < 20000; ++test)
  {
    const TestedFan fan = randomTestedFan(random);
    std::vector<std::uint8_t> closed(fan.surface.triangles.size());
    for (std::uint8_t& flag : closed)
    {
      flag = std::bernoulli_distribution(0.1)(random) ? 1 : 0;
    }
    const auto anyDirection = [&]
    {
      const bool isInFace = std::bernoulli_distribution()(random);
      const Index last = fan.isClosed || !isInFace ? fan.size : fan.size - 1;
      return Direction{ std::uniform_int_distribution<Index>(1, last)(random),
        isInFace ? std::uniform_real_distribution<double>(0.1, 0.9)(random) : 0.0 };
    };
    const Direction from = anyDirection();
    const Direction to = anyDirection();
    if (from.point == to.point && from.fraction > 0.0 && to.fraction > 0.0)
    {
      continue;
    }

    const auto mesh = meshOf(fan.surface);
    std::vector<std::uint8_t> closedOfMesh(closed.size());
    for (Index triangle = 0; triangle < closed.size(); ++triangle)
    {
      closedOfMesh[triangle] = closed[mesh->sourceOfTriangle(triangle)];
    }
    SolveOptions options;
    options.closedTriangles = closedOfMesh;
    SearchProgress progress(options);
    const WeightedMesh weighted(*mesh, options, progress);
    const auto at = [&](Index point) { return mesh->vertexOfPoint(point); };
    const auto pathPoint = [&](const Direction& direction)
    {
      return direction.fraction > 0.0 ? PathPoint::onEdge(at(direction.point),
                                          at(fan.pointAfter(direction.point)), direction.fraction)
                                      : PathPoint::atVertex(at(direction.point));
    };
    ASSERT_TRUE(isSimpleFan(mesh->ring(at(0))));
    std::vector<Triangle> faces;
    const auto side =
      VertexFan(weighted, at(0)).appendShorterSide(pathPoint(from), pathPoint(to), faces);

    const double expected =
      std::min(angleAhead(fan, closed, from, to), angleAhead(fan, closed, to, from));
    if (std::abs(expected - std::numbers::pi) < 1e-6)
    {
      continue;
    }
    ASSERT_EQ(side.has_value(), expected < std::numbers::pi) << expected;
    if (!side)
    {
      EXPECT_TRUE(faces.empty());
      continue;
    }
    ++found;
    EXPECT_NEAR(*side, expected, 1e-12);
    // The faces lead from one direction to the other, each beside the next.
    if (!faces.empty())
    {
      EXPECT_TRUE(liesIn(pathPoint(from), faces.front()));
      EXPECT_TRUE(liesIn(pathPoint(to), faces.back()));
    }
    for (std::size_t i = 1; i < faces.size(); ++i)
    {
      EXPECT_EQ(std::count_if(faces[i].begin(), faces[i].end(),
                  [&](Index corner) {
                    return std::find(faces[i - 1].begin(), faces[i - 1].end(), corner) !=
                      faces[i - 1].end();
                  }),
        2);
    }
  }
  EXPECT_GT(found, 10000);
}

TEST(VertexFan, ASideOfExactly180DegreesIsASide)
{
  TestedFan fan{ { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } },
                   { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 } } },
    4, true };
  const auto mesh = meshOf(fan.surface);
  const SolveOptions options;
  SearchProgress progress(options);
  const WeightedMesh weighted(*mesh, options, progress);
  std::vector<Triangle> faces;
  const auto side = VertexFan(weighted, mesh->vertexOfPoint(0))
                      .appendShorterSide(PathPoint::atVertex(mesh->vertexOfPoint(1)),
                        PathPoint::atVertex(mesh->vertexOfPoint(3)), faces);
  ASSERT_TRUE(side.has_value());
  EXPECT_DOUBLE_EQ(*side, std::numbers::pi);
  EXPECT_EQ(faces.size(), 2u);
}
