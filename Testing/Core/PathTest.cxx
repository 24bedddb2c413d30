// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths: traced down a field, and made locally shortest.

#include "ExactDistances.h"
#include "PathStyles.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using MeshPointer = std::shared_ptr<const TriangleMesh>;

SurfacePoint pointAt(const MeshPointer& mesh, Index point)
{
  return mesh->pointAtVertex(mesh->vertexOfPoint(point));
}

template <class Solver = FastMarchingSolver>
SurfacePath pathBetween(const MeshPointer& mesh, const SurfacePoint& from, const SurfacePoint& to,
  const PathStyle& style = Straight, const SolveOptions& options = {})
{
  Solver solver(mesh);
  const auto path = shortestPath(solver, from, to, options, style);
  EXPECT_TRUE(path.has_value());
  return path.value_or(SurfacePath{});
}

/** What holds for every path: it leads from point to point, and stays on the surface. */
void expectOnSurface(const MeshPointer& mesh, const SurfacePath& path, const SurfacePoint& from,
  const SurfacePoint& to)
{
  ASSERT_FALSE(path.empty());
  const double size = mesh->longestEdgeLength();
  EXPECT_LT(norm(path.front().position(*mesh) - mesh->positionOf(from)), 1e-12 * size);
  EXPECT_LT(norm(path.back().position(*mesh) - mesh->positionOf(to)), 1e-12 * size);
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Carriers corners = unionOf(path[i - 1], path[i]);
    ASSERT_LE(corners.size(), 3) << "step " << i;
    EXPECT_FALSE(mesh->trianglesWith({ corners.begin(), corners.end() }).empty()) << "step " << i;
  }
}

}

TEST(Path, IsAStraightLineOnThePlane)
{
  for (const Surface& surface : { jitteredGrid(30, 30, 1.0, 1.0, 0.3, 2), planeGrid(30, 30, 1, 1),
         jitteredGrid(60, 60, 1.0, 10.0, 0.4, 3), delaunayPlane(2000, 7, 4.0) })
  {
    const auto mesh = meshOf(surface);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(0.0, 1.0);
    for (int i = 0; i < 50; ++i)
    {
      const SurfacePoint from = pointNear(mesh, { coordinate(random), coordinate(random), 0.0 });
      const SurfacePoint to = pointNear(mesh, { coordinate(random), coordinate(random), 0.0 });
      const SurfacePath path = pathBetween(mesh, from, to);
      expectOnSurface(mesh, path, from, to);
      const double exact = norm(mesh->positionOf(from) - mesh->positionOf(to));
      EXPECT_NEAR(lengthOf(*mesh, path), exact, 1e-12 * exact);
    }
  }
}

// Where the field is exact, so is a trace; it needs the ends of all edges on its way, which a march
// that stops at the path's end may lack where edges are about as long as the path.
TEST(Path, IsTracedStraightOnThePlane)
{
  for (const Surface& surface : { jitteredGrid(60, 60, 1.0, 1.0, 0.3, 2), planeGrid(4, 4, 1.0, 1.0),
         jitteredGrid(10, 2, 1.0, 1.0, 0.4, 1), delaunayPlane(30, 1) })
  {
    const auto mesh = meshOf(surface);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(0.0, 1.0);
    for (int i = 0; i < 200; ++i)
    {
      const SurfacePoint from = pointNear(mesh, { coordinate(random), coordinate(random), 0.0 });
      const SurfacePoint to = pointNear(mesh, { coordinate(random), coordinate(random), 0.0 });
      EXPECT_NEAR(lengthOf(*mesh, pathBetween(mesh, from, to, Traced)),
        norm(mesh->positionOf(from) - mesh->positionOf(to)), 1e-9);
    }
  }
}

// From end to end of a strip the path crosses each diagonal beside a vertex, so that every second
// step gains little. What the traced path is longer is the field's rounding.
TEST(Path, IsTracedStraightAlongAStrip)
{
  constexpr Index squares = 20'000;
  const auto mesh = meshOf(planeGrid(squares, 1, squares, 1.0));
  const SurfacePoint from = pointAt(mesh, 0);
  const SurfacePoint to = pointAt(mesh, 2 * squares + 1);
  const double exact = std::hypot(squares, 1.0);
  const double traced = lengthOf(*mesh, pathBetween(mesh, from, to, Traced));
  EXPECT_NEAR(traced, exact, 1e-9 * exact);
  EXPECT_NEAR(lengthOf(*mesh, pathBetween(mesh, from, to, Straight)), exact, 1e-11 * exact);
}

TEST(Path, UnrollsACylinderAndACone)
{
  const double chord = 2.0 * 100 * std::sin(std::numbers::pi / 100);
  const auto tube = meshOf(cylinder(100, 60, 1.0, 4.0));
  const auto end = [](double turn, double z) -> Vector3 {
    return { std::cos(turn), std::sin(turn), z };
  };
  const SurfacePoint low = pointNear(tube, end(0.0, 0.5));
  const SurfacePoint high = pointNear(tube, end(0.6 * std::numbers::pi, 3.3));
  const SurfacePath helix = pathBetween(tube, low, high);
  expectOnSurface(tube, helix, low, high);
  EXPECT_NEAR(lengthOf(*tube, helix), std::hypot(0.3 * chord, 2.8), 1e-9);

  const Index around = 60;
  const auto hat = meshOf(cone(around, 40, 0.5, 1.0));
  const double faceAngle = 2.0 * std::asin(0.5 * std::sin(std::numbers::pi / around));
  std::vector<Index> rim;
  for (Index i = 0; i < hat->numberOfPoints(); ++i)
  {
    const Vector3 p = hat->position(hat->vertexOfPoint(i));
    if (std::abs(std::hypot(p.x, p.y) - 0.5) < 1e-9)
    {
      rim.push_back(i);
    }
  }
  for (Index i : rim)
  {
    const Vector3 a = hat->position(hat->vertexOfPoint(rim[0]));
    const Vector3 b = hat->position(hat->vertexOfPoint(i));
    const double turn = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
    const double unrolled = turn / (2.0 * std::numbers::pi) * around * faceAngle;
    const double exact = 2.0 * std::sin(0.5 * unrolled);
    EXPECT_NEAR(
      lengthOf(*hat, pathBetween(hat, pointAt(hat, rim[0]), pointAt(hat, i))), exact, 1e-9);
  }
}

// On a coarse prism fronts from both sides meet inside large faces: a path from there, too, takes
// the shorter side.
TEST(Path, TakesTheShorterSideOfAPrism)
{
  const Index around = 3;
  const double chord = 2.0 * std::sin(std::numbers::pi / around);
  const auto prism = meshOf(cylinder(around, 4, 1.0, 4.0));
  const SurfacePoint corner = pointNear(prism, { -0.5, -0.5 * std::sqrt(3.0), 4.0 });
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  for (int i = 0; i < 200; ++i)
  {
    // On the side that does not touch the corner's edge.
    const double part = coordinate(random);
    const double height = 4.0 * coordinate(random);
    const SurfacePoint point =
      pointNear(prism, { 1.0 - 1.5 * part, 0.5 * std::sqrt(3.0) * part, height });
    const double turn = chord * std::min(1.0 + part, 2.0 - part);
    const double exact = std::hypot(turn, 4.0 - height);
    EXPECT_NEAR(lengthOf(*prism, pathBetween(prism, corner, point)), exact, 1e-12);
    EXPECT_NEAR(lengthOf(*prism, pathBetween(prism, point, corner)), exact, 1e-12);
  }
}

// Over the edge of a cube: two squares side by side are a rectangle.
TEST(Path, UnrollsACube)
{
  Surface box = planeGrid(10, 10, 1.0, 1.0);
  Surface side = planeGrid(10, 10, 1.0, 1.0);
  for (Vector3& p : side.points)
  {
    p = { 1.0, p.y, -p.x };
  }
  const auto mesh = std::make_shared<const TriangleMesh>(
    joined(box, side).points, joined(box, side).triangles, CoincidentPoints::Merge);
  const SurfacePoint from = pointNear(mesh, { 0.33, 0.21, 0.0 });
  const SurfacePoint to = pointNear(mesh, { 1.0, 0.87, -0.72 });
  EXPECT_NEAR(lengthOf(*mesh, pathBetween(mesh, from, to)), std::hypot(0.67 + 0.72, 0.66), 1e-12);
}

TEST(Path, IsNearTheExactShortestOne)
{
  const Surface& spot = geodesic::testing::spot();
  for (const Surface& surface : { spot, torus(100, 40, 2.0, 0.7), icosphere(4) })
  {
    const auto mesh = meshOf(surface);
    std::mt19937 random(11);
    std::uniform_int_distribution<Index> pick(0, mesh->numberOfPoints() - 1);
    std::vector<double> straight;
    std::vector<double> traced;
    for (int i = 0; i < 5; ++i)
    {
      const Index source = pick(random);
      const std::vector<double> exact = exactDistances(surface, { source });
      for (int j = 0; j < 20; ++j)
      {
        const Index target = pick(random);
        const SurfacePoint from = pointAt(mesh, source);
        const SurfacePoint to = pointAt(mesh, target);
        if (exact[target] > 0.0)
        {
          const SurfacePath path = pathBetween(mesh, from, to);
          expectOnSurface(mesh, path, from, to);
          straight.push_back(lengthOf(*mesh, path) / exact[target] - 1.0);
          traced.push_back(
            lengthOf(*mesh, pathBetween(mesh, from, to, Traced)) / exact[target] - 1.0);
        }
      }
    }
    std::sort(straight.begin(), straight.end());
    std::sort(traced.begin(), traced.end());
    EXPECT_GT(straight.front(), -1e-12);
    EXPECT_LT(straight[straight.size() / 2], 1e-5);
    EXPECT_LT(straight[straight.size() * 95 / 100], 1e-3);
    EXPECT_LT(traced[traced.size() * 95 / 100], 5e-3);
  }
}

// On spiky surfaces fast marching is misled here and there; the path never is longer for that.
TEST(Path, IsNeverLongerThanAlongEdges)
{
  Surface rough = jitteredGrid(30, 30, 1.0, 1.0, 0.3, 5);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> height(0.0, 0.2);
  for (Vector3& p : rough.points)
  {
    p.z = height(random);
  }
  const auto mesh = meshOf(rough);
  std::uniform_int_distribution<Index> pick(0, mesh->numberOfPoints() - 1);
  FastMarchingSolver march(mesh);
  DijkstraSolver edges(mesh);
  for (int i = 0; i < 2000; ++i)
  {
    const SurfacePoint from = pointAt(mesh, pick(random));
    const SurfacePoint to = pointAt(mesh, pick(random));
    const auto path = shortestPath(march, from, to, {}, Straight);
    const auto alongEdges = shortestPath(edges, from, to, {}, AlongEdges);
    ASSERT_TRUE(path && alongEdges);
    EXPECT_LE(lengthOf(*mesh, *path), lengthOf(*mesh, *alongEdges) * (1.0 + 1e-12));
  }
}

TEST(Path, AlongEdgesHasTheLengthOfDijkstrasField)
{
  const auto mesh = meshOf(spot());
  DijkstraSolver solver(mesh);
  std::mt19937 random(2);
  std::uniform_int_distribution<Index> pick(0, mesh->numberOfPoints() - 1);
  for (int i = 0; i < 50; ++i)
  {
    const SurfacePoint from = pointAt(mesh, pick(random));
    const Index target = pick(random);
    const auto path = shortestPath(solver, from, pointAt(mesh, target), {}, AlongEdges);
    ASSERT_TRUE(path);
    for (const PathPoint& point : *path)
    {
      EXPECT_TRUE(isVertex(point));
    }
    const Seed seed = Seed::atPoint(from);
    EXPECT_NEAR(lengthOf(*mesh, *path),
      solver.solve({ &seed, 1 }).distance(mesh->vertexOfPoint(target)), 1e-12);
  }
}

// Also where a search along edges found a shorter path, whose ends are written in its own way.
TEST(Path, AlongEdgesNamesTheEndThatItLeadsTo)
{
  const auto mesh = meshOf(spot());
  std::mt19937 random(3);
  std::uniform_int_distribution<Index> pick(0, mesh->numberOfPoints() - 1);
  for (int i = 0; i < 30; ++i)
  {
    const std::array ends{ pointAt(mesh, pick(random)), pointAt(mesh, pick(random)) };
    const SurfacePoint start = pointAt(mesh, pick(random));
    FastMarchingSolver solver(mesh);
    PathFinder finder(solver, ends, {}, AlongEdges);
    ASSERT_TRUE(finder.march({ &start, 1 }));
    const auto path = finder.pathFrom(start);
    ASSERT_TRUE(path);
    const Index end = finder.seedAtEnd(*path);
    ASSERT_LT(end, ends.size());
    EXPECT_EQ(path->back().position(*mesh), mesh->positionOf(ends[end]));
  }
}

// Fast marching leads along edges, but not by the shortest way; the path is that nevertheless.
TEST(Path, AlongEdgesIsTheShortestDownAnyField)
{
  const auto mesh = meshOf(spot());
  std::mt19937 random(3);
  std::uniform_int_distribution<Index> pick(0, mesh->numberOfPoints() - 1);
  for (int i = 0; i < 50; ++i)
  {
    const SurfacePoint from = pointAt(mesh, pick(random));
    const SurfacePoint to = pointAt(mesh, pick(random));
    const SurfacePath marched = pathBetween(mesh, from, to, AlongEdges);
    expectOnSurface(mesh, marched, from, to);
    EXPECT_EQ(std::adjacent_find(marched.begin(), marched.end(), isSameVertex), marched.end());
    EXPECT_NEAR(lengthOf(*mesh, marched),
      lengthOf(*mesh, pathBetween<DijkstraSolver>(mesh, from, to, AlongEdges)), 1e-12);
  }
}

TEST(Path, DoesNotDependOnTheScale)
{
  Surface spot = geodesic::testing::spot();
  std::vector<double> lengths;
  for (double scale : { 1.0, 1e-6, 1e6 })
  {
    Surface scaled = spot;
    for (Vector3& p : scaled.points)
    {
      p = scale * p;
    }
    const auto mesh = meshOf(scaled);
    double sum = 0.0;
    for (Index target : { 10u, 500u, 1234u, 2900u })
    {
      sum += lengthOf(*mesh, pathBetween(mesh, pointAt(mesh, 77), pointAt(mesh, target)));
    }
    lengths.push_back(sum / scale);
  }
  EXPECT_NEAR(lengths[1], lengths[0], 1e-9 * lengths[0]);
  EXPECT_NEAR(lengths[2], lengths[0], 1e-9 * lengths[0]);
}

TEST(Path, BetweenEqualPointsHasLengthZero)
{
  const auto mesh = meshOf(icosphere(3));
  for (const SurfacePoint& point :
    { pointAt(mesh, 5), pointNear(mesh, { 0.3, 0.4, 0.5 }), SurfacePoint{ 7, { 0.5, 0.5, 0.0 } } })
  {
    for (const PathStyle& style : { Straight, Traced, AlongEdges })
    {
      EXPECT_EQ(lengthOf(*mesh, pathBetween(mesh, point, point, style)), 0.0);
    }
  }
}

TEST(Path, DoesNotExistBetweenParts)
{
  Surface far = icosphere(2);
  for (Vector3& p : far.points)
  {
    p.x += 5.0;
  }
  const auto mesh = meshOf(joined(icosphere(2), far));
  FastMarchingSolver solver(mesh);
  EXPECT_FALSE(
    shortestPath(solver, pointNear(mesh, { 0, 0, 1 }), pointNear(mesh, { 5, 0, 1 }), {}, Straight));
}

// A notch in the square: the way is two lines that meet at its tip.
TEST(Path, BendsRoundABoundary)
{
  Surface notched = planeGrid(20, 20, 1.0, 1.0);
  std::erase_if(notched.triangles,
    [&](const Triangle& t)
    {
      const Vector3 middle =
        (1.0 / 3.0) * (notched.points[t[0]] + notched.points[t[1]] + notched.points[t[2]]);
      return middle.x > 0.45 && middle.x < 0.55 && middle.y < 0.5;
    });
  const auto mesh = meshOf(notched);
  const Vector3 a{ 0.213, 0.11, 0.0 };
  const Vector3 b{ 0.841, 0.17, 0.0 };
  const Vector3 left{ 0.45, 0.5, 0.0 };
  const Vector3 right{ 0.55, 0.5, 0.0 };
  const SurfacePath path = pathBetween(mesh, pointNear(mesh, a), pointNear(mesh, b));
  EXPECT_NEAR(lengthOf(*mesh, path), norm(left - a) + 0.1 + norm(b - right), 1e-12);
}

// Excluded points, closed triangles: the path keeps off both, as the front does.
TEST(Path, KeepsOffBarriers)
{
  const Index cells = 20;
  const auto mesh = meshOf(planeGrid(cells, cells, 1.0, 1.0));
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices(), 0);
  for (Index row = 0; row <= 10; ++row)
  {
    excluded[mesh->vertexOfPoint(row * (cells + 1) + 10)] = 1;
  }
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles(), 0);
  for (Index t = 0; t < mesh->numberOfTriangles(); ++t)
  {
    const Triangle& c = mesh->triangle(t);
    const Vector3 middle =
      (1.0 / 3.0) * (mesh->position(c[0]) + mesh->position(c[1]) + mesh->position(c[2]));
    closed[t] = middle.x > 0.45 && middle.x < 0.55 && middle.y < 0.5;
  }
  const Vector3 a{ 0.213, 0.11, 0.0 };
  const Vector3 b{ 0.841, 0.17, 0.0 };
  SolveOptions options;
  options.closedTriangles = closed;
  const SurfacePath round =
    pathBetween(mesh, pointNear(mesh, a), pointNear(mesh, b), Straight, options);
  EXPECT_NEAR(lengthOf(*mesh, round),
    norm(Vector3{ 0.45, 0.5, 0.0 } - a) + 0.1 + norm(b - Vector3{ 0.55, 0.5, 0.0 }), 1e-12);
  options.closedTriangles = {};
  options.excluded = excluded;
  const SurfacePath over =
    pathBetween(mesh, pointNear(mesh, a), pointNear(mesh, b), Straight, options);
  for (const PathPoint& point : over)
  {
    for (Index vertex : point.carriers())
    {
      EXPECT_FALSE(excluded[vertex]);
    }
  }
  EXPECT_GT(lengthOf(*mesh, over), lengthOf(*mesh, round));
  EXPECT_LT(lengthOf(*mesh, over), lengthOf(*mesh, round) + 2.0 / cells);
}

// Three half planes that share an edge: any two of them unfold to a plane.
TEST(Path, CrossesANonManifoldEdge)
{
  Surface fan;
  const Surface half = planeGrid(8, 16, 1.0, 2.0);
  for (double angle : { 0.3, 2.0, 4.5 })
  {
    Surface turned = half;
    for (Vector3& p : turned.points)
    {
      p = { p.x * std::cos(angle), p.x * std::sin(angle), p.y };
    }
    fan = joined(fan, turned);
  }
  for (Vector3& p : fan.points)
  {
    const bool isAxis = std::hypot(p.x, p.y) < 1e-12;
    p = isAxis ? Vector3{ 0.0, 0.0, p.z } : p;
  }
  const auto mesh =
    std::make_shared<const TriangleMesh>(fan.points, fan.triangles, CoincidentPoints::Merge);
  const auto on = [](double angle, double x, double z) -> Vector3 {
    return { x * std::cos(angle), x * std::sin(angle), z };
  };
  for (const auto& [first, second] : { std::pair{ 0.3, 2.0 }, { 2.0, 4.5 }, { 4.5, 0.3 } })
  {
    const SurfacePoint from = pointNear(mesh, on(first, 0.71, 0.2));
    const SurfacePoint to = pointNear(mesh, on(second, 0.53, 1.9));
    EXPECT_NEAR(lengthOf(*mesh, pathBetween(mesh, from, to)), std::hypot(1.24, 1.7), 1e-12);
  }
}

// Through varying cost a path is traced, and bends as light does.
TEST(Path, IsRefractedBetweenCosts)
{
  const Index cells = 128;
  const auto mesh = meshOf(planeGrid(cells, cells, 1.0, 1.0));
  std::vector<double> cost(mesh->numberOfVertices());
  for (Index v = 0; v < cost.size(); ++v)
  {
    cost[v] = mesh->position(v).x < 0.5 ? 1.0 : 3.0;
  }
  SolveOptions options;
  options.cost = cost;
  const SurfacePath path = pathBetween(
    mesh, pointNear(mesh, { 0.1, 0.2, 0.0 }), pointNear(mesh, { 0.9, 0.8, 0.0 }), Traced, options);
  double crossing = 0.0;
  for (const PathPoint& point : path)
  {
    const Vector3 p = point.position(*mesh);
    crossing = p.x <= 0.5 ? p.y : crossing;
  }
  // Least time over the crossing point.
  double best = 0.0;
  double least = 1e9;
  for (double y = 0.0; y < 1.0; y += 1e-4)
  {
    const double time = std::hypot(0.4, y - 0.2) + 3.0 * std::hypot(0.4, 0.8 - y);
    best = time < least ? y : best;
    least = std::min(time, least);
  }
  EXPECT_NEAR(crossing, best, 0.02);
}

TEST(Path, OfVaryingCostIsNotStraightened)
{
  const auto mesh = meshOf(icosphere(2));
  const std::vector<double> cost(mesh->numberOfVertices(), 2.0);
  SolveOptions options;
  options.cost = cost;
  FastMarchingSolver solver(mesh);
  EXPECT_THROW(shortestPath(solver, pointAt(mesh, 0), pointAt(mesh, 9), options, Straight),
    std::invalid_argument);
  EXPECT_THROW(shortestPath(solver, pointAt(mesh, 0), pointAt(mesh, 9), {},
                 PathStyle{ PathOrder::Vertices, true }),
    std::invalid_argument);
}

TEST(Path, EndsAtALengthOrANumberOfPoints)
{
  const auto mesh = meshOf(icosphere(4));
  const SurfacePath path = pathBetween(mesh, pointAt(mesh, 0), pointAt(mesh, 2000));
  const double length = lengthOf(*mesh, path);
  constexpr std::size_t any = 1000000;
  const SurfacePath half = beginningOf(*mesh, path, 0.5 * length, any, true);
  EXPECT_NEAR(lengthOf(*mesh, half), 0.5 * length, 1e-12);
  EXPECT_LT(lengthOf(*mesh, beginningOf(*mesh, path, 0.5 * length, any, false)), 0.5 * length);
  EXPECT_EQ(beginningOf(*mesh, path, 10.0 * length, 5, true).size(), 5u);
  EXPECT_EQ(beginningOf(*mesh, path, 10.0 * length, any, true).size(), path.size());
  EXPECT_EQ(beginningOf(*mesh, path, 0.0, any, true).size(), 1u);
}

// From many starts on a plane each path is the straight line to the nearest of many seeds; where
// the places nearest to one end in a tip inside the start's face, it may be the line to the next
// one.
TEST(Path, LeadsToTheNearestOfManySeeds)
{
  const auto mesh = meshOf(jitteredGrid(60, 60, 1.0, 1.0, 0.3, 12));
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  const auto anywhere = [&] {
    return pointNear(mesh, { coordinate(random), coordinate(random), 0.0 });
  };
  std::vector<SurfacePoint> seeds;
  std::vector<SurfacePoint> starts;
  for (int i = 0; i < 40; ++i)
  {
    seeds.push_back(anywhere());
  }
  for (int i = 0; i < 300; ++i)
  {
    starts.push_back(anywhere());
  }
  FastMarchingSolver solver(mesh);
  PathFinder finder(solver, seeds, {}, Straight);
  ASSERT_TRUE(finder.march(starts));
  int exceptions = 0;
  for (const SurfacePoint& start : starts)
  {
    double exact = 2.0;
    for (const SurfacePoint& seed : seeds)
    {
      exact = std::min(exact, norm(mesh->positionOf(seed) - mesh->positionOf(start)));
    }
    const auto path = finder.pathFrom(start);
    ASSERT_TRUE(path);
    const double excess = lengthOf(*mesh, *path) - exact;
    EXPECT_GT(excess, -1e-12);
    EXPECT_LT(excess, 0.2 / 60.0);
    exceptions += excess > 1e-9 ? 1 : 0;
  }
  EXPECT_LE(exceptions, 3);
}
