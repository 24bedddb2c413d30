// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The closest point against a search through all triangles by CGAL.

#include "ExactDistances.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "base/WorkCount.h"
#include "search/ClosestPointTree.h"
#include "search/PointSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** @param reach of the queries from 0, on each axis */
void checkAgainstAllTriangles(const Surface& surface, const Vector3& shift, double reach = 1.5)
{
  Surface moved = surface;
  for (Vector3& p : moved.points)
  {
    p = p + shift;
  }
  const auto mesh = meshOf(moved);
  const ClosestPointTree tree(mesh);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  for (int i = 0; i < 20; ++i)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    const Vector3 query = shift + Vector3{ x, y, uniform(random) };
    double expected = std::numeric_limits<double>::infinity();
    for (const Triangle& t : moved.triangles)
    {
      expected = std::min(expected,
        distanceToTriangle(moved.points[t[0]], moved.points[t[1]], moved.points[t[2]], query));
    }
    for (const auto& found : { tree.closestPoint(query), scannedClosestPoint(*mesh, query) })
    {
      EXPECT_NEAR(found.distance, expected, 1e-9);
      EXPECT_NEAR(norm(found.position - query), found.distance, 1e-12);
      EXPECT_EQ(mesh->positionOf(found.point), found.position);
    }
  }
}

}

TEST(ClosestPoint, AgreesWithASearchThroughAllTriangles)
{
  checkAgainstAllTriangles(icosphere(2), {});
  checkAgainstAllTriangles(planeGrid(30, 3, 1.0, 1.0), {});
}

// From near its centre all of a sphere is nearly as near as its nearest point.
TEST(ClosestPoint, AgreesFarInsideASphere)
{
  for (double reach : { 1e-3, 0.05, 0.4 })
  {
    checkAgainstAllTriangles(icosphere(4), {}, reach);
  }
}

TEST(ClosestPoint, AgreesFarOutsideASphere)
{
  checkAgainstAllTriangles(icosphere(4), {}, 20.0);
}

TEST(ClosestPoint, AgreesBetweenPartsFarFromEachOther)
{
  Surface far = torus(40, 20, 0.4, 0.2);
  for (Vector3& p : far.points)
  {
    p = p + Vector3{ 7.0, -5.0, 6.0 };
  }
  const Surface both = joined(icosphere(3), far);
  checkAgainstAllTriangles(both, {});
  checkAgainstAllTriangles(both, { -3.5, 2.5, -3.0 });
}

// Larger than floats can hold, and smaller.
TEST(ClosestPoint, SizesOfAllKindsAreSearched)
{
  const Surface unit = icosphere(4);
  const ClosestPointTree tree(meshOf(unit));
  for (double size : { 1e-29, 1e-15, 1e15, 1e29 })
  {
    Surface scaled = unit;
    for (Vector3& p : scaled.points)
    {
      p = size * p;
    }
    const ClosestPointTree scaledTree(meshOf(scaled));
    for (const Vector3& query : { Vector3{ 0.1, 0.2, 0.3 }, Vector3{ -1.0, 1.5, 0.7 } })
    {
      const double expected = tree.closestPoint(query).distance;
      EXPECT_NEAR(scaledTree.closestPoint(size * query).distance / size, expected, 1e-12);
    }
  }
}

TEST(ClosestPoint, AgreesAmongNeedlesAndTrianglesWithoutAnArea)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto anywhere = [&]
  {
    const double x = uniform(random);
    const double y = uniform(random);
    return Vector3{ x, y, uniform(random) };
  };
  Surface soup;
  for (double width : { 0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1.0 })
  {
    for (int i = 0; i < 40; ++i)
    {
      const Index first = static_cast<Index>(soup.points.size());
      const Vector3 a = anywhere();
      const Vector3 b = anywhere();
      const Vector3 between = a + 0.5 * (1.0 + uniform(random)) * (b - a);
      soup.points.insert(soup.points.end(), { a, b, between + width * anywhere() });
      soup.triangles.push_back({ first, first + 1, first + 2 });
    }
  }
  checkAgainstAllTriangles(soup, {});
}

TEST(ClosestPoint, WorksFarFromTheOrigin)
{
  checkAgainstAllTriangles(icosphere(2), { 1e6, -2e6, 3e6 });
}

TEST(ClosestPoint, APointOfTheMeshIsFoundExactly)
{
  const auto mesh = meshOf(icosphere(4));
  const ClosestPointTree tree(mesh);
  for (Index v = 0; v < mesh->numberOfVertices(); v += 7)
  {
    const auto found = tree.closestPoint(mesh->position(v));
    EXPECT_EQ(found.position, mesh->position(v));
    EXPECT_EQ(std::count(found.point.weights.begin(), found.point.weights.end(), 0.0), 2);
  }
}

TEST(ClosestPoint, TrianglesWithoutAreaAreSegments)
{
  const Surface needle{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } } };
  const auto found = ClosestPointTree(meshOf(needle)).closestPoint({ 1.3, 2.0, 0.0 });
  EXPECT_NEAR(found.distance, 2.0, 1e-12);
}

// Inside of a ridge two places, one on each side of it, are as near but for rounding.
TEST(ClosestPoint, OfPlacesThatAreAsNearTheSameIsFoundHoweverTheTrianglesAreStored)
{
  const int rows = 120;
  Surface surface = torus(rows, 60, 1.0, 0.4);
  const ClosestPointTree tree(meshOf(surface));
  std::mt19937 random(5);
  for (Triangle& t : surface.triangles)
  {
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  const ClosestPointTree turned(meshOf(surface));
  for (int i = 0; i < rows; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / rows;
    const Vector3 query{ 1.3 * std::cos(angle), 1.3 * std::sin(angle), 0.2 };
    EXPECT_LT(norm(tree.closestPoint(query).position - turned.closestPoint(query).position), 1e-9)
      << i;
  }
}

TEST(ClosestPoint, APointTooFarToMeasureIsAnError)
{
  const ClosestPointTree tree(meshOf(icosphere(0)));
  EXPECT_THROW(tree.closestPoint({ 1e200, 0.0, 0.0 }), std::invalid_argument);
}

// To the bit, and of several triangles that are equally near the same, so that it does not matter
// which one is asked. A vertex that no triangle has may be nearer, but is no point of the surface.
TEST(ClosestPoint, AScanFindsWhatTheTreeFinds)
{
  for (unsigned seed = 0; seed < 3 * meshKinds().size(); ++seed)
  {
    const MeshKind kind = meshKinds()[seed % meshKinds().size()];
    SCOPED_TRACE(nameOf(kind));
    const auto whole = meshOf(randomSurface(kind, seed), CoincidentPoints::Merge);
    std::vector<bool> leftOut(whole->numberOfTriangles());
    for (std::size_t t = 0; t < leftOut.size() / 2; ++t)
    {
      leftOut[t] = true;
    }
    const auto mesh = std::make_shared<const TriangleMesh>(whole->without(leftOut));
    const ClosestPointTree tree(mesh);
    for (Index v = 0; v < mesh->numberOfVertices(); v += 7)
    {
      // At vertices and on edges several triangles are equally near.
      const double off = v % 3 == 0 ? 0.0 : 0.1 * mesh->meanLongestEdge();
      const Vector3 query = mesh->position(v) + off * Vector3{ 1.0, -0.3, 0.7 };
      const auto expected = tree.closestPoint(query);
      const auto found = scannedClosestPoint(*mesh, query);
      EXPECT_EQ(found.point.triangle, expected.point.triangle);
      EXPECT_EQ(found.point.weights, expected.point.weights);
    }
  }
}

TEST(ClosestPoint, ASearchGoesOverToTheTree)
{
  const auto mesh = meshOf(icosphere(4));
  const PointSearch search(mesh);
  const Vector3 query{ 0.2, 0.7, -1.1 };
  for (int i = 0; i < 2 * PointSearch::MostScans; ++i)
  {
    const std::size_t before = WorkCount::steps();
    const auto found = search.closestPoint(query);
    EXPECT_EQ(found.position, ClosestPointTree(mesh).closestPoint(query).position);
    EXPECT_EQ(WorkCount::steps() - before > 0, i < PointSearch::MostScans);
  }
  EXPECT_THROW(PointSearch(meshOf({})).closestPoint(query), std::invalid_argument);
  EXPECT_THROW(search.closestPoint({ 1e200, 0.0, 0.0 }), std::invalid_argument);
}
