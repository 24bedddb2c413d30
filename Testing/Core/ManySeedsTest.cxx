// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Dense seeds: their field is near the least of the single fields, within fractions of an edge, and
// it does not depend on the order. The number of values is bounded (see LabelBounds and
// labelReaches()).

#include "ExactDistances.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "Surfaces.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Different points of a surface at random. */
std::vector<Index> randomPoints(const Surface& surface, std::size_t count)
{
  std::vector<Index> points(surface.points.size());
  for (Index i = 0; i < points.size(); ++i)
  {
    points[i] = i;
  }
  std::shuffle(points.begin(), points.end(), std::mt19937(7));
  points.resize(count);
  return points;
}

/** The points of a row of a grid. */
std::vector<Index> rowOf(Index side, Index row)
{
  std::vector<Index> points;
  for (Index i = 0; i < side; ++i)
  {
    points.push_back(row * side + i);
  }
  return points;
}

std::vector<Seed> seedsAt(const TriangleMesh& mesh, const std::vector<Index>& points)
{
  std::vector<Seed> seeds;
  for (const Index point : points)
  {
    seeds.push_back(seedAt(mesh, point));
  }
  return seeds;
}

/** One seed for each two neighbouring points: loose line cells. */
std::vector<Seed> segmentsOf(const TriangleMesh& mesh, const std::vector<Index>& points)
{
  std::vector<Seed> seeds;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    seeds.push_back(Seed::alongCurve({ mesh.pointAtVertex(mesh.vertexOfPoint(points[i - 1])),
      mesh.pointAtVertex(mesh.vertexOfPoint(points[i])) }));
  }
  return seeds;
}

/** A twentieth of an edge in the mean, half an edge anywhere. */
void expectNearLeast(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options = {}, double largest = 0.5)
{
  const DifferenceToLeast difference = differenceToLeast(mesh, seeds, options);
  EXPECT_LE(difference.mean, 0.05);
  EXPECT_LE(difference.largest, largest);
}

/** The number of vertices that a solve takes from its queues. */
std::size_t stepsOf(FastMarchingSolver& solver, const std::vector<Seed>& seeds)
{
  std::size_t steps = 0;
  SolveOptions options;
  options.onProgress = [&](std::size_t taken)
  {
    // The same number comes again while fronts start.
    EXPECT_GE(taken, steps);
    steps = taken;
    return true;
  };
  solver.solve(seeds, options);
  return steps;
}

}

TEST(ManySeeds, RandomOnesAreNearTheLeast)
{
  for (const std::size_t count : { 30u, 200u, 1500u })
  {
    const Surface grid = hillyGrid(59, 59);
    const auto mesh = meshOf(grid);
    SCOPED_TRACE(count);
    expectNearLeast(mesh, seedsAt(*mesh, randomPoints(grid, count)));
  }
}

TEST(ManySeeds, ARowIsNearTheLeast)
{
  const auto mesh = meshOf(hillyGrid(89, 89));
  expectNearLeast(mesh, seedsAt(*mesh, rowOf(90, 45)));
}

TEST(ManySeeds, ARowOnASphereIsNearTheLeast)
{
  const Surface sphere = icosphere(4);
  const auto mesh = meshOf(sphere);
  std::vector<Index> equator;
  for (Index i = 0; i < sphere.points.size(); ++i)
  {
    if (std::abs(sphere.points[i].z) < 0.03)
    {
      equator.push_back(i);
    }
  }
  ASSERT_GT(equator.size(), 40u);
  expectNearLeast(mesh, seedsAt(*mesh, equator));
}

TEST(ManySeeds, LooseSegmentsAreNearTheLeast)
{
  const auto mesh = meshOf(hillyGrid(59, 59));
  expectNearLeast(mesh, segmentsOf(*mesh, rowOf(60, 20)));
}

TEST(ManySeeds, EveryPointIsItsOwn)
{
  const Surface grid = hillyGrid(39, 39);
  const auto mesh = meshOf(grid);
  const auto seeds = seedsAt(*mesh, randomPoints(grid, grid.points.size()));
  FastMarchingSolver fast(mesh);
  ReferenceSolver reference(mesh);
  for (FrontSolver* solver : std::initializer_list<FrontSolver*>{ &fast, &reference })
  {
    const DistanceField& field = solver->solve(seeds);
    for (Index s = 0; s < seeds.size(); ++s)
    {
      const Index vertex = mesh->triangle(seeds[s].points[0].triangle)[static_cast<std::size_t>(
        std::max_element(seeds[s].points[0].weights.begin(), seeds[s].points[0].weights.end()) -
        seeds[s].points[0].weights.begin())];
      ASSERT_EQ(field.distance(vertex), 0.0);
      ASSERT_EQ(field.nearestSeed(vertex), s);
    }
  }
}

TEST(ManySeeds, OfTwoAtEachPointTheFirstIsTheNearest)
{
  const Surface grid = hillyGrid(29, 29);
  const auto mesh = meshOf(grid);
  auto seeds = seedsAt(*mesh, randomPoints(grid, grid.points.size()));
  const auto count = static_cast<Index>(seeds.size());
  const auto again = seedsAt(*mesh, rowOf(count, 0));
  seeds.insert(seeds.end(), again.begin(), again.end());
  for (Seed& seed : seeds)
  {
    seed.value = 5.0;
  }
  FastMarchingSolver solver(mesh);
  EXPECT_EQ(stepsOf(solver, seeds), 0u);
  const DistanceField& field = solver.solve(seeds);
  std::vector<std::uint8_t> isNearest(count);
  for (Index vertex = 0; vertex < count; ++vertex)
  {
    ASSERT_EQ(field.distance(vertex), 5.0);
    ASSERT_LT(field.nearestSeed(vertex), count);
    isNearest[field.nearestSeed(vertex)] = 1;
  }
  EXPECT_EQ(std::count(isNearest.begin(), isNearest.end(), 1), count);
  // The next run begins anew.
  EXPECT_GT(solver.solve(std::vector<Seed>{ seeds[0] }).largestDistance(), 30.0);
}

// Nothing goes on from triangles that hang together with no other: their corners have start values.
TEST(ManySeeds, InTrianglesApartNoVertexWaits)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Surface surface;
  std::vector<Seed> seeds;
  for (Index t = 0; t < 1000; ++t)
  {
    surface.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
    for (int corner = 0; corner < 3; ++corner)
    {
      surface.points.push_back({ 2.0 * t + uniform(random), uniform(random), uniform(random) });
    }
  }
  const auto mesh = meshOf(surface);
  for (Index t = 0; t < 1000; t += 2)
  {
    seeds.push_back(Seed::atPoint({ t, { 0.2, 0.3, 0.5 } }));
  }
  FastMarchingSolver solver(mesh);
  EXPECT_EQ(stepsOf(solver, seeds), 0u);
  const DistanceField& field = solver.solve(seeds);
  EXPECT_EQ(field.reached().size(), 3 * seeds.size());
  for (Index s = 0; s < seeds.size(); ++s)
  {
    for (const Index corner : mesh->triangle(seeds[s].points[0].triangle))
    {
      EXPECT_NEAR(field.distance(corner),
        norm(mesh->position(corner) - mesh->positionOf(seeds[s].points[0])), 1e-12);
      EXPECT_EQ(field.nearestSeed(corner), s);
    }
  }
}

// On large meshes vertices wait in groups by their place.
TEST(ManySeeds, OnALargeMeshBothTiersAgree)
{
  const Surface grid = hillyGrid(279, 279);
  const auto mesh = meshOf(grid);
  const auto seeds = seedsAt(*mesh, randomPoints(grid, 1000));
  const auto fast = distances<FastMarchingSolver>(mesh, seeds);
  const auto reference = distances<ReferenceSolver>(mesh, seeds);
  for (std::size_t i = 0; i < fast.size(); ++i)
  {
    ASSERT_NEAR(fast[i], reference[i], 1e-9 * 20.0);
  }
}

// Few values: a vertex is taken as often as for some single fields, whatever the number of seeds.
TEST(ManySeeds, StepsDoNotGrowWithTheirNumber)
{
  const Surface grid = hillyGrid(89, 89);
  const auto mesh = meshOf(grid);
  FastMarchingSolver solver(mesh);
  const std::size_t vertices = grid.points.size();
  for (const std::size_t count : { 30u, 300u, 3000u })
  {
    EXPECT_LT(stepsOf(solver, seedsAt(*mesh, randomPoints(grid, count))), 5 * vertices);
  }
  EXPECT_LT(stepsOf(solver, seedsAt(*mesh, rowOf(90, 45))), 6 * vertices);
  EXPECT_LT(stepsOf(solver, segmentsOf(*mesh, rowOf(90, 45))), 6 * vertices);
}

// So with seeds that crowd where mean edges say nothing: on needles, and beside coarse parts.
TEST(ManySeeds, StepsDoNotGrowWhereEdgesDiffer)
{
  std::vector<Index> quarter(250);
  std::iota(quarter.begin(), quarter.end(), 0);
  const auto needles = meshOf(planeGrid(1000, 1, 0.2, 1.0));
  FastMarchingSolver onNeedles(needles);
  EXPECT_LT(stepsOf(onNeedles, seedsAt(*needles, quarter)), 6 * needles->numberOfVertices());

  Surface coarse = planeGrid(60, 60, 60.0, 60.0);
  for (Vector3& point : coarse.points)
  {
    point.z = 100.0;
  }
  const auto both = meshOf(joined(planeGrid(60, 60, 1.0, 1.0), coarse));
  std::vector<Seed> seeds;
  for (int s = 0; s < 200; ++s)
  {
    seeds.push_back(seedNear(both, { 0.5 + 1e-5 * s, 0.5 + 1e-5 * (s * s % 700), 0.0 }));
  }
  FastMarchingSolver onBoth(both);
  EXPECT_LT(stepsOf(onBoth, seeds), 4 * both->numberOfVertices());
}

// The distance is straight there, so the truth is known for as many as one likes.
TEST(ManySeeds, ACrowdInOneFaceIsNearTheLeast)
{
  const auto mesh = meshOf(planeGrid(30, 30, 30.0, 30.0));
  const Vector3 corner{ 15.0, 15.0, 0.0 };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 0.5);
  std::vector<Seed> seeds;
  std::vector<Vector3> places;
  for (int s = 0; s < 2000; ++s)
  {
    const double x = uniform(random);
    seeds.push_back(seedNear(mesh, { corner.x + x, corner.y + uniform(random), 0.0 }));
    places.push_back(mesh->positionOf(seeds.back().points[0]));
  }
  FastMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(seeds);
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    double truth = DistanceField::Unreached;
    for (const Vector3& place : places)
    {
      truth = std::min(truth, norm(place - mesh->position(v)));
    }
    const double edge = mesh->meanLongestEdge();
    ASSERT_NEAR(field.distance(v), truth, 0.5 * edge);
    ASSERT_NEAR(norm(places[field.nearestSeed(v)] - mesh->position(v)), truth, edge);
  }
}

// Thousands of sheets at one edge: each value that goes on from its ends goes into all of them.
TEST(ManySeeds, AnEdgeOfManySheetsPassesOnTheNearest)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(-0.5, 1.5);
  const auto pagesOfRandomHeights = [&](Index count)
  {
    Surface surface = pages(count);
    for (Index point = 2; point < surface.points.size(); ++point)
    {
      surface.points[point].z = height(random);
    }
    return meshOf(surface);
  };
  const auto seedsOn = [](const TriangleMesh& mesh)
  {
    std::vector<Seed> seeds;
    for (Index point = 2; point < mesh.numberOfPoints(); point += 4)
    {
      seeds.push_back(seedAt(mesh, point));
    }
    return seeds;
  };
  const auto mesh = pagesOfRandomHeights(2000);
  const std::vector<Seed> seeds = seedsOn(*mesh);
  const auto truth = distances<ExactSolver>(mesh, seeds);
  const auto found = distances<FastMarchingSolver>(mesh, seeds);
  const auto reference = distances<ReferenceSolver>(mesh, seeds);
  double sum = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_NEAR(found[i], truth[i], 0.1 * mesh->meanLongestEdge());
    ASSERT_NEAR(found[i], reference[i], 1e-9);
    sum += std::abs(found[i] - truth[i]);
  }
  EXPECT_LT(sum / static_cast<double>(found.size()), 0.01 * mesh->meanLongestEdge());
  const auto stepsOn = [&](Index count)
  {
    const auto larger = pagesOfRandomHeights(count);
    FastMarchingSolver solver(larger);
    return static_cast<double>(stepsOf(solver, seedsOn(*larger)));
  };
  const double steps = stepsOn(5000);
  // 4.0 times; 5.6 times on one number at a time. If each value went into each sheet: 16 times.
  EXPECT_LT(stepsOn(20000), 6.0 * steps);
}

TEST(ManySeeds, BothTiersAgree)
{
  const Surface grid = hillyGrid(69, 69);
  const auto mesh = meshOf(grid);
  for (const auto& seeds : { seedsAt(*mesh, randomPoints(grid, 500)), seedsAt(*mesh, rowOf(70, 20)),
         segmentsOf(*mesh, rowOf(70, 50)) })
  {
    const auto fast = distances<FastMarchingSolver>(mesh, seeds);
    const auto reference = distances<ReferenceSolver>(mesh, seeds);
    for (std::size_t i = 0; i < fast.size(); ++i)
    {
      ASSERT_NEAR(fast[i], reference[i], 1e-9 * 70.0);
    }
  }
}

// A mesh sorts its vertices by place, so the other surface is turned as well.
TEST(ManySeeds, TheOrderOfPointsDoesNotMatter)
{
  const Surface grid = hillyGrid(69, 69);
  const auto mesh = meshOf(grid);
  std::vector<Index> newId;
  Surface turned = shuffled(grid, 3, newId);
  for (Vector3& p : turned.points)
  {
    p = { p.z, -p.x, p.y };
  }
  const auto other = meshOf(turned);
  for (const auto& points : { randomPoints(grid, 400), rowOf(70, 30) })
  {
    std::vector<Index> moved;
    std::transform(
      points.begin(), points.end(), std::back_inserter(moved), [&](Index i) { return newId[i]; });
    const auto here = distances<FastMarchingSolver>(mesh, seedsAt(*mesh, points));
    const auto there = distances<FastMarchingSolver>(other, seedsAt(*other, moved));
    for (Index i = 0; i < here.size(); ++i)
    {
      ASSERT_NEAR(here[i], there[newId[i]], 1e-9 * 70.0);
    }
  }
}

// Vertices that no label reached have the nearest seed of a neighbour, and distances that depend on
// it. On subdivided needles many ways from one to the other are equally long.
TEST(ManySeeds, WhichOfEquallyNearOnesCountsDoesNotDependOnTheOrder)
{
  for (unsigned number = 0; number < 30; ++number)
  {
    const Surface surface = subdivided(randomSurface(MeshKind::Needles, number), 2);
    std::vector<Index> newId;
    const auto mesh = meshOf(surface);
    const auto other = meshOf(shuffled(surface, number + 1, newId));
    std::mt19937 random(number);
    std::vector<Index> points(surface.points.size());
    std::iota(points.begin(), points.end(), Index{ 0 });
    std::shuffle(points.begin(), points.end(), random);
    points.resize(points.size() / 3);
    std::vector<Index> moved;
    std::transform(
      points.begin(), points.end(), std::back_inserter(moved), [&](Index i) { return newId[i]; });
    const auto here = distances<FastMarchingSolver>(mesh, seedsAt(*mesh, points));
    const auto there = distances<FastMarchingSolver>(other, seedsAt(*other, moved));
    for (Index point = 0; point < here.size(); ++point)
    {
      ASSERT_NEAR(here[point], there[newId[point]], 1e-9) << number;
    }
  }
}

// At the edges of a torus with a square cross section the faces meet at right angles. What stands
// for the direction of the surface there decides which labels end, and it must not depend on the
// order of the triangles: on ranks that order differs from that on one.
TEST(ManySeeds, TheOrderOfTrianglesDoesNotMatter)
{
  for (unsigned number = 0; number < 20; ++number)
  {
    std::mt19937 random(number);
    Surface surface = torus(23, 4, 1.0, 0.4);
    std::lognormal_distribution<double> cost;
    std::vector<double> costs(surface.points.size());
    std::generate(costs.begin(), costs.end(), [&] { return cost(random); });
    const std::vector<Index> points = randomPoints(surface, 40);
    const auto solve = [&]
    {
      const auto mesh = meshOf(surface);
      SolveOptions options;
      std::vector<double> ofVertices(costs.size());
      for (Index i = 0; i < costs.size(); ++i)
      {
        ofVertices[mesh->vertexOfPoint(i)] = costs[i];
      }
      options.cost = ofVertices;
      return distances<FastMarchingSolver>(mesh, seedsAt(*mesh, points), options);
    };
    const auto before = solve();
    std::shuffle(surface.triangles.begin(), surface.triangles.end(), random);
    for (Triangle& t : surface.triangles)
    {
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    const auto after = solve();
    const double farthest = *std::max_element(before.begin(), before.end());
    for (Index i = 0; i < before.size(); ++i)
    {
      ASSERT_NEAR(after[i], before[i], 1e-9 * farthest) << number << " " << i;
    }
  }
}

// Thinned labels are compared along straight lines, which a cost that varies bends: 0.52 edges were
// measured.
TEST(ManySeeds, ACostIsHeeded)
{
  const Surface grid = hillyGrid(49, 49);
  const auto mesh = meshOf(grid);
  std::vector<double> cost(mesh->numberOfVertices());
  for (Index v = 0; v < cost.size(); ++v)
  {
    cost[v] = 1.0 + 0.5 * std::sin(mesh->position(v).x / 10.0);
  }
  SolveOptions options;
  options.cost = cost;
  expectNearLeast(mesh, seedsAt(*mesh, rowOf(50, 10)), options, 0.6);
  expectNearLeast(mesh, seedsAt(*mesh, randomPoints(grid, 100)), options, 0.6);
}

// Half an edge of a dear triangle is more than a way across much of the surface: with that as an
// allowance of the labels that last this took 14 times the steps of one seed, or more.
TEST(ManySeeds, StepsDoNotGrowWhereCostsAreSpread)
{
  const auto mesh = meshOf(hillyGrid(99, 99));
  std::mt19937 random(5);
  std::lognormal_distribution<double> any(0.0, 4.0);
  std::vector<double> cost(mesh->numberOfVertices());
  std::generate(cost.begin(), cost.end(), [&] { return any(random); });
  SolveOptions options;
  options.cost = cost;
  FastMarchingSolver solver(mesh);
  const auto stepsFrom = [&](const std::vector<Seed>& seeds)
  {
    std::size_t steps = 0;
    options.onProgress = [&](std::size_t taken)
    {
      steps = taken;
      return true;
    };
    solver.solve(seeds, options);
    return steps;
  };
  const std::size_t ofOne = stepsFrom(seedsAt(*mesh, { 5000 }));
  EXPECT_LT(stepsFrom(seedsAt(*mesh, randomPoints(hillyGrid(99, 99), 100))), 6 * ofOne);
}

// A wall between the seeds and a part of the surface, with a gap at one end.
TEST(ManySeeds, ABarrierIsHeeded)
{
  constexpr Index side = 50;
  const auto mesh = meshOf(hillyGrid(side - 1, side - 1));
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices());
  for (Index i = 0; i + 5 < side; ++i)
  {
    excluded[mesh->vertexOfPoint(25 * side + i)] = 1;
  }
  SolveOptions options;
  options.excluded = excluded;
  const auto seeds = seedsAt(*mesh, rowOf(side, 20));
  FastMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(seeds, options);
  EXPECT_EQ(field.reached().size(), side * side - (side - 5));
  for (const Index vertex : field.reached())
  {
    EXPECT_NE(field.nearestSeed(vertex), NoIndex);
  }
}

TEST(ManySeeds, PartsWithoutSeedsStayUnreached)
{
  const Surface grid = hillyGrid(19, 19);
  const auto mesh = meshOf(joined(grid, grid));
  std::vector<Index> points;
  for (Index i = 0; i < 100; ++i)
  {
    points.push_back(i);
  }
  FastMarchingSolver solver(mesh);
  EXPECT_EQ(solver.solve(seedsAt(*mesh, points)).reached().size(), grid.points.size());
}

TEST(ManySeeds, SparseOnesAreNotDense)
{
  const auto mesh = meshOf(planeGrid(200, 200, 200.0, 200.0));
  const auto pointsEvery = [](Index step)
  {
    std::vector<Index> points;
    for (Index y = 0; y <= 200; y += step)
    {
      for (Index x = 0; x <= 200; x += step)
      {
        points.push_back(y * 201 + x);
      }
    }
    return points;
  };
  EXPECT_FALSE(areDense(*mesh, seedsAt(*mesh, pointsEvery(25))));
  EXPECT_FALSE(areDense(*mesh, seedsAt(*mesh, pointsEvery(20))));
  EXPECT_TRUE(areDense(*mesh, seedsAt(*mesh, pointsEvery(10))));
  EXPECT_TRUE(areDense(*mesh, seedsAt(*mesh, rowOf(201, 100))));
  EXPECT_FALSE(areDense(*mesh, seedsAt(*mesh, { 0, 1, 2, 3 })));
}

TEST(ManySeeds, TheyMayBeCancelledInEitherMarch)
{
  const auto mesh = meshOf(hillyGrid(59, 59));
  const auto seeds = seedsAt(*mesh, rowOf(60, 30));
  FastMarchingSolver solver(mesh);
  const std::size_t steps = stepsOf(solver, seeds);
  for (const std::size_t end : { steps / 8, steps - 200 })
  {
    SolveOptions options;
    options.onProgress = [&](std::size_t taken) { return taken < end; };
    EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
  }
  EXPECT_EQ(stepsOf(solver, seeds), steps);
}
