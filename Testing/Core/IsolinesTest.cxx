// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves of constant distance against formulas: circles and stadiums on planes, cylinders and
// cones.

#include "path/Isolines.h"
#include "IsolineShape.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/FaceField.h"
#include "search/ClosestPointTree.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

std::vector<Isoline> linesOf(
  const TriangleMesh& mesh, const std::vector<double>& values, const std::vector<double>& levels)
{
  return isolines(mesh, EdgeTable(mesh), values, {}, levels, [] { return true; });
}

/** The distance from seeds at each vertex. */
std::vector<double> fieldOf(
  const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Seed>& seeds)
{
  FastMarchingSolver solver(mesh);
  const auto distances = solver.solve(seeds, {}).distances();
  return { distances.begin(), distances.end() };
}

Seed segment(
  const std::shared_ptr<const TriangleMesh>& mesh, Index cells, Index row, Index from, Index to)
{
  std::vector<SurfacePoint> points;
  for (Index i = from; i <= to; ++i)
  {
    points.push_back(mesh->pointAtVertex(mesh->vertexOfPoint(row * (cells + 1) + i)));
  }
  return Seed::alongCurve(points);
}

}

// On a plane fast marching is exact, and so are the circles: in the seed's face, across its edges,
// and far away.
TEST(Isolines, RoundAPointOnAPlaneAreCircles)
{
  const Vector3 seeds[] = { { 0.513, 0.478, 0 }, { 0.5, 0.5, 0 }, { 0.525, 0.5, 0 } };
  for (const Vector3& seed : seeds)
  {
    for (const auto& surface :
      { planeGrid(20, 20, 1.0, 1.0), jitteredGrid(20, 20, 1.0, 1.0, 0.3, 4) })
    {
      const auto mesh = meshOf(surface);
      const auto field = fieldOf(mesh, { seedNear(mesh, seed) });
      const Vector3 centre = mesh->positionOf(seedNear(mesh, seed).points[0]);
      for (const double radius : { 0.001, 0.01, 0.03, 0.1, 0.25, 0.45 })
      {
        const auto lines = linesOf(*mesh, field, { radius });
        ASSERT_EQ(lines.size(), 1u) << radius;
        EXPECT_TRUE(isClosed(lines[0]));
        EXPECT_NEAR(lines[0].length, 2.0 * std::numbers::pi * radius, 1e-9) << radius;
        EXPECT_NEAR(lines[0].area, std::numbers::pi * radius * radius, 1e-9) << radius;
        for (const Vector3& p : lines[0].points)
        {
          ASSERT_NEAR(norm(p - centre), radius, 1e-9);
        }
      }
    }
  }
}

// Two straight sides and two half circles. The straight front and the round one meet inside of
// faces, where the field is neither; so this is exact to the size of these.
TEST(Isolines, RoundALineAreStadiums)
{
  const Index cells = 80;
  const auto mesh = meshOf(planeGrid(cells, cells, 1.0, 1.0));
  const auto field = fieldOf(mesh, { segment(mesh, cells, 40, 28, 52) });
  const double length = 24.0 / cells;
  for (const double level : { 0.02, 0.11, 0.3 })
  {
    const auto lines = linesOf(*mesh, field, { level });
    ASSERT_EQ(lines.size(), 1u) << level;
    EXPECT_TRUE(isClosed(lines[0]));
    EXPECT_NEAR(lines[0].length, 2.0 * length + 2.0 * std::numbers::pi * level, 2e-3) << level;
    EXPECT_NEAR(lines[0].area, 2.0 * length * level + std::numbers::pi * level * level, 1e-3)
      << level;
  }
}

// Up to the half of the circumference, where the front meets itself.
TEST(Isolines, OnACylinderAreCirclesRolledUp)
{
  const auto mesh = meshOf(cylinder(48, 60, 0.5, 3.0));
  // The side of the polygon is what fast marching sees.
  const double around = 48.0 * 2.0 * 0.5 * std::sin(std::numbers::pi / 48.0);
  const auto field = fieldOf(mesh, { seedNear(mesh, { 0.5, 0.02, 1.51 }) });
  const double radius = 0.3 * around;
  const auto lines = linesOf(*mesh, field, { radius });
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].length, 2.0 * std::numbers::pi * radius, 1e-6);
  EXPECT_NEAR(lines[0].area, std::numbers::pi * radius * radius, 1e-6);
  // Beyond it the front has met itself, and there are two curves, above and below.
  EXPECT_EQ(linesOf(*mesh, field, { 0.6 * around }).size(), 2u);
}

TEST(Isolines, RoundTheApexOfAConeAreItsCircles)
{
  const Index around = 60;
  const double radius = 0.6;
  const auto mesh = meshOf(cone(around, 20, radius, 1.0));
  const auto field = fieldOf(mesh, { Seed::atPoint(mesh->pointAtVertex(mesh->vertexOfPoint(0))) });
  // The angle of the flat faces at the apex.
  const double angle = around * 2.0 * std::asin(radius * std::sin(std::numbers::pi / around));
  for (const double level : { 0.025, 0.33, 0.71 })
  {
    const auto lines = linesOf(*mesh, field, { level });
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(isClosed(lines[0]));
    EXPECT_NEAR(lines[0].length, angle * level, 1e-6);
    EXPECT_NEAR(lines[0].area, 0.5 * angle * level * level, 1e-6);
  }
}

TEST(Isolines, ThroughVerticesAreWholeCurves)
{
  const auto mesh = meshOf(planeGrid(20, 20, 1.0, 1.0));
  const Vector3 centre{ 0.5, 0.5, 0 };
  const auto field = fieldOf(mesh, { seedNear(mesh, centre) });
  for (const double value : { 0.05, 0.1, 0.25, 0.35 })
  {
    // The very value of a vertex.
    double level = 0.0;
    for (const double v : field)
    {
      level = std::abs(v - value) < std::abs(level - value) ? v : level;
    }
    const auto lines = linesOf(*mesh, field, { level });
    ASSERT_EQ(lines.size(), 1u) << level;
    EXPECT_TRUE(isClosed(lines[0]));
    EXPECT_NEAR(lines[0].length, 2.0 * std::numbers::pi * level, 1e-9);
    EXPECT_NEAR(lines[0].area, std::numbers::pi * level * level, 1e-9);
  }
}

TEST(Isolines, EndWhereNothingIsKnownAndWhereThereIsNoSuchDistance)
{
  const auto mesh = meshOf(planeGrid(20, 20, 1.0, 1.0));
  auto field = fieldOf(mesh, { seedNear(mesh, { 0.513, 0.478, 0 }) });
  EXPECT_TRUE(linesOf(*mesh, field, { 0.0 }).empty());
  EXPECT_TRUE(linesOf(*mesh, field, { 5.0, 7.0 }).empty());
  EXPECT_TRUE(linesOf(*mesh, field, { -0.1 }).empty());
  // At the border.
  for (const Isoline& line : linesOf(*mesh, field, { 0.6 }))
  {
    EXPECT_FALSE(isClosed(line));
    for (const Vector3& p : { line.points.front(), line.points.back() })
    {
      EXPECT_NEAR(std::min({ p.x, p.y, 1.0 - p.x, 1.0 - p.y }), 0.0, 1e-12);
    }
  }
  EXPECT_EQ(linesOf(*mesh, field, { 0.6 }).size(), 4u);
  for (Index v = 0; v < field.size(); ++v)
  {
    field[v] = mesh->position(v).x > 0.6 ? NaN : field[v];
  }
  const auto cut = linesOf(*mesh, field, { 0.25 });
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_FALSE(isClosed(cut[0]));
  EXPECT_NEAR(cut[0].points.front().x, 0.6, 1e-12);
}

// The plus and the minus side of a straight line.
TEST(Isolines, OfASignedFieldAreOnBothSidesAndOnTheLine)
{
  const auto mesh = meshOf(jitteredGrid(20, 20, 1.0, 1.0, 0.3, 4));
  std::vector<double> field;
  for (const Vector3& p : mesh->positions())
  {
    field.push_back(p.y - 0.47);
  }
  for (const double level : { -0.2, -0.01, 0.0, 0.3 })
  {
    const auto lines = linesOf(*mesh, field, { level });
    ASSERT_EQ(lines.size(), 1u) << level;
    EXPECT_NEAR(lines[0].length, 1.0, 1e-9);
    EXPECT_NEAR(lines[0].area, 0.47 + level, 1e-9);
  }
  // Minus inside of a point's circle, as a field far from its seed has it.
  const Vector3 centre{ 0.5, 0.5, 0 };
  field.clear();
  for (const Vector3& p : mesh->positions())
  {
    field.push_back(-norm(p - centre));
  }
  const auto lines = linesOf(*mesh, field, { -0.25 });
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].length, 2.0 * std::numbers::pi * 0.25, 1e-9);
  EXPECT_NEAR(lines[0].area, 1.0 - std::numbers::pi * 0.25 * 0.25, 1e-9);
}

// Three half planes at one edge: the curve branches there.
TEST(Isolines, EndAtEdgesOfThreeFaces)
{
  const Surface book{ { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 1, 4 } } };
  const auto mesh = meshOf(book);
  std::vector<double> field;
  for (const Vector3& p : mesh->positions())
  {
    field.push_back(norm(p - Vector3{ 0, 0, 0 }));
  }
  const auto lines = linesOf(*mesh, field, { 0.5 });
  ASSERT_EQ(lines.size(), 3u);
  for (const Isoline& line : lines)
  {
    EXPECT_NEAR(line.length, 0.25 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(line.area, 3.0 * std::numbers::pi / 16.0, 1e-9);
  }
}

// The truth of the area is the sum over the parts: of all curves of a level that have their own
// part below it. Curves are closed but at borders, on all kinds of meshes.
TEST(Isolines, OnMeshesOfAllKindsAreWholeAndInOrder)
{
  for (unsigned seed = 0; seed < 120; ++seed)
  {
    const RandomCase random = randomCase(seed, { 3, false, false });
    const auto field = fieldOf(random.mesh, random.seeds);
    double largest = 0.0;
    for (const double v : field)
    {
      largest = std::isfinite(v) ? std::max(largest, v) : largest;
    }
    const EdgeTable edges(*random.mesh);
    const ClosestPointTree tree(random.mesh);
    for (const double part : { 0.05, 0.4, 0.8 })
    {
      for (const Isoline& line : linesOf(*random.mesh, field, { part * largest }))
      {
        ASSERT_GE(line.points.size(), 2u);
        ASSERT_TRUE(std::isfinite(line.length) && std::isfinite(line.area));
        EXPECT_GT(line.length, 0.0);
        EXPECT_GT(line.area, -1e-9 * largest * largest) << random.description();
        double chords = 0.0;
        for (std::size_t i = 1; i < line.points.size(); ++i)
        {
          chords += norm(line.points[i] - line.points[i - 1]);
        }
        EXPECT_LT(chords, line.length * (1.0 + 1e-3)) << random.description();
        EXPECT_GT(chords, line.length * (1.0 - 1e-2)) << random.description();
      }
    }
  }
}

TEST(Isolines, OfVeryManyLevelsTakeATimeInProportion)
{
  const auto mesh = meshOf(planeGrid(12, 12, 1.0, 1.0));
  const auto field = fieldOf(mesh, { seedNear(mesh, { 0.513, 0.478, 0 }) });
  std::vector<double> levels;
  for (int i = 1; i <= 10000; ++i)
  {
    levels.push_back(0.4 * i / 10000.0);
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto lines = linesOf(*mesh, field, levels);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds", std::to_string(time.count()));
  EXPECT_EQ(lines.size(), levels.size());
}
