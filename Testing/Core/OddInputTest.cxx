// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Input that no mesh generator should make and every archive contains.

#include "NastyCases.h"
#include "Solving.h"
#include "base/NumberText.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "methods/SolverTable.h"
#include "solve/DijkstraSolver.h"
#include "solve/MarchControl.h"
#include "solve/StopLimit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <span>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

const Surface plane = planeGrid(30, 30, 1.0, 1.0);

/** The field on a surface whose first points are those of the plane is the straight line there. */
void expectStraightLines(const Surface& surface)
{
  const auto mesh = meshOf(surface);
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 480) });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    ASSERT_NEAR(d[i], norm(plane.points[i] - plane.points[480]), 1e-9);
  }
}

std::string messageOf(const Surface& surface)
{
  try
  {
    meshOf(surface);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(OddInput, ATriangleWithARepeatedPointIsLeftOut)
{
  Surface surface = plane;
  surface.points.push_back({ 5.0, 5.0, 0.0 });
  surface.triangles.insert(
    surface.triangles.end(), { { 0, 0, 1 }, { 40, 41, 40 }, { 961, 961, 961 }, { 0, 961, 961 } });
  expectStraightLines(surface);
  EXPECT_EQ(meshOf(surface)->vertexOfPoint(961), NoIndex);
}

TEST(OddInput, ATriangleOfZeroAreaCarriesTheFrontAlongItsSides)
{
  Surface surface = plane;
  surface.triangles.insert(surface.triangles.end(), { { 0, 1, 2 }, { 3, 5, 4 } });
  surface.points.insert(surface.points.end(), { { 2.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 } });
  surface.triangles.push_back({ 30, 961, 962 });
  expectStraightLines(surface);
  const auto mesh = meshOf(surface);
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 0) });
  EXPECT_NEAR(d[961], 2.0, 1e-9);
  EXPECT_NEAR(d[962], 3.0, 1e-9);
}

TEST(OddInput, DuplicatedTrianglesChangeNothing)
{
  Surface surface = plane;
  surface.triangles.insert(surface.triangles.end(), plane.triangles.begin(), plane.triangles.end());
  expectStraightLines(surface);
}

TEST(OddInput, AnEdgeWithManyTrianglesLeadsOntoEverySheet)
{
  // Four half planes round the y axis: every point is as far from (0, 0.5) as on one plane.
  Surface sheets = planeGrid(10, 10, 1.0, 1.0);
  for (const Vector3& direction : { Vector3{ -1, 0, 0 }, Vector3{ 0, 0, 1 }, Vector3{ 0, 0, -1 } })
  {
    Surface sheet = planeGrid(10, 10, 1.0, 1.0);
    for (Vector3& p : sheet.points)
    {
      p = Vector3{ 0.0, p.y, 0.0 } + p.x * direction;
    }
    sheets = joined(sheets, sheet);
  }
  const auto mesh = meshOf(sheets, CoincidentPoints::Merge);
  const Seed seed = seedNear(mesh, { 0.35, 0.45, 0.0 });
  const auto d = distances<FastMarchingSolver>(mesh, { seed });
  for (Index i = 121; i < sheets.points.size(); ++i)
  {
    const Vector3& p = sheets.points[i];
    const double beyond = std::hypot(p.x, p.z);
    EXPECT_NEAR(d[i], std::hypot(0.35 + beyond, p.y - 0.45), 1e-9);
  }
}

TEST(OddInput, SheetsThatMeetInAVertexAreConnectedThere)
{
  Surface other = planeGrid(5, 5, -1.0, -1.0);
  const Surface both = joined(plane, other);
  const auto mesh = meshOf(both, CoincidentPoints::Merge);
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 960) });
  // Behind the vertex the front starts anew, which the update resolves to first order only.
  for (Index i = 961; i < both.points.size(); ++i)
  {
    const double truth = std::sqrt(2.0) + norm(both.points[i]);
    EXPECT_GE(d[i], truth - 1e-9);
    EXPECT_LE(d[i], 1.02 * truth);
  }
}

TEST(OddInput, NoTrianglesMakeAnEmptyMesh)
{
  EXPECT_EQ(meshOf({})->numberOfVertices(), 0u);
  EXPECT_EQ(meshOf({ { { 0, 0, 0 } }, {} })->numberOfVertices(), 0u);
}

TEST(OddInput, APointThatIsNotFiniteIsNamed)
{
  Surface surface = plane;
  surface.points[17].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(messageOf(surface).find("Point 17"), std::string::npos);
  surface.points[17].y = std::numeric_limits<double>::infinity();
  EXPECT_NE(messageOf(surface).find("Point 17"), std::string::npos);
}

// Squares of lengths would overflow, and lengths in single precision do.
TEST(OddInput, ASurfaceTooSmallOrTooLargeIsRefusedWithTheLimit)
{
  const auto scaled = [](double scale)
  {
    Surface surface = plane;
    for (Vector3& p : surface.points)
    {
      p = scale * p;
    }
    return surface;
  };
  for (const double scale : { 1e-300, 1e-60, 0.9e-30, 1.1e30, 1e60, 1e300 })
  {
    const std::string message = messageOf(scaled(scale));
    for (const std::string& part : { textOf(scale), textOf(1e-30), textOf(1e30) })
    {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
  for (const double scale : { 1.1e-30, 0.9e30 })
  {
    for (const SolverTraits& solver : solverTable())
    {
      const Surface surface = scaled(scale);
      const auto mesh = meshOf(surface);
      const Seed seed = seedAt(*mesh, 480);
      const auto made = solver.make(mesh);
      const DistanceField& field = made->solve({ &seed, 1 }, {});
      // Dijkstra's paths follow the edges: to the corner along the diagonals.
      EXPECT_NEAR(field.distance(mesh->vertexOfPoint(960)) / scale, std::sqrt(0.5), 1e-3)
        << solver.name;
    }
  }
  EXPECT_EQ(messageOf(scaled(0.0)), "");
}

// The numbers are checked before anything is read.
TEST(OddInput, MorePointsOrTrianglesThanNumbersAreRefusedWithTheLimit)
{
  const Vector3 point{};
  const Triangle triangle{};
  EXPECT_NE(
    errorOf<std::length_error>([&] { TriangleMesh(std::span(&point, std::size_t{ 1 } << 30), {}); })
      .find("1073741823"),
    std::string::npos);
  EXPECT_NE(errorOf<std::length_error>(
              [&] { TriangleMesh({}, std::span(&triangle, std::size_t{ 1 } << 30)); })
              .find("715827882"),
    std::string::npos);
}

TEST(OddInput, ACostBeyondTheLimitsIsRefused)
{
  const auto mesh = meshOf(plane);
  for (const double bad : { 1e-40, 1e40, 0.0, -1.0, std::nan("") })
  {
    std::vector<double> cost(mesh->numberOfVertices(), 1.0);
    cost[3] = bad;
    SolveOptions options;
    options.cost = cost;
    const Seed seed = seedAt(*mesh, 480);
    const std::string message = errorOf(
      [&] {
        FastMarchingSolver(mesh).solve({ &seed, 1 }, options);
      });
    EXPECT_NE(message.find("1e+30"), std::string::npos) << message;
  }
}

TEST(OddInput, APointThatIsNotFiniteAndNotUsedDoesNoHarm)
{
  Surface surface = plane;
  surface.points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 });
  expectStraightLines(surface);
}

TEST(OddInput, ATriangleOfMissingPointsIsNamed)
{
  Surface surface = plane;
  surface.triangles.push_back({ 0, 1, 9999 });
  EXPECT_NE(messageOf(surface).find("9999"), std::string::npos);
}

// A cone whose apex has 20,000 triangles: quadratic time would take minutes.
TEST(OddInput, AVertexMayHaveThousandsOfTriangles)
{
  const Surface surface = cone(20000, 1, 1.0, 2.0);
  const auto mesh = meshOf(surface);
  const auto d = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 0) });
  for (Index i = 1; i < surface.points.size(); ++i)
  {
    ASSERT_NEAR(d[i], 2.0, 1e-9);
  }
}

// Random triangles lying on each other in a plane: gains can go on for ever, each smaller than the
// last. It may take the field or an error, but not for ever.
TEST(OddInput, TrianglesLyingOnEachOtherComeToAnEnd)
{
  std::mt19937 random(44);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int settled = 0;
  for (int run = 0; run < 20; ++run)
  {
    Surface soup;
    for (int i = 0; i < 50; ++i)
    {
      const double x = uniform(random);
      soup.points.push_back({ x, uniform(random), 0.0 });
    }
    for (int i = 0; i < 1200; ++i)
    {
      const Index a = random() % 50;
      const Index b = random() % 50;
      soup.triangles.push_back({ a, b, static_cast<Index>(random() % 50) });
    }
    const auto mesh = meshOf(soup);
    const Seed seed = Seed::atPoint({ 7, { 0.5, 0.25, 0.25 } });
    const Vector3 source = mesh->positionOf(seed.points[0]);
    try
    {
      const auto d = distances<FastMarchingSolver>(mesh, { seed });
      for (Index i = 0; i < soup.points.size(); ++i)
      {
        EXPECT_GE(d[i], (1.0 - 1e-9) * norm(soup.points[i] - source));
      }
      ++settled;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find("does not settle"), std::string::npos);
    }
  }
  // An error is the rare case.
  EXPECT_GE(settled, 15);
}

// Of these two cases of the campaign, needles, the front gains ever less, and both tiers have to
// raise the gain that counts. Their fields differ then, and each says so.
TEST(OddInput, AFrontThatSettlesOnlyRoughlyIsSaid)
{
  for (const unsigned number : { 11442, 12917 })
  {
    const NastyCase test = nastyCase(number);
    FastMarchingSolver solver(test.mesh);
    ReferenceSolver reference(test.mesh);
    EXPECT_GE(solver.solve(test.seeds, test.options()).raisedGain(), 1e-11);
    EXPECT_GE(reference.solve(test.seeds, test.options()).raisedGain(), 1e-11);
    EXPECT_EQ(DijkstraSolver(test.mesh).solve(test.seeds, test.options()).raisedGain(), 0.0);
  }
  // The next run is another one: from a corner the front settles.
  const NastyCase test = nastyCase(11442);
  FastMarchingSolver solver(test.mesh);
  solver.solve(test.seeds);
  const Seed corner = seedAt(*test.mesh, 0);
  EXPECT_EQ(solver.solve({ &corner, 1 }).raisedGain(), 0.0);
}

// Beyond the budget of updates a run ends in an error that names the numbers and a remedy, in both
// tiers alike; before that gains count less and less.
TEST(OddInput, AMarchBeyondItsBudgetSaysWhatToDo)
{
  const DistanceField field(1);
  const SolveOptions options;
  const auto mesh = meshOf(plane);
  StopLimit limit(*mesh, options, field);
  MarchControl control(options, limit);
  constexpr std::size_t values = 500;
  constexpr std::size_t allowed = MarchControl::MostUpdates * (values + MarchControl::SmallMarch);
  std::size_t steps = 0;
  for (; steps < allowed; steps += 100)
  {
    ASSERT_TRUE(control.mayGoOn(values, 100));
    // From 40 updates for each value on.
    ASSERT_EQ(control.raisedGain() > 0.0, steps >= 420'000) << steps;
  }
  EXPECT_NEAR(1.0 - control.keptFraction(), 1e-6, 1e-12);
  EXPECT_NEAR(control.raisedGain(), 1e-6, 1e-12);
  try
  {
    control.mayGoOn(values);
    FAIL() << "a march went on for ever";
  }
  catch (const std::runtime_error& error)
  {
    const std::string message = error.what();
    for (const char* part : { "1050001 updates", "500 values", "limit of 100", "Dijkstra" })
    {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
}
