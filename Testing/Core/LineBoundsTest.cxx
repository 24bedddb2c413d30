// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Seeds that are dense but have room: straight lines through space bound the values that count, and
// are found out where the surface is not as they say.

#include "RandomMeshes.h"
#include "Solving.h"
#include "Surfaces.h"
#include "base/WorkCount.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "march/StraightLines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Unit squares, bent to a sheet of two layers above each other. */
Surface foldedGrid(Index side, double gap)
{
  Surface surface = planeGrid(2 * side, side, 2.0 * side, side);
  for (Vector3& point : surface.points)
  {
    const bool isAbove = point.x > side;
    point.z = isAbove ? gap : 0.0;
    point.x = isAbove ? 2.0 * side - point.x : point.x;
  }
  return surface;
}

/** A strip of unit squares, rolled up. */
Surface scroll(Index length, Index width)
{
  Surface surface = planeGrid(length, width, length, width);
  double angle = 0.0;
  for (Index i = 0; i <= length; ++i)
  {
    const double radius = 20.0 + 0.2 * angle;
    for (Index j = 0; j <= width; ++j)
    {
      Vector3& point = surface.points[j * (length + 1) + i];
      point = { radius * std::cos(angle), radius * std::sin(angle), point.y };
    }
    angle += 1.0 / radius;
  }
  return surface;
}

/** Closed triangles: walls across a grid, open at either end in turn. */
std::vector<std::uint8_t> wallsOf(const TriangleMesh& mesh, double spacing)
{
  const double width = std::ranges::max(mesh.positions(), {}, &Vector3::y).y;
  std::vector<std::uint8_t> closed(mesh.numberOfTriangles());
  for (Index t = 0; t < closed.size(); ++t)
  {
    const Triangle& corners = mesh.triangle(t);
    const Vector3 middle = (1.0 / 3.0) *
      (mesh.position(corners[0]) + mesh.position(corners[1]) + mesh.position(corners[2]));
    // A column of squares each.
    const double number = std::floor(middle.x / spacing);
    const double along = std::fmod(number, 2.0) == 0.0 ? middle.y : width - middle.y;
    const bool isWall = number > 0.0 && middle.x < number * spacing + 1.0;
    closed[t] = isWall && along < width - 3.0 ? 1 : 0;
  }
  return closed;
}

std::vector<Seed> randomSeeds(const TriangleMesh& mesh, std::size_t count, unsigned number = 1)
{
  std::mt19937 random(number);
  std::vector<Index> vertices(mesh.numberOfVertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  std::shuffle(vertices.begin(), vertices.end(), random);
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < count; ++i)
  {
    seeds.push_back(Seed::atPoint(mesh.pointAtVertex(vertices[i])));
  }
  return seeds;
}

/** Less than half an edge is what any dense seeds have; these have far less in the mean. */
void expectIsLeast(const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Seed>& seeds,
  double mean, const SolveOptions& options = {})
{
  const DifferenceToLeast difference = differenceToLeast(mesh, seeds, options);
  EXPECT_LT(difference.mean, mean);
  EXPECT_LT(difference.largest, 0.5);
}

std::size_t updatesFor(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, SolveOptions options = {})
{
  std::size_t updates = 0;
  options.progressInterval = 64;
  options.onProgress = [&](std::size_t taken)
  {
    EXPECT_GE(taken, updates);
    updates = taken;
    return true;
  };
  FastMarchingSolver(mesh).solve(seeds, options);
  return updates;
}

/** Both tiers, threads and other orders have the same field. */
void expectAgreement(const Surface& surface, const std::vector<Seed>& seeds,
  const std::shared_ptr<const TriangleMesh>& mesh, const SolveOptions& options = {})
{
  const auto reference = distances<ReferenceSolver>(mesh, seeds, options);
  const double allowed = 1e-9 * largestOf(reference);
  const auto expectSame = [&](const std::vector<double>& found, const std::string& what)
  {
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (found[i] != reference[i])
      {
        ASSERT_LE(std::abs(found[i] - reference[i]), allowed) << what << " at " << i;
      }
    }
  };
  expectSame(distances<FastMarchingSolver>(mesh, seeds, options), "batched");
  SolveOptions onThreads = options;
  onThreads.threads = 3;
  onThreads.verticesOfThread = 50;
  expectSame(distances<FastMarchingSolver>(mesh, seeds, onThreads), "on threads");
  if (options.closedTriangles.empty())
  {
    std::vector<Index> newId;
    const auto other = meshOf(shuffled(surface, 3, newId));
    std::vector<Seed> moved;
    for (const Seed& seed : seeds)
    {
      moved.push_back(seedNear(other, mesh->positionOf(seed.points[0])));
      moved.back().value = seed.value;
    }
    const auto found = distances<FastMarchingSolver>(other, moved, options);
    std::vector<double> inOrder(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      inOrder[i] = found[newId[i]];
    }
    expectSame(inOrder, "shuffled");
  }
}

}

TEST(LineBounds, LinesAreThoseToTheNearestPlace)
{
  for (const Index side : { 1u, 7u, 60u })
  {
    const auto mesh = meshOf(hillyGrid(side, side));
    std::mt19937 random(side);
    std::uniform_real_distribution<double> anywhere(-0.5 * side, 1.5 * side);
    for (const std::size_t count : { 1u, 3u, 200u })
    {
      std::vector<Vector3> places(count);
      for (Vector3& place : places)
      {
        place = { anywhere(random), anywhere(random), anywhere(random) };
      }
      StraightLines lines(mesh->positions());
      for (const double most : { 0.3 * side, std::numeric_limits<double>::infinity() })
      {
        std::vector<double> found(mesh->numberOfVertices(), -1.0);
        lines.measure(places, most,
          [&](Index first, std::span<const double> squares)
          { std::copy(squares.begin(), squares.end(), found.begin() + first); });
        for (Index vertex = 0; vertex < found.size(); ++vertex)
        {
          double least = std::numeric_limits<double>::infinity();
          for (const Vector3& place : places)
          {
            const Vector3 line = mesh->position(vertex) - place;
            least = std::min(least, dot(line, line));
          }
          // What is farther may be left out, or have the line to another place.
          if (found[vertex] >= 0.0 ? found[vertex] <= most * most : least <= most * most)
          {
            ASSERT_DOUBLE_EQ(found[vertex], least) << vertex;
          }
        }
      }
    }
  }
}

// Two marches take 2.4 updates a vertex on hills, and are 2.9e-3 edges off in the mean.
TEST(LineBounds, OneMarchIsEnoughOnHills)
{
  const auto mesh = meshOf(hillyGrid(99, 99));
  const auto seeds = randomSeeds(*mesh, 100);
  EXPECT_LT(updatesFor(mesh, seeds), 1.7 * mesh->numberOfVertices());
  expectIsLeast(mesh, seeds, 2e-3);
}

// The other layer is near in space alone: seeds on one layer only, on both, and a barrier.
TEST(LineBounds, FoldsAreFoundOut)
{
  const Surface surface = foldedGrid(50, 0.3);
  const auto mesh = meshOf(surface);
  const auto all = randomSeeds(*mesh, 75);
  std::vector<Seed> below;
  std::copy_if(all.begin(), all.end(), std::back_inserter(below),
    [&](const Seed& seed) { return mesh->positionOf(seed.points[0]).z == 0.0; });
  const auto few = static_cast<std::ptrdiff_t>(below.size()) + 6;
  for (const Seed& seed : all)
  {
    const bool isBelow = mesh->positionOf(seed.points[0]).z == 0.0;
    if (!isBelow && static_cast<std::ptrdiff_t>(below.size()) < few)
    {
      below.push_back(seed);
    }
  }
  for (const std::vector<Seed>& seeds : { all, below })
  {
    expectIsLeast(mesh, seeds, 5e-3);
    expectAgreement(surface, seeds, mesh);
  }
}

TEST(LineBounds, BarriersAreFoundOut)
{
  const Surface surface = hillyGrid(80, 80);
  const auto mesh = meshOf(surface);
  const auto seeds = randomSeeds(*mesh, 80);
  auto closed = wallsOf(*mesh, 9.0);
  SolveOptions options;
  options.closedTriangles = closed;
  for (const Seed& seed : seeds)
  {
    for (Index t = 0; t < closed.size(); ++t)
    {
      const Triangle& corners = mesh->triangle(t);
      const Triangle& ofSeed = mesh->triangle(seed.points[0].triangle);
      const bool isBeside = std::any_of(corners.begin(), corners.end(),
        [&](Index c) { return std::find(ofSeed.begin(), ofSeed.end(), c) != ofSeed.end(); });
      closed[t] = isBeside ? 0 : closed[t];
    }
  }
  expectIsLeast(mesh, seeds, 5e-3, options);
  expectAgreement(surface, seeds, mesh, options);
}

// Two marches take over where lines are hardly ever right.
TEST(LineBounds, RoughSurfacesAreFoundOut)
{
  const Surface surface = roughGrid(80);
  const auto mesh = meshOf(surface);
  const auto seeds = randomSeeds(*mesh, 80);
  EXPECT_LT(updatesFor(mesh, seeds), 4.0 * mesh->numberOfVertices());
  expectIsLeast(mesh, seeds, 0.02);
  expectAgreement(surface, seeds, mesh);
}

TEST(LineBounds, AnyMeshHasOneField)
{
  for (const MeshKind kind : { MeshKind::Closed, MeshKind::Terrain, MeshKind::Torus,
         MeshKind::Holes, MeshKind::NonManifold, MeshKind::Parts })
  {
    SCOPED_TRACE(nameOf(kind));
    Surface surface = randomSurface(kind, 5);
    while (surface.points.size() < 2000)
    {
      surface = subdivided(surface, 1);
    }
    const auto mesh = meshOf(surface);
    std::vector<Seed> seeds = randomSeeds(*mesh, mesh->numberOfVertices() / 70);
    expectAgreement(surface, seeds, mesh);
    for (Seed& seed : seeds)
    {
      seed.value = 12.5;
    }
    expectAgreement(surface, seeds, mesh);
  }
}

// What lies within a stop is as without it, also where seeds are far away.
TEST(LineBounds, StopsChangeNothingBeforeThem)
{
  const Surface surface = foldedGrid(50, 0.3);
  const auto mesh = meshOf(surface);
  auto seeds = randomSeeds(*mesh, 150);
  std::erase_if(seeds,
    [&](const Seed& seed)
    {
      const Vector3 place = mesh->positionOf(seed.points[0]);
      return place.z > 0.0 && (place.x < 40.0 || place.y < 25.0);
    });
  seeds.resize(75);
  const auto whole = distances<FastMarchingSolver>(mesh, seeds);
  SolveOptions near;
  near.maximumDistance = 0.4 * largestOf(whole);
  const std::vector<Triangle> targets{ mesh->triangle(17), mesh->triangle(4711) };
  SolveOptions towards;
  towards.targets = targets;
  for (const SolveOptions& options : { near, towards })
  {
    const auto stopped = distances<FastMarchingSolver>(mesh, seeds, options);
    EXPECT_GT(std::count(stopped.begin(), stopped.end(), DistanceField::Unreached), 0);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      if (stopped[i] < DistanceField::Unreached)
      {
        ASSERT_NEAR(stopped[i], whole[i], 1e-9 * largestOf(whole)) << i;
      }
      else
      {
        ASSERT_GT(whole[i], options.targets.empty() ? near.maximumDistance : 0.0);
      }
    }
    expectAgreement(surface, seeds, mesh, near);
  }
}

// A corridor that walls make, with seeds in its first part: no more labels go on far away than
// after a first march, and what is before a stop does not depend on it.
TEST(LineBounds, FarPartsHaveFewLabels)
{
  const Surface surface = hillyGrid(80, 80);
  const auto mesh = meshOf(surface);
  const auto closed = wallsOf(*mesh, 8.0);
  auto seeds = randomSeeds(*mesh, 400);
  std::erase_if(seeds, [&](const Seed& seed) { return mesh->positionOf(seed.points[0]).x > 18.0; });
  seeds.resize(80);
  SolveOptions options;
  options.closedTriangles = closed;
  EXPECT_LT(updatesFor(mesh, seeds, options), 4.0 * mesh->numberOfVertices());
  expectIsLeast(mesh, seeds, 0.05, options);
  expectAgreement(surface, seeds, mesh, options);
  const auto whole = distances<FastMarchingSolver>(mesh, seeds, options);
  EXPECT_GT(largestOf(whole), 400.0);
  for (const double part : { 0.02, 0.1, 0.3, 0.9 })
  {
    options.maximumDistance = part * largestOf(whole);
    const auto stopped = distances<FastMarchingSolver>(mesh, seeds, options);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      if (stopped[i] < DistanceField::Unreached)
      {
        ASSERT_NEAR(stopped[i], whole[i], 1e-9 * largestOf(whole)) << part << " at " << i;
      }
    }
  }
}

// Vertices that are in no label's bounds take seeds of their neighbours, one after the other. When
// all of them were looked at each time that took 5 s here.
TEST(LineBounds, AScrollIsSoonAtItsEnd)
{
  const auto mesh = meshOf(scroll(4000, 40));
  auto seeds = randomSeeds(*mesh, 8000);
  std::erase_if(seeds,
    [&](const Seed& seed)
    {
      const Vector3 place = mesh->positionOf(seed.points[0]);
      return std::hypot(place.x, place.y) > 22.0;
    });
  EXPECT_GT(seeds.size(), 300u);
  FastMarchingSolver solver(mesh);
  const std::size_t before = WorkCount::steps();
  const DistanceField& field = solver.solve(seeds);
  EXPECT_LT(WorkCount::steps() - before, 10u * mesh->numberOfVertices());
  for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
  {
    ASSERT_NE(field.nearestSeed(vertex), NoIndex);
  }
}

TEST(LineBounds, MayBeCancelledAtAnyTime)
{
  const auto mesh = meshOf(foldedGrid(50, 0.3));
  const auto seeds = randomSeeds(*mesh, 75);
  FastMarchingSolver solver(mesh);
  std::size_t reports = 0;
  SolveOptions options;
  options.progressInterval = 200;
  options.onProgress = [&](std::size_t)
  {
    ++reports;
    return true;
  };
  solver.solve(seeds, options);
  const auto whole = distances<FastMarchingSolver>(mesh, seeds);
  const std::size_t all = reports;
  EXPECT_GT(all, 20u);
  for (std::size_t last = 1; last < all; ++last)
  {
    std::size_t count = 0;
    options.onProgress = [&](std::size_t) { return ++count < last; };
    ASSERT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled) << last;
  }
  // Nothing is left of a cancelled run.
  const DistanceField& again = solver.solve(seeds);
  for (Index i = 0; i < whole.size(); ++i)
  {
    ASSERT_EQ(again.distance(mesh->vertexOfPoint(i)), whole[i]);
  }
}

// Seeds that have no room, or too much of it.
TEST(LineBounds, AllPointsMayBeInOnePlaceOrFarApart)
{
  for (const double factor : { 0.0, 1e-28, 1e27 })
  {
    Surface surface = hillyGrid(60, 60);
    for (Vector3& point : surface.points)
    {
      point = factor * point;
    }
    const auto mesh = meshOf(surface);
    const auto seeds = randomSeeds(*mesh, 50);
    const auto found = distances<FastMarchingSolver>(mesh, seeds);
    const auto reference = distances<ReferenceSolver>(mesh, seeds);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_NEAR(found[i], reference[i], 1e-9 * largestOf(reference)) << factor;
      ASSERT_LE(found[i], factor * 100.0);
    }
  }
}

// Values far above all distances leave the work as it is.
TEST(LineBounds, EqualValuesOfSeedsDoNotMatter)
{
  const auto mesh = meshOf(hillyGrid(99, 99));
  for (const std::size_t count : { 100u, 400u })
  {
    auto seeds = randomSeeds(*mesh, count);
    const auto plain = distances<FastMarchingSolver>(mesh, seeds);
    const std::size_t updates = updatesFor(mesh, seeds);
    for (Seed& seed : seeds)
    {
      seed.value = 1e5;
    }
    EXPECT_LT(updatesFor(mesh, seeds), 1.1 * updates);
    const auto late = distances<FastMarchingSolver>(mesh, seeds);
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      ASSERT_NEAR(late[i] - 1e5, plain[i], 1e-6);
    }
  }
}
