// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves and regions as seeds: the distance to all of them, not to their points.

#include "ExactDistances.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "search/ClosestPointTree.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

double toSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 side = b - a;
  const double t = std::clamp(dot(p - a, side) / dot(side, side), 0.0, 1.0);
  return norm(p - (a + t * side));
}

/** The curve along the row of points y = row / cells of a grid on the unit square. */
std::vector<SurfacePoint> rowOf(
  const TriangleMesh& mesh, Index cells, Index row, Index from, Index to)
{
  std::vector<SurfacePoint> points;
  for (Index i = from; i <= to; ++i)
  {
    points.push_back(mesh.pointAtVertex(mesh.vertexOfPoint(row * (cells + 1) + i)));
  }
  return points;
}

}

TEST(CurveSeed, BesideAStraightCurveTheFieldIsTheDistanceToIt)
{
  const Index cells = 64;
  const Surface plane = planeGrid(cells, cells, 1.0, 1.0);
  const auto mesh = meshOf(plane);
  const Seed curve = Seed::alongCurve(rowOf(*mesh, cells, 30, 16, 48));
  const auto d = distances<FastMarchingSolver>(mesh, { curve });
  const Vector3 a = plane.points[30 * (cells + 1) + 16];
  const Vector3 b = plane.points[30 * (cells + 1) + 48];
  double mean = 0.0;
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const Vector3& p = plane.points[i];
    const double truth = toSegment(p, a, b);
    const bool isFirstRing = std::abs(p.y - a.y) < 1.5 / cells && p.x >= a.x && p.x <= b.x;
    EXPECT_NEAR(d[i], truth, isFirstRing ? 1e-9 : 1e-3);
    mean += std::abs(d[i] - truth) / plane.points.size();
  }
  EXPECT_LT(mean, 1e-4);
}

// Through the middle of faces: each face's corners know the distance to the segment in it.
TEST(CurveSeed, ACurveMayLieInsideAFace)
{
  const Surface triangle{ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } };
  const auto mesh = meshOf(triangle);
  const auto a = seedNear(mesh, { 1, 1, 0 }).points[0];
  const auto b = seedNear(mesh, { 2, 1, 0 }).points[0];
  const auto d = distances<FastMarchingSolver>(mesh, { Seed::alongCurve({ a, b }) });
  EXPECT_NEAR(d[0], std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(d[1], std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(d[2], std::sqrt(10.0), 1e-12);
}

TEST(CurveSeed, ASegmentAcrossFacesIsAnErrorThatNamesIt)
{
  const auto mesh = meshOf(planeGrid(8, 8, 1.0, 1.0));
  const auto a = seedNear(mesh, { 0.06, 0.03, 0 }).points[0];
  const auto b = seedNear(mesh, { 0.93, 0.9, 0 }).points[0];
  try
  {
    distances<FastMarchingSolver>(mesh, { Seed::alongCurve({ a, a, b }) });
    ADD_FAILURE() << "accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("segment 1"), std::string::npos) << error.what();
  }
}

// Outside a closed curve as well as inside, and at its corners.
TEST(CurveSeed, ACurveInClosedTrianglesIsAnErrorThatSaysSo)
{
  const auto mesh = meshOf(planeGrid(4, 4, 1.0, 1.0));
  const SurfacePoint a = ClosestPointTree(mesh).closestPoint({ 0.3, 0.28, 0.0 }).point;
  const SurfacePoint b = ClosestPointTree(mesh).closestPoint({ 0.45, 0.3, 0.0 }).point;
  ASSERT_EQ(a.triangle, b.triangle);
  const std::vector<std::uint8_t> closed(mesh->numberOfTriangles(), 1);
  SolveOptions options;
  options.closedTriangles = closed;
  FastMarchingSolver solver(mesh);
  try
  {
    solver.solve(std::vector{ Seed::alongCurve({ a, b }) }, options);
    FAIL() << "no error";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("barrier"), std::string::npos) << error.what();
  }
}

TEST(CurveSeed, AClosedCurveIsMeasuredFromBothSides)
{
  const Index cells = 40;
  const Surface plane = planeGrid(cells, cells, 40.0, 40.0);
  const auto mesh = meshOf(plane);
  std::vector<SurfacePoint> loop;
  const auto add = [&](Index x, Index y)
  { loop.push_back(mesh->pointAtVertex(mesh->vertexOfPoint(y * (cells + 1) + x))); };
  for (Index i = 10; i < 30; ++i)
  {
    add(i, 10);
  }
  for (Index i = 10; i < 30; ++i)
  {
    add(30, i);
  }
  for (Index i = 30; i > 10; --i)
  {
    add(i, 30);
  }
  for (Index i = 30; i > 9; --i)
  {
    add(10, i);
  }
  const auto d = distances<FastMarchingSolver>(mesh, { Seed::alongCurve(loop) });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const double dx = std::abs(plane.points[i].x - 20.0) - 10.0;
    const double dy = std::abs(plane.points[i].y - 20.0) - 10.0;
    const double truth =
      dx > 0.0 || dy > 0.0 ? std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) : -std::max(dx, dy);
    EXPECT_NEAR(d[i], truth, 0.05);
  }
}

TEST(CurveSeed, ARegionIsAtDistanceZero)
{
  const Index cells = 40;
  const Surface plane = planeGrid(cells, cells, 40.0, 40.0);
  const auto mesh = meshOf(plane);
  std::vector<Index> square;
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const Vector3& p = plane.points[i];
    if (p.x >= 15.0 && p.x <= 25.0 && p.y >= 15.0 && p.y <= 25.0)
    {
      square.push_back(mesh->vertexOfPoint(i));
    }
  }
  const auto d = distances<FastMarchingSolver>(mesh, { Seed::onRegion(square) });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const double dx = std::max(0.0, std::abs(plane.points[i].x - 20.0) - 5.0);
    const double dy = std::max(0.0, std::abs(plane.points[i].y - 20.0) - 5.0);
    EXPECT_NEAR(d[i], std::hypot(dx, dy), 1e-9);
  }
}

// A region of points far apart is the same as a seed at each.
TEST(CurveSeed, IsolatedVerticesOfARegionArePoints)
{
  const Surface plane = delaunayPlane(2000, 9);
  const auto mesh = meshOf(plane);
  const Index a = mesh->vertexOfPoint(500);
  const Index b = mesh->vertexOfPoint(1500);
  const auto d = distances<FastMarchingSolver>(mesh, { Seed::onRegion({ a, b }) });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const double truth = std::min(
      norm(plane.points[i] - plane.points[500]), norm(plane.points[i] - plane.points[1500]));
    EXPECT_NEAR(d[i], truth, 1e-9);
  }
}

TEST(CurveSeed, SeedsOfAllKindsKeepTheirNumbers)
{
  const Index cells = 30;
  const Surface plane = planeGrid(cells, cells, 1.0, 1.0);
  const auto mesh = meshOf(plane);
  const std::vector<Seed> seeds{ Seed::alongCurve(rowOf(*mesh, cells, 0, 0, cells)),
    seedAt(*mesh, 15 * (cells + 1) + 15),
    Seed::onRegion(
      { mesh->vertexOfPoint(30 * (cells + 1)), mesh->vertexOfPoint(30 * (cells + 1) + 1) }) };
  FastMarchingSolver march(mesh);
  DijkstraSolver edges(mesh);
  for (FrontSolver* solver : std::initializer_list<FrontSolver*>{ &march, &edges })
  {
    const DistanceField& field = solver->solve(seeds);
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(2 * (cells + 1) + 4)), 0u);
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(16 * (cells + 1) + 17)), 1u);
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(29 * (cells + 1))), 2u);
    EXPECT_NEAR(field.distance(mesh->vertexOfPoint(4 * (cells + 1) + 7)), 4.0 / cells, 1e-9);
  }
}
