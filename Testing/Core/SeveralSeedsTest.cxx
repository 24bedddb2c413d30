// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Several seeds: the minimum of their fields, without mixing them.

#include "ExactDistances.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

struct Nearest
{
  double distance;
  Index seed;
};

Nearest nearestOf(const std::vector<Vector3>& sources, const Vector3& p)
{
  Nearest nearest{ norm(sources[0] - p), 0 };
  for (Index s = 1; s < sources.size(); ++s)
  {
    if (norm(sources[s] - p) < nearest.distance)
    {
      nearest = { norm(sources[s] - p), s };
    }
  }
  return nearest;
}

/**
 * Seeds anywhere on a random plane: the truth is the distance to the nearest in a straight line.
 * @param tolerance of distances; that of the nearest seed's distance is twice as large
 */
void checkRandomSeeds(Index numberOfSeeds, const Surface& plane, double tolerance = 1e-9)
{
  const auto mesh = meshOf(plane);
  std::mt19937 random(numberOfSeeds);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Seed> seeds;
  std::vector<Vector3> sources;
  for (Index s = 0; s < numberOfSeeds; ++s)
  {
    const double x = uniform(random);
    seeds.push_back(seedNear(mesh, { x, uniform(random), 0.0 }));
    sources.push_back(mesh->positionOf(seeds.back().points[0]));
  }
  FastMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(seeds);
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    const Nearest truth = nearestOf(sources, mesh->position(v));
    ASSERT_NEAR(field.distance(v), truth.distance, tolerance);
    const double toFound = norm(sources[field.nearestSeed(v)] - mesh->position(v));
    ASSERT_NEAR(toFound, truth.distance, 2.0 * tolerance);
  }
}

}

TEST(SeveralSeeds, TwoAreTheMinimumOfBoth)
{
  checkRandomSeeds(2, delaunayPlane(5000, 1));
}

TEST(SeveralSeeds, ManyAreTheMinimumOfAll)
{
  // So dense that values are bounded (see LabelBounds): half an edge. 0.52 was measured.
  const Surface plane = delaunayPlane(5000, 2);
  checkRandomSeeds(300, plane, 0.55 * meshOf(plane)->meanLongestEdge());
}

// So many vertices that fronts are in groups, which take turns.
TEST(SeveralSeeds, GroupsOfManyAreTheMinimumOfAll)
{
  checkRandomSeeds(24, delaunayPlane(70000, 4));
}

// Edge lengths over three orders of magnitude: the margin of what a vertex keeps is local.
TEST(SeveralSeeds, MixedEdgeLengthsAreNoLessExact)
{
  checkRandomSeeds(20, delaunayPlane(3000, 3, 3.0));
}

// The ring of the tip is longer than what is looked at in one go.
TEST(SeveralSeeds, ATipOfManyTrianglesKeepsThemApart)
{
  const auto mesh = meshOf(cone(600, 12, 1.0, 1.2));
  std::vector<Seed> seeds;
  for (Index s = 0; s < 24; ++s)
  {
    const double angle = 0.05 + 2.0 * std::numbers::pi * s / 24.0;
    const double radius = 0.3 + 0.01 * (s * 7 % 24);
    seeds.push_back(
      seedNear(mesh, { radius * std::cos(angle), radius * std::sin(angle), -0.66 * radius }));
  }
  const std::vector<double> together = distances<FastMarchingSolver>(mesh, seeds);
  std::vector<double> least(together.size(), DistanceField::Unreached);
  for (const Seed& seed : seeds)
  {
    const std::vector<double> alone = distances<FastMarchingSolver>(mesh, { seed });
    std::transform(alone.begin(), alone.end(), least.begin(), least.begin(),
      [](double a, double b) { return std::min(a, b); });
  }
  for (std::size_t i = 0; i < together.size(); ++i)
  {
    ASSERT_NEAR(together[i], least[i], 1e-8);
  }
}

TEST(SeveralSeeds, TiesGoToTheSmallerNumber)
{
  const Surface plane = planeGrid(10, 10, 1.0, 1.0);
  const auto mesh = meshOf(plane);
  const std::vector<Seed> seeds{ seedAt(*mesh, 10), seedAt(*mesh, 0), seedAt(*mesh, 0) };
  FastMarchingSolver march(mesh);
  DijkstraSolver edges(mesh);
  ExactSolver exact(mesh);
  for (DistanceSolver* solver : std::initializer_list<DistanceSolver*>{ &march, &edges, &exact })
  {
    const DistanceField& field = solver->solve(seeds, {});
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(5)), 0u);
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(2)), 1u);
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(8)), 0u);
  }
}

TEST(SeveralSeeds, AValueIsAHeadStartOfTheOthers)
{
  const Surface plane = delaunayPlane(3000, 4);
  const auto mesh = meshOf(plane);
  Seed late = seedNear(mesh, { 0.3, 0.5, 0.0 });
  late.value = 0.25;
  const Seed early = seedNear(mesh, { 0.7, 0.5, 0.0 });
  const auto alone = distances<FastMarchingSolver>(mesh, { late });
  const auto both = distances<FastMarchingSolver>(mesh, { late, early });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    const double fromLate = 0.25 + norm(plane.points[i] - mesh->positionOf(late.points[0]));
    const double fromEarly = norm(plane.points[i] - mesh->positionOf(early.points[0]));
    EXPECT_NEAR(alone[i], fromLate, 1e-9);
    EXPECT_NEAR(both[i], std::min(fromLate, fromEarly), 1e-9);
  }
}

// Of equally near seeds the smallest counts, also where another one's front comes first.
TEST(SeveralSeeds, AlongEdgesTheSmallestOfEquallyNearOnesCounts)
{
  // Along the lower row the seeds are 5 from the middle: seed 0 by steps of 4 and 1, seed 1 by
  // steps of 3 and 2, so that its front leaves for the middle first.
  Surface strip;
  for (const double x : { 0.0, 4.0, 5.0, 7.0, 10.0 })
  {
    strip.points.push_back({ x, 0.0, 0.0 });
    strip.points.push_back({ x, 100.0, 0.0 });
  }
  for (Index i = 0; i < 8; i += 2)
  {
    strip.triangles.push_back({ i, i + 2, i + 1 });
    strip.triangles.push_back({ i + 2, i + 3, i + 1 });
  }
  const auto mesh = meshOf(strip);
  constexpr Index middle = 4;
  for (const auto& [first, second] : { std::pair{ 0u, 8u }, std::pair{ 8u, 0u } })
  {
    DijkstraSolver solver(mesh);
    const std::vector<Seed> seeds{ seedAt(*mesh, first), seedAt(*mesh, second) };
    const DistanceField& field = solver.solve(seeds, {});
    EXPECT_EQ(field.distance(mesh->vertexOfPoint(middle)), 5.0);
    EXPECT_EQ(field.nearestSeed(mesh->vertexOfPoint(middle)), 0u) << "from point " << first;
  }
}
