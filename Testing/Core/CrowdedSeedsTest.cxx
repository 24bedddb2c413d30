// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Seeds that crowd: many in a few triangles, along a curve, or along the long triangles of a CAD
// program. Of those that start in one triangle the nearest one of what is behind a side may be
// farther than others from both of its ends (see LabelBounds::excessAtStart()), and so it may be
// farther away, where it is the nearest in a strip narrower than an edge (see labelReaches()).

#include "ExactDistances.h"
#include "Solving.h"
#include "Surfaces.h"
#include "base/WorkCount.h"
#include "march/FastMarchingSolver.h"
#include "march/LabelDensity.h"
#include "march/LabelPlaces.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"
#include "solve/SeedFront.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Points in the triangles at a vertex. */
std::vector<Seed> crowdRound(const TriangleMesh& mesh, Index vertex, int count)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 0.5);
  const auto ring = mesh.ring(vertex);
  std::vector<Seed> seeds;
  for (int i = 0; i < count; ++i)
  {
    SurfacePoint point = mesh.pointAtVertex(ring[i % ring.size()].neighbour());
    const double first = uniform(random);
    const double second = uniform(random);
    point.weights = { first, second, 1.0 - first - second };
    seeds.push_back(Seed::atPoint(point));
  }
  return seeds;
}

/** Points in some triangles next to each other. */
std::vector<Seed> crowdIn(const TriangleMesh& mesh, Index triangles, int count)
{
  const auto centreOf = [&](Index triangle) {
    return mesh.positionOf(SurfacePoint{ triangle, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
  };
  const Vector3 centre = centreOf(mesh.numberOfTriangles() / 3);
  std::vector<Index> nearest(mesh.numberOfTriangles());
  std::iota(nearest.begin(), nearest.end(), Index{ 0 });
  std::partial_sort(nearest.begin(), nearest.begin() + triangles, nearest.end(),
    [&](Index a, Index b) { return norm(centreOf(a) - centre) < norm(centreOf(b) - centre); });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 0.5);
  std::vector<Seed> seeds;
  for (int i = 0; i < count; ++i)
  {
    const Index triangle = nearest[random() % triangles];
    const double first = uniform(random);
    const double second = uniform(random);
    seeds.push_back(Seed::atPoint({ triangle, { first, second, 1.0 - first - second } }));
  }
  return seeds;
}

/** Vertices, drawn at random. */
std::vector<Seed> someVertices(const TriangleMesh& mesh, Index count)
{
  std::vector<Index> vertices(mesh.numberOfVertices());
  std::iota(vertices.begin(), vertices.end(), Index{ 0 });
  std::shuffle(vertices.begin(), vertices.end(), std::mt19937(7));
  std::vector<Seed> seeds;
  for (Index i = 0; i < count; ++i)
  {
    seeds.push_back(Seed::atPoint(mesh.pointAtVertex(vertices[i])));
  }
  return seeds;
}

/** Where a curve crosses a triangle: from below 0 to above it, and back; nothing if it does not. */
template <class Height>
std::optional<std::array<SurfacePoint, 2>> crossingsOf(
  const TriangleMesh& mesh, Index triangle, const Height& height)
{
  const Triangle& corners = mesh.triangle(triangle);
  std::array<SurfacePoint, 2> crossings;
  bool isCrossed = false;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const double here = height(mesh.position(corners[i]));
    const double there = height(mesh.position(corners[j]));
    if ((here < 0.0) != (there < 0.0))
    {
      SurfacePoint& point = crossings[here < 0.0 ? 0 : 1];
      point = { triangle, {} };
      point.weights[i] = there / (there - here);
      point.weights[j] = 1.0 - point.weights[i];
      isCrossed = true;
    }
  }
  return isCrossed ? std::optional(crossings) : std::nullopt;
}

/** The points where a curve crosses the edges of a surface, each for itself. */
template <class Height>
std::vector<Seed> crossings(const TriangleMesh& mesh, const Height& height)
{
  std::vector<Seed> seeds;
  for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
  {
    if (const auto ends = crossingsOf(mesh, triangle, height))
    {
      seeds.push_back(Seed::atPoint((*ends)[0]));
    }
  }
  return seeds;
}

/** The parts of a curve in each triangle of a surface, as loose line cells. */
template <class Height>
std::vector<Seed> looseParts(const TriangleMesh& mesh, const Height& height)
{
  std::vector<Seed> seeds;
  for (Index triangle = 0; triangle < mesh.numberOfTriangles(); ++triangle)
  {
    if (const auto ends = crossingsOf(mesh, triangle, height))
    {
      seeds.push_back(Seed::alongCurve({ (*ends)[0], (*ends)[1] }));
    }
  }
  return seeds;
}

/** A twentieth of an edge in the mean, half an edge anywhere. */
void expectTheLeast(const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Seed>& seeds,
  double mean = 0.05)
{
  const DifferenceToLeast difference = differenceToLeast(mesh, seeds);
  EXPECT_LE(difference.mean, mean);
  EXPECT_LE(difference.largest, 0.5);
}

/** With a maximum distance, vertices have the distance that they have without one. */
void expectSameWithStops(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const std::vector<double>& stops)
{
  const auto whole = distances<FastMarchingSolver>(mesh, seeds);
  for (const double distance : stops)
  {
    SolveOptions options;
    options.maximumDistance = distance;
    const auto stopped = distances<FastMarchingSolver>(mesh, seeds, options);
    for (std::size_t vertex = 0; vertex < whole.size(); ++vertex)
    {
      const double expected = whole[vertex] <= distance ? whole[vertex] : DistanceField::Unreached;
      ASSERT_TRUE(stopped[vertex] == expected || std::abs(stopped[vertex] - expected) <= 1e-9)
        << distance << ": " << stopped[vertex] << " instead of " << expected;
    }
  }
}

}

TEST(CrowdedSeeds, ThoseInOneTriangleAreNearTheLeast)
{
  for (const Surface& surface :
    { delaunayPlane(3000, 3), hillyGrid(50, 50), roughGrid(50), torus(60, 30, 2.0, 0.7) })
  {
    const auto mesh = meshOf(surface);
    expectTheLeast(mesh, crowdRound(*mesh, 40, 100));
  }
}

TEST(CrowdedSeeds, TheNearestComesThroughNarrowStrips)
{
  for (const Surface& surface : { delaunayPlane(10000, 3), hillyGrid(100, 100), spot() })
  {
    const auto mesh = meshOf(surface);
    for (const Index triangles : { 2u, 12u, 60u, 400u })
    {
      expectTheLeast(mesh, crowdIn(*mesh, triangles, 80));
    }
  }
}

// Between two seeds the first march of all labels is straight, and less than from either. Where a
// quarter of the vertices are seeds that left a fiftieth of an edge in the mean.
TEST(CrowdedSeeds, BetweenTwoNothingIsNearerThanStraight)
{
  for (const Surface& surface : { delaunayPlane(4000, 3), hillyGrid(60, 60), icosphere(4) })
  {
    const auto mesh = meshOf(surface);
    for (const std::size_t part : { 4, 2 })
    {
      expectTheLeast(mesh, someVertices(*mesh, mesh->numberOfVertices() / part), 0.008);
    }
  }
}

TEST(CrowdedSeeds, LooseLinesAreNearTheLeast)
{
  const auto mesh = meshOf(spot());
  const Vector3 place = mesh->position(mesh->numberOfVertices() / 3);
  const std::vector<Seed> seeds = looseParts(*mesh,
    [&](const Vector3& p) {
      return dot(p - place, Vector3{ 0.8, 0.6, 0.13 }) + 0.02;
    });
  ASSERT_GT(seeds.size(), 50u);
  expectTheLeast(mesh, seeds, 0.06);
}

// Neither which labels last nor what is between two seeds depends on how far the field goes.
TEST(CrowdedSeeds, AStopDoesNotChangeThem)
{
  const auto crowded = meshOf(hillyGrid(100, 100));
  const auto scattered = meshOf(delaunayPlane(4000, 3));
  const double edge = scattered->meanLongestEdge();
  expectSameWithStops(crowded, crowdIn(*crowded, 60, 80), { 5.0, 15.0, 30.0, 60.0 });
  for (const std::size_t part : { 4, 30 })
  {
    expectSameWithStops(scattered, someVertices(*scattered, scattered->numberOfVertices() / part),
      { 0.4 * edge, 0.7 * edge, edge, 1.5 * edge, 3.0 * edge });
  }
}

TEST(CrowdedSeeds, ThoseAcrossLongTrianglesAreNearTheLeast)
{
  const auto mesh = meshOf(boxWithFillets(8));
  double size = 0.0;
  for (const Vector3& position : mesh->positions())
  {
    size = std::max(size, norm(position - mesh->positions()[0]));
  }
  const std::vector<Seed> seeds = crossings(*mesh,
    [&](const Vector3& p) {
      return std::sin(6.0 * p.x / size + 1.0) + std::cos(5.0 * p.y / size) - 3.0 * p.z / size - 0.4;
    });
  ASSERT_GT(seeds.size(), 100u);
  expectTheLeast(mesh, seeds);
}

// How far each matters is found between the marches, which takes longer than these where they are
// many. Each report between them counts as one step; in a march a hundred are from one to the next.
TEST(CrowdedSeeds, TheyMayBeCancelledBetweenTheMarches)
{
  const auto mesh = meshOf(hillyGrid(40, 40));
  const std::vector<Seed> seeds = crowdIn(*mesh, 400, 3000);
  FastMarchingSolver solver(mesh);
  const std::vector<double> whole(
    solver.solve(seeds).distances().begin(), solver.solve(seeds).distances().end());
  std::size_t last = 0;
  std::size_t between = 0;
  SolveOptions options;
  options.onProgress = [&](std::size_t taken)
  {
    between += taken == last + 1 ? 1 : 0;
    last = taken;
    return between < 3;
  };
  EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
  EXPECT_EQ(between, 3u);
  const auto again = solver.solve(seeds).distances();
  EXPECT_TRUE(std::equal(again.begin(), again.end(), whole.begin()));
}

// Few seeds that are close to one another all count at nearly all vertices: 24 took 150 times as
// long as one. A few more of them, far from one another, are no crowd.
TEST(CrowdedSeeds, FewInAPlaceAreCheap)
{
  const auto mesh = meshOf(planeGrid(120, 120, 120.0, 120.0));
  FastMarchingSolver solver(mesh);
  for (const Index triangles : { 2, 20, 200 })
  {
    for (const int count : { 5, 8, 16, 24 })
    {
      const std::vector<Seed> seeds = crowdIn(*mesh, triangles, count);
      std::size_t updates = 0;
      SolveOptions options;
      options.onProgress = [&](std::size_t taken)
      {
        updates = taken;
        return true;
      };
      const DistanceField& field = solver.solve(seeds, options);
      EXPECT_LE(updates, 12u * mesh->numberOfVertices()) << count << " in " << triangles;
      double sum = 0.0;
      for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
      {
        double least = DistanceField::Unreached;
        for (const Seed& seed : seeds)
        {
          least = std::min(least, norm(mesh->positionOf(seed.points[0]) - mesh->position(vertex)));
        }
        const double difference = std::abs(field.distance(vertex) - least);
        EXPECT_LE(difference, 0.5 * mesh->meanLongestEdge());
        sum += difference;
      }
      EXPECT_LE(sum, 0.05 * mesh->meanLongestEdge() * mesh->numberOfVertices());
    }
  }
  EXPECT_TRUE(areDense(*mesh, crowdIn(*mesh, 2, 5)));
  EXPECT_FALSE(areDense(*mesh, crowdIn(*mesh, 2, 4)));
  EXPECT_FALSE(areDense(*mesh, someVertices(*mesh, 24)));
  EXPECT_FALSE(areDense(*meshOf(planeGrid(90, 90, 1.0, 1.0)), crowdIn(*mesh, 2, 24)));
}

// Whether they are dense was told by looking from each at all others.
TEST(CrowdedSeeds, WhetherTheyAreDenseIsSoonTold)
{
  const auto mesh = meshOf(planeGrid(400, 400, 400.0, 400.0));
  const std::vector<Seed> seeds = crowdRound(*mesh, 80000, 2000);
  Partition partition;
  SeedFront front;
  makeSeedFront(*mesh, ClosedTriangles(*mesh, {}), seeds, false, goesOn, partition, front);
  const std::size_t before = WorkCount::steps();
  EXPECT_TRUE(labelsAreDense(*mesh, front, false, partition));
  EXPECT_LT(WorkCount::steps() - before, 10 * seeds.size());
}

// Which labels stand for each other depends on the side of the surface that they are on. Where
// triangles are not oriented alike, rings of vertices go round as the numbers of points have it.
TEST(CrowdedSeeds, EachFacesAsTheTriangleOfItsSeed)
{
  Surface surface = planeGrid(20, 20, 20.0, 20.0);
  for (std::size_t triangle = 0; triangle < surface.triangles.size(); triangle += 3)
  {
    std::swap(surface.triangles[triangle][0], surface.triangles[triangle][1]);
  }
  std::vector<Index> newId;
  const auto mesh = meshOf(shuffled(surface, 5, newId));
  std::vector<Seed> seeds;
  std::vector<double> sides;
  for (Index triangle = 0; triangle < mesh->numberOfTriangles(); ++triangle)
  {
    const Triangle& corners = mesh->triangle(triangle);
    const Vector3 first = mesh->position(corners[1]) - mesh->position(corners[0]);
    const Vector3 second = mesh->position(corners[2]) - mesh->position(corners[0]);
    for (const auto& weights :
      { std::array{ 0.0, 1.0, 0.0 }, std::array{ 0.0, 0.4, 0.6 }, std::array{ 0.2, 0.3, 0.5 } })
    {
      seeds.push_back(Seed::atPoint({ triangle, weights }));
      sides.push_back(cross(first, second).z > 0.0 ? 1.0 : -1.0);
    }
  }
  Partition partition;
  SeedFront front;
  makeSeedFront(*mesh, ClosedTriangles(*mesh, {}), seeds, false, goesOn, partition, front);
  const std::vector<LabelPlace> places = labelPlaces(*mesh, front, {}, goesOn, partition);
  ASSERT_EQ(places.size(), sides.size());
  for (std::size_t label = 0; label < places.size(); ++label)
  {
    EXPECT_EQ(places[label].normal.z, sides[label]);
  }
}

// Those within a cube of a grid count as one. Many coordinates are 0.
TEST(CrowdedSeeds, WhatRoundingLeavesDoesNotMatter)
{
  Surface grid = planeGrid(20, 20, 20.0, 20.0);
  for (Vector3& point : grid.points)
  {
    point = point - Vector3{ 10.2, 10.3, 0.0 };
  }
  const auto mesh = meshOf(grid);
  const auto fieldOf = [&](double rest)
  {
    std::vector<Seed> seeds;
    for (int i = 0; i < 60; ++i)
    {
      const Vector3 position{ i % 2 == 0 ? rest : 0.04, 0.01 * i, 0.0 };
      seeds.push_back(Seed::atPosition(position, seedNear(mesh, position).points));
    }
    FastMarchingSolver solver(mesh);
    const auto distances = solver.solve(seeds).distances();
    return std::vector<double>(distances.begin(), distances.end());
  };
  const std::vector<double> field = fieldOf(0.0);
  const std::vector<double> other = fieldOf(-1e-18);
  for (std::size_t vertex = 0; vertex < field.size(); ++vertex)
  {
    EXPECT_NEAR(field[vertex], other[vertex], 1e-10);
  }
}
