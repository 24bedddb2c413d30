// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances times a cost: Snell's law, smooth speeds, and what cost must not be.

#include "ExactDistances.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

std::vector<double> costOn(
  const TriangleMesh& mesh, const std::function<double(const Vector3&)>& cost)
{
  std::vector<double> values;
  for (const Vector3& p : mesh.positions())
  {
    values.push_back(cost(p));
  }
  return values;
}

/** Fermat's principle: the least cost of a broken line from a to b over the border x = 0. */
double throughBorder(const Vector3& a, const Vector3& b, double costA, double costB)
{
  double low = -10.0;
  double high = 10.0;
  const auto cost = [&](double y)
  { return costA * std::hypot(a.x, a.y - y) + costB * std::hypot(b.x, b.y - y); };
  for (int i = 0; i < 200; ++i)
  {
    const double y1 = low + (high - low) / 3.0;
    const double y2 = high - (high - low) / 3.0;
    (cost(y1) < cost(y2) ? high : low) = cost(y1) < cost(y2) ? y2 : y1;
  }
  return cost(0.5 * (low + high));
}

/**
 * Mean relative error where two half planes of cost 1 (x < 0) and 3 meet in a column of points.
 * From the dearer side the way along the border in the cheaper one may be the best (a head wave).
 */
double snellError(Index cells)
{
  Surface plane = planeGrid(cells, cells, 2.0, 2.0);
  for (Vector3& p : plane.points)
  {
    p = p - Vector3{ 1.0, 1.0, 0.0 };
  }
  // The border runs between two columns: a triangle's cost is that of the side that it lies on.
  for (Vector3& p : plane.points)
  {
    p.x += 1.0 / cells;
  }
  const auto mesh = meshOf(plane);
  const auto cost = costOn(*mesh, [](const Vector3& p) { return p.x < 0.0 ? 1.0 : 3.0; });
  const Vector3 source{ -0.5, 0.1, 0.0 };
  SolveOptions options;
  options.cost = cost;
  const auto d = distances<FastMarchingSolver>(mesh, { seedNear(mesh, source) }, options);
  std::vector<double> truth;
  for (const Vector3& p : plane.points)
  {
    truth.push_back(p.x < 0.0 ? norm(p - source) : throughBorder(source, p, 1.0, 3.0));
  }
  return relativeError(d, truth).mean;
}

}

TEST(Cost, SnellsLawHoldsAndTheErrorFalls)
{
  const double coarse = snellError(64);
  const double fine = snellError(256);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, 0.6 * coarse);
}

// Cost 1 / (1 + x): a speed that grows linearly. The fronts are circles; with u = |p - s|,
// d = acosh(1 + u^2 / (2 v(s) v(p))).
TEST(Cost, ALinearSpeedHasCircularFronts)
{
  const Surface plane = planeGrid(256, 256, 1.0, 1.0);
  const auto mesh = meshOf(plane);
  const auto cost = costOn(*mesh, [](const Vector3& p) { return 1.0 / (1.0 + p.x); });
  const Vector3 source{ 0.311, 0.417, 0.0 };
  SolveOptions options;
  options.cost = cost;
  const auto d = distances<FastMarchingSolver>(mesh, { seedNear(mesh, source) }, options);
  std::vector<double> truth;
  for (const Vector3& p : plane.points)
  {
    const double u = norm(p - source);
    truth.push_back(std::acosh(1.0 + u * u / (2.0 * (1.0 + source.x) * (1.0 + p.x))));
  }
  EXPECT_LT(relativeError(d, truth).mean, 1.5e-3);
}

// The article's example. Subdivision keeps the points of the coarser mesh, so that the field on a
// mesh of four times shorter edges is a truth four times nearer.
TEST(Cost, CurvatureOnAnEllipsoidConverges)
{
  const Vector3 axes{ 1.0, 0.7, 0.5 };
  const auto field = [&](int levels)
  {
    Surface ellipsoid = icosphere(levels);
    for (Vector3& p : ellipsoid.points)
    {
      p = { axes.x * p.x, axes.y * p.y, axes.z * p.z };
    }
    const auto mesh = meshOf(ellipsoid);
    const auto cost = costOn(*mesh,
      [&](const Vector3& p)
      {
        const Vector3 n{ p.x / (axes.x * axes.x), p.y / (axes.y * axes.y),
          p.z / (axes.z * axes.z) };
        const double volume = axes.x * axes.y * axes.z;
        return (dot(axes, axes) - dot(p, p)) / (2.0 * volume * volume * std::pow(norm(n), 3));
      });
    SolveOptions options;
    options.cost = cost;
    return distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 3) }, options);
  };
  const auto truth = field(7);
  const auto error = [&](int levels)
  {
    const auto d = field(levels);
    return relativeError(d, { truth.begin(), truth.begin() + d.size() }).mean;
  };
  const double coarse = error(4);
  const double fine = error(5);
  EXPECT_LT(fine, 5e-3);
  EXPECT_LT(fine, 0.65 * coarse);
}

TEST(Cost, AConstantCostScalesTheField)
{
  const Surface& spot = geodesic::testing::spot();
  const auto mesh = meshOf(spot);
  const std::vector<Seed> seeds{ seedAt(*mesh, 10), seedAt(*mesh, 2000) };
  const std::vector<double> cost(mesh->numberOfVertices(), 2.5);
  SolveOptions options;
  options.cost = cost;
  for (std::size_t count : { 1, 2 })
  {
    const std::vector<Seed> some(seeds.begin(), seeds.begin() + count);
    const auto march = distances<FastMarchingSolver>(mesh, some);
    const auto costed = distances<FastMarchingSolver>(mesh, some, options);
    const auto edges = distances<DijkstraSolver>(mesh, some);
    const auto costedEdges = distances<DijkstraSolver>(mesh, some, options);
    for (std::size_t i = 0; i < march.size(); ++i)
    {
      EXPECT_NEAR(costed[i], 2.5 * march[i], 1e-9);
      EXPECT_NEAR(costedEdges[i], 2.5 * edges[i], 1e-9);
    }
  }
}

// In the disc round a seed, where a varying cost begins with lengths of straight lines, these lead
// round closed triangles, too.
TEST(Cost, TheDiscRoundASeedEndsAtABarrier)
{
  const Surface plane = planeGrid(40, 40, 40.0, 40.0);
  const auto mesh = meshOf(plane);
  // A wall of one column of squares, open at its upper end only.
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles(), 0);
  for (Index t = 0; t < closed.size(); ++t)
  {
    const Vector3 c = mesh->positionOf({ t, { 1.0 / 3, 1.0 / 3, 1.0 / 3 } });
    closed[t] = c.x > 20.0 && c.x < 21.0 && c.y < 30.0;
  }
  std::vector<double> cost(mesh->numberOfVertices());
  for (Index v = 0; v < cost.size(); ++v)
  {
    cost[v] = 1.0 + 1e-6 * mesh->position(v).x;
  }
  SolveOptions options;
  options.closedTriangles = closed;
  options.cost = cost;
  const auto found =
    distances<FastMarchingSolver>(mesh, { seedNear(mesh, { 19, 10, 0 }) }, options);
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const Vector3& p = plane.points[i];
    if (p.x >= 21.0 && p.y <= 20.0)
    {
      const double round = std::hypot(1.0, 20.0) + 1.0 + std::hypot(p.x - 21.0, 30.0 - p.y);
      ASSERT_GE(found[i], (1.0 - 1e-2) * round) << p.x << ", " << p.y;
    }
  }
}

TEST(Cost, DijkstraTakesTheMeanOfTheEnds)
{
  const auto mesh = meshOf({ { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 9, 0 } }, { { 0, 1, 2 } } });
  std::vector<double> cost(3);
  cost[mesh->vertexOfPoint(0)] = 1.0;
  cost[mesh->vertexOfPoint(1)] = 4.0;
  cost[mesh->vertexOfPoint(2)] = 100.0;
  SolveOptions options;
  options.cost = cost;
  EXPECT_DOUBLE_EQ(distances<DijkstraSolver>(mesh, { seedAt(*mesh, 0) }, options)[1], 5.0);
}

TEST(Cost, ACostThatIsNoneIsNamedByItsPoint)
{
  const auto mesh = meshOf(planeGrid(4, 4, 1.0, 1.0));
  for (double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    std::vector<double> cost(mesh->numberOfVertices(), 1.0);
    cost[mesh->vertexOfPoint(7)] = bad;
    cost[mesh->vertexOfPoint(11)] = bad;
    SolveOptions options;
    options.cost = cost;
    try
    {
      distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 0) }, options);
      ADD_FAILURE() << bad << " was accepted";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find("point 7 "), std::string::npos) << error.what();
    }
  }
}

TEST(Cost, AStopUnderCostIsSharp)
{
  const Surface plane = planeGrid(60, 60, 1.0, 1.0);
  const auto mesh = meshOf(plane);
  const auto cost = costOn(*mesh, [](const Vector3& p) { return 1.0 + 5.0 * p.y; });
  SolveOptions options;
  options.cost = cost;
  const std::vector<Seed> seeds{ seedAt(*mesh, 30), seedAt(*mesh, 3000) };
  const auto whole = distances<FastMarchingSolver>(mesh, seeds, options);
  options.maximumDistance = 0.6;
  const auto bounded = distances<FastMarchingSolver>(mesh, seeds, options);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    if (whole[i] <= 0.6)
    {
      EXPECT_NEAR(bounded[i], whole[i], 1e-10);
    }
    else
    {
      EXPECT_FALSE(std::isfinite(bounded[i]));
    }
  }
}
