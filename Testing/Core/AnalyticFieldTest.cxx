// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Fields whose truth is a formula: planes, developable surfaces, the sphere.

#include "ExactDistances.h"
#include "RoundedTube.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

double meanErrorOnSphere(int levels, const Vector3& direction)
{
  const Surface sphere = icosphere(levels);
  const auto mesh = meshOf(sphere);
  const Seed seed = seedNear(mesh, direction);
  const Vector3 source = mesh->positionOf(seed.points[0]);
  std::vector<double> truth;
  for (const Vector3& p : sphere.points)
  {
    truth.push_back(std::atan2(norm(cross(source, p)), dot(source, p)));
  }
  return relativeError(distances<FastMarchingSolver>(mesh, { seed }), truth).mean;
}

}

// The update is exact for a flat point source, so on a plane only rounding is left; its
// square root comes in where the source lies nearly on the line of an edge.
TEST(AnalyticField, PlaneFromVertexIsTheStraightLine)
{
  const Surface plane = delaunayPlane(2000, 1);
  const auto mesh = meshOf(plane);
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 1000) });
  EXPECT_LT(relativeError(d, straightLines(plane, plane.points[1000])).largest, 1e-9);
}

TEST(AnalyticField, PlaneFromInsideAFaceIsTheStraightLine)
{
  const Surface plane = delaunayPlane(2000, 2);
  const auto mesh = meshOf(plane);
  const Vector3 source{ 0.40123, 0.61234, 0.0 };
  const auto d = distances<FastMarchingSolver>(mesh, { seedNear(mesh, source) });
  EXPECT_LT(relativeError(d, straightLines(plane, source)).largest, 1e-9);
}

TEST(AnalyticField, PlaneFromPointsOnEdgesIsTheStraightLine)
{
  const Surface plane = delaunayPlane(2000, 3);
  const auto mesh = meshOf(plane);
  for (Index t = 0; t < mesh->numberOfTriangles(); t += 131)
  {
    const double part = 0.1 + 0.8 * t / mesh->numberOfTriangles();
    const Seed seed = Seed::atPoint({ t, { part, 1.0 - part, 0.0 } });
    const auto d = distances<FastMarchingSolver>(mesh, { seed });
    const auto truth = straightLines(plane, mesh->positionOf(seed.points[0]));
    EXPECT_LT(relativeError(d, truth).largest, 1e-9) << "edge of triangle " << t;
  }
}

TEST(AnalyticField, ThinTrianglesAreNoLessExact)
{
  const Surface thin = jitteredGrid(200, 20, 1.0, 1.0, 0.4, 1);
  const auto mesh = meshOf(thin);
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 2110) });
  EXPECT_LT(relativeError(d, straightLines(thin, thin.points[2110])).largest, 1e-9);
}

// Edges of 1 and of 1/1000 beside each other, as on CAD surfaces: needles, folds, seeds in faces.
TEST(AnalyticField, AMeshOfMixedEdgeLengthsIsUnrolled)
{
  const RoundedTube tube(2, 8, 1000.0, 1);
  const auto mesh = meshOf(tube.surface());
  for (Index source : { 0u, 333u, 1500u, 2900u })
  {
    const SurfacePoint inInput{ source, { 0.5, 0.3, 0.2 } };
    Index triangle = 0;
    while (mesh->sourceOfTriangle(triangle) != source)
    {
      ++triangle;
      ASSERT_LT(triangle, mesh->numberOfTriangles());
    }
    const auto d =
      distances<FastMarchingSolver>(mesh, { Seed::atPoint({ triangle, inInput.weights }) });
    EXPECT_LT(relativeError(d, tube.distancesFrom(inInput)).largest, 1e-9);
  }
}

// Great circle: d = R acos(p.q). First order scheme: halving the edges halves the error.
TEST(AnalyticField, SphereConvergesInFirstOrder)
{
  const Vector3 direction{ 0.3, -0.5, 0.8 };
  const double coarse = meanErrorOnSphere(4, direction);
  const double fine = meanErrorOnSphere(6, direction);
  EXPECT_LT(fine, 1.4e-3);
  EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 1.0, 0.2);
}

// The facets of a cylinder of n strips unroll to a rectangle of n chords; its shortest ways are
// straight.
TEST(AnalyticField, CylinderIsUnrolled)
{
  const Index around = 60;
  const Surface surface = cylinder(around, 40, 1.0, 3.0);
  const auto mesh = meshOf(surface);
  const Index source = 20 * around;
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, source) });
  const double chord = 2.0 * std::sin(std::numbers::pi / around);
  std::vector<double> truth;
  for (Index i = 0; i < surface.points.size(); ++i)
  {
    const Index steps = std::min(i % around, around - i % around);
    truth.push_back(std::hypot(steps * chord, surface.points[i].z - surface.points[source].z));
  }
  EXPECT_LT(relativeError(d, truth).largest, 1e-9);
}

// The facets of a cone unroll to a sector; ways over the apex are the alternative.
TEST(AnalyticField, ConeIsUnrolled)
{
  const Index around = 48;
  const double slope = 2.0;
  const Surface surface = cone(around, 30, 1.0, slope);
  const auto mesh = meshOf(surface);
  const Index source = 1 + 14 * around;
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, source) });
  const double chord = norm(surface.points[1 + 29 * around] - surface.points[2 + 29 * around]);
  const double facetAngle = 2.0 * std::asin(0.5 * chord / slope);
  const double r0 = norm(surface.points[source]);
  std::vector<double> truth;
  for (Index i = 0; i < surface.points.size(); ++i)
  {
    const double r = norm(surface.points[i]);
    const Index column = i == 0 ? 0 : (i - 1) % around;
    const double angle = facetAngle * std::min(column, around - column);
    truth.push_back(angle < std::numbers::pi
        ? std::sqrt(r * r + r0 * r0 - 2.0 * r * r0 * std::cos(angle))
        : r + r0);
  }
  EXPECT_LT(relativeError(d, truth).largest, 1e-9);
}

// On a square grid cut by diagonals Dijkstra's distance is a formula: diagonals as far as they go.
TEST(AnalyticField, DijkstraCountsEdges)
{
  const Surface plane = planeGrid(20, 20, 20.0, 20.0);
  const auto mesh = meshOf(plane);
  const auto d = distances<DijkstraSolver>(mesh, { seedAt(*mesh, 0) });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const double x = plane.points[i].x;
    const double y = plane.points[i].y;
    EXPECT_NEAR(d[i], std::sqrt(2.0) * std::min(x, y) + std::abs(x - y), 1e-12);
  }
}

TEST(AnalyticField, OtherPartsStayUnreached)
{
  const Surface both = joined(planeGrid(4, 4, 1.0, 1.0), icosphere(1));
  const auto mesh = meshOf(both);
  const auto march = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 0) });
  const auto edges = distances<DijkstraSolver>(mesh, { seedAt(*mesh, 0) });
  for (Index i = 0; i < both.points.size(); ++i)
  {
    EXPECT_EQ(std::isfinite(march[i]), i < 25);
    EXPECT_EQ(std::isfinite(edges[i]), i < 25);
  }
}
