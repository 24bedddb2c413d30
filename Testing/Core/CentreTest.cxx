// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Centres and diameters, against the fields of all vertices.

#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"
#include "survey/CentreSearch.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

std::vector<PartExtent> centresOf(
  DistanceSolver& solver, double error, std::size_t mostFields = 100)
{
  CentreRequest request;
  request.error = error;
  request.mostFields = mostFields;
  return findCentres(solver, request);
}

/** Checks each part by the fields of all its vertices. */
void expectTrue(DistanceSolver& solver, const std::vector<PartExtent>& parts, double error)
{
  const TriangleMesh& mesh = solver.mesh();
  std::vector<double> eccentricities(mesh.numberOfVertices());
  std::vector<Index> part(mesh.numberOfVertices(), NoIndex);
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    if (!mesh.ring(v).empty())
    {
      const Seed seed = Seed::atPoint(mesh.pointAtVertex(v));
      const DistanceField& field = solver.solve({ &seed, 1 }, {});
      eccentricities[v] = field.largestDistance();
      part[v] = *std::min_element(field.reached().begin(), field.reached().end());
    }
  }
  for (const PartExtent& extent : parts)
  {
    double radius = DistanceField::Unreached;
    double diameter = 0.0;
    for (Index v = 0; v < mesh.numberOfVertices(); ++v)
    {
      if (part[v] == part[extent.centre])
      {
        radius = std::min(radius, eccentricities[v]);
        diameter = std::max(diameter, eccentricities[v]);
      }
    }
    const double rounding = 1e-9 * diameter;
    EXPECT_NEAR(extent.radius, eccentricities[extent.centre], rounding);
    EXPECT_NEAR(extent.diameter, eccentricities[extent.ends[0]], rounding);
    EXPECT_LE(extent.leastRadius, radius + rounding);
    EXPECT_GE(extent.mostDiameter, diameter - rounding);
    EXPECT_LE(extent.radius, radius * (1.0 + 1.1 * error) + rounding);
    EXPECT_GE(extent.diameter, diameter * (1.0 - 1.1 * error) - rounding);
  }
}

}

TEST(Centre, IsThatOfAllPairsOnRandomSurfaces)
{
  for (unsigned number = 0; number < 12; ++number)
  {
    const RandomCase random = randomCase(number, { 1, false, false });
    SCOPED_TRACE(random.description());
    DijkstraSolver solver(random.mesh);
    for (const double error : { 0.0, 0.05 })
    {
      const auto parts = centresOf(solver, error, 100000);
      expectTrue(solver, parts, error);
    }
  }
}

TEST(Centre, IsThatOfAllPairsWithExactDistances)
{
  const auto mesh = meshOf(torus(16, 12, 1.0, 0.4));
  ExactSolver solver(mesh);
  expectTrue(solver, centresOf(solver, 0.0, 100000), 0.0);
}

TEST(Centre, OfADiscIsItsMiddle)
{
  const auto mesh = meshOf(subdivided(disc(48), 4));
  FastMarchingSolver solver(mesh);
  const auto parts = centresOf(solver, 0.01);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].radius, 1.0, 0.01);
  EXPECT_NEAR(parts[0].diameter, 2.0, 0.02);
  EXPECT_LT(norm(mesh->position(parts[0].centre)), 0.05);
  EXPECT_LT(parts[0].numberOfFields, 40u);
}

// Two opposite sides of a box, on the plane: its diagonal, and its middle.
TEST(Centre, OfARectangleIsItsMiddle)
{
  const auto mesh = meshOf(planeGrid(60, 40, 3.0, 2.0));
  FastMarchingSolver solver(mesh);
  const auto parts = centresOf(solver, 0.005);
  EXPECT_NEAR(parts[0].diameter, std::sqrt(13.0), 1e-9);
  EXPECT_NEAR(parts[0].radius, std::sqrt(13.0) / 2.0, 0.01);
  EXPECT_LT(norm(mesh->position(parts[0].centre) - Vector3{ 1.5, 1.0, 0.0 }), 0.1);
}

// An unrolled cylinder: its ends are half a turn and the whole height apart.
TEST(Centre, OfACylinderIsHalfwayUp)
{
  const auto mesh = meshOf(cylinder(64, 40, 1.0, 4.0));
  FastMarchingSolver solver(mesh);
  const auto parts = centresOf(solver, 0.02);
  EXPECT_NEAR(parts[0].diameter, std::hypot(4.0, std::numbers::pi), 0.15);
  EXPECT_NEAR(parts[0].radius, std::hypot(2.0, std::numbers::pi), 0.1);
}

// On a sphere all points tie: the fields run out, and the bounds say how far that came.
TEST(Centre, OfASphereEndsAndStatesItsError)
{
  const auto mesh = meshOf(icosphere(4));
  FastMarchingSolver solver(mesh);
  const auto parts = centresOf(solver, 0.001, 30);
  EXPECT_EQ(parts[0].numberOfFields, 30u);
  EXPECT_NEAR(parts[0].radius, std::numbers::pi, 0.05);
  EXPECT_NEAR(parts[0].diameter, std::numbers::pi, 0.05);
  EXPECT_LT(parts[0].leastRadius, 0.95 * std::numbers::pi);
  EXPECT_GT(parts[0].mostDiameter, 1.05 * std::numbers::pi);
}

TEST(Centre, RefusesWhatItCannotSearchFor)
{
  const auto mesh = meshOf(planeGrid(2, 2, 1.0, 1.0));
  FastMarchingSolver solver(mesh);
  EXPECT_NE(errorOf([&] { centresOf(solver, -0.1); }).find("-0.1"), std::string::npos);
  EXPECT_NE(errorOf([&] { centresOf(solver, 0.1, 0); }).find("1 at least"), std::string::npos);
}
