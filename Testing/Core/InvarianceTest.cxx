// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// One field, whatever the numbering, the position in space and the unit of length.

#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "split/SplitMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

const std::vector<Index> seedPoints{ 17, 4000, 20000 };

class OnBunny : public ::testing::TestWithParam<int>
{
protected:
  /** Distances from the first seeds in the list, as many as the test's parameter says. */
  std::vector<double> solve(const Surface& surface, const std::vector<Index>& newId)
  {
    const auto mesh = meshOf(surface);
    std::vector<Seed> seeds;
    for (int s = 0; s < this->GetParam(); ++s)
    {
      seeds.push_back(seedAt(*mesh, newId.empty() ? seedPoints[s] : newId[seedPoints[s]]));
    }
    return distances<FastMarchingSolver>(mesh, seeds);
  }

  void expectSame(const std::vector<double>& d, const std::vector<Index>& newId, double scale)
  {
    std::size_t reached = 0;
    for (std::size_t i = 0; i < this->expected.size(); ++i)
    {
      const double value = d[newId.empty() ? i : newId[i]] / scale;
      if (std::isfinite(this->expected[i]) || std::isfinite(value))
      {
        ASSERT_NEAR(value, this->expected[i], 1e-9 * this->expected[i] + 1e-15);
        ++reached;
      }
    }
    EXPECT_GT(reached, 30000u);
  }

  const Surface& bunny = geodesic::testing::bunny();
  const std::vector<double> expected = solve(bunny, {});
};

}

TEST_P(OnBunny, ShufflingChangesNothing)
{
  for (unsigned seed : { 1u, 2u, 3u })
  {
    std::vector<Index> newId;
    const Surface other = shuffled(this->bunny, seed, newId);
    this->expectSame(this->solve(other, newId), newId, 1.0);
  }
}

TEST_P(OnBunny, ScalingScales)
{
  for (double scale : { 1e-6, 1e6 })
  {
    Surface other = this->bunny;
    for (Vector3& p : other.points)
    {
      p = scale * p;
    }
    this->expectSame(this->solve(other, {}), {}, scale);
  }
}

// Rotation rounds every coordinate; what rounding does to a nearly flat update is its square root.
TEST_P(OnBunny, RotatingChangesNothing)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  Surface other = this->bunny;
  for (Vector3& p : other.points)
  {
    const Vector3 q{ c * p.x - s * p.y, s * p.x + c * p.y, p.z };
    p = { q.x, c * q.y - s * q.z, s * q.y + c * q.z };
  }
  this->expectSame(this->solve(other, {}), {}, 1.0);
}

TEST_P(OnBunny, ReversingOrientationChangesNothing)
{
  Surface other = this->bunny;
  std::mt19937 random(5);
  for (Triangle& t : other.triangles)
  {
    if (random() % 2 == 0)
    {
      std::swap(t[0], t[1]);
    }
  }
  this->expectSame(this->solve(other, {}), {}, 1.0);
}

namespace
{

/**
 * Distances on the Bunny from ten seeds and a curve, at a cost that varies, with excluded points
 * and closed triangles, all at once.
 * @param newId      of its points on the surface
 * @param triangles  of the Bunny
 */
std::vector<double> withEverything(const Surface& surface, const std::vector<Index>& newId,
  const std::vector<Triangle>& triangles, bool mayUseQuads = true)
{
  const auto mesh = meshOf(surface);
  const auto vertexOf = [&](Index point) { return mesh->vertexOfPoint(newId[point]); };
  std::vector<Seed> seeds;
  for (Index s = 0; s < 10; ++s)
  {
    seeds.push_back(seedAt(*mesh, newId[triangles[6000 * s + 5][0]]));
  }
  const Triangle& t = triangles[33333];
  seeds.push_back(
    Seed::alongCurve({ mesh->pointAtVertex(vertexOf(t[0])), mesh->pointAtVertex(vertexOf(t[1])) }));
  std::vector<double> cost;
  for (const Vector3& p : mesh->positions())
  {
    cost.push_back(1.0 + 0.5 * std::sin(40.0 * p.x) + 10.0 * p.y);
  }
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices(), 0);
  for (Index i = 0; i < triangles.size(); i += 501)
  {
    excluded[vertexOf(triangles[i][0])] = 1;
  }
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles(), 0);
  for (Index i = 0; i < closed.size(); ++i)
  {
    const Vector3 centre = mesh->positionOf({ i, { 1.0 / 3, 1.0 / 3, 1.0 / 3 } });
    closed[i] = centre.y > 0.08 && centre.y < 0.09;
  }
  SolveOptions options;
  options.cost = cost;
  options.excluded = excluded;
  options.closedTriangles = closed;
  FastMarchingSolver solver(mesh, mayUseQuads);
  const DistanceField& field = solver.solve(seeds, options);
  std::vector<double> distances;
  for (Index point : newId)
  {
    const Index vertex = mesh->vertexOfPoint(point);
    distances.push_back(vertex == NoIndex ? DistanceField::Unreached : field.distance(vertex));
  }
  return distances;
}

std::vector<Index> identity(std::size_t size)
{
  std::vector<Index> same(size);
  std::iota(same.begin(), same.end(), 0u);
  return same;
}

}

TEST(WithEverything, ShufflingChangesNothing)
{
  const Surface& bunny = geodesic::testing::bunny();
  const auto expected = withEverything(bunny, identity(bunny.points.size()), bunny.triangles);
  std::vector<Index> newId;
  const Surface other = shuffled(bunny, 11, newId);
  const auto d = withEverything(other, newId, bunny.triangles);
  std::size_t reached = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(d[i]), std::isfinite(expected[i]));
    if (std::isfinite(expected[i]))
    {
      ASSERT_NEAR(d[i], expected[i], 1e-9 * expected[i]);
      ++reached;
    }
  }
  EXPECT_GT(reached, 30000u);
}

// Two or four numbers at once, by what the processor can.
TEST(WithEverything, TwoAndFourAtOnceGiveTheSame)
{
  const Surface& bunny = geodesic::testing::bunny();
  const auto same = identity(bunny.points.size());
  EXPECT_EQ(withEverything(bunny, same, bunny.triangles, false),
    withEverything(bunny, same, bunny.triangles));
  const auto mesh = meshOf(bunny);
  const Seed seed = seedAt(*mesh, seedPoints[0]);
  FastMarchingSolver byTwo(mesh, false);
  FastMarchingSolver byFour(mesh);
  const auto expected = byTwo.solve({ &seed, 1 }).distances();
  const auto found = byFour.solve({ &seed, 1 }).distances();
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), found.begin(), found.end()));
}

// A curve and a wall across faces, both joined and split anew on the shuffled surface.
TEST(WithSplitFaces, ShufflingChangesNothing)
{
  const Surface& spot = geodesic::testing::spot();
  const auto solve = [&](const Surface& surface, const std::vector<Index>& newId)
  {
    const auto mesh = meshOf(surface);
    FastMarchingSolver joiner(mesh);
    const auto lineNear = [&](const std::vector<Vector3>& positions)
    {
      std::vector<SurfacePoint> points;
      for (const Vector3& position : positions)
      {
        points.push_back(seedNear(mesh, position).points[0]);
      }
      return joinedCurve(joiner, points, "Line");
    };
    const std::vector<SurfacePath> curves{ lineNear({ { 0.3, 0.4, -0.2 }, { 0.4, -0.3, 0.1 } }) };
    const std::vector<SurfacePath> cuts{ lineNear(
      { { -0.5, 0.5, 0.3 }, { -0.4, 0.0, 0.4 }, { -0.5, -0.5, 0.2 } }) };
    const SplitMesh split(mesh, curves, cuts);
    const auto excluded = split.excluded({});
    SolveOptions options;
    options.excluded = excluded;
    const Seed seed = Seed::alongCurve(split.curve(0));
    FastMarchingSolver solver(split.mesh());
    const DistanceField& field = solver.solve({ &seed, 1 }, options);
    std::vector<double> distances;
    for (Index point : newId)
    {
      distances.push_back(field.distance(split.vertexOf(mesh->vertexOfPoint(point))));
    }
    return distances;
  };
  std::vector<Index> newId = identity(spot.points.size());
  const std::vector<double> expected = solve(spot, newId);
  const Surface other = shuffled(spot, 13, newId);
  const std::vector<double> d = solve(other, newId);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(d[i]), std::isfinite(expected[i])) << i;
    if (std::isfinite(expected[i]))
    {
      ASSERT_NEAR(d[i], expected[i], 1e-9 * expected[i]) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OnBunny, ::testing::Values(1, 3));
