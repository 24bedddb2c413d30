// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Work grows with the input, also where a vertex has many triangles, and paths have many bends:
// steps are counted on an input of n and one of 4 n. Linear work grows 4 times, and n log n a
// little more; quadratic work grows 16 times.

#include "PathStyles.h"
#include "Solving.h"
#include "base/WorkCount.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"
#include "solve/RequestCheck.h"
#include "solve/SeedFront.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr double MostGrowth = 5.5;

/** @param work  called with a size */
template <class Work>
void expectGrowth(double most, Index size, const Work& work)
{
  const auto stepsOf = [&](Index n)
  {
    const std::size_t before = WorkCount::steps();
    work(n);
    return static_cast<double>(WorkCount::steps() - before);
  };
  const double steps = stepsOf(size);
  EXPECT_GT(steps, 0.0);
  EXPECT_LT(stepsOf(4 * size) / steps, most);
}

template <class Work>
void expectLinear(Index size, const Work& work)
{
  expectGrowth(MostGrowth, size, work);
}

/** The path between two points of the input. */
SurfacePath pathBetween(const Surface& surface, Index from, Index to)
{
  const auto mesh = meshOf(surface);
  const auto at = [&](Index point) { return mesh->pointAtVertex(mesh->vertexOfPoint(point)); };
  FastMarchingSolver solver(mesh);
  return shortestPath(solver, at(from), at(to), {}, Straight).value();
}

}

// The centre is a corner of all triangles.
TEST(Growth, TrianglesOfADisc)
{
  expectLinear(1000,
    [](Index around)
    {
      const auto mesh = meshOf(disc(around));
      const Index centre = mesh->vertexOfPoint(0);
      EXPECT_EQ(mesh->trianglesWith({ &centre, 1 }).size(), around);
      for (Index t = 0; t < mesh->numberOfTriangles(); ++t)
      {
        const Triangle& corners = mesh->triangle(t);
        EXPECT_EQ(mesh->trianglesWith(corners), std::vector{ t });
        EXPECT_EQ(mesh->trianglesWith(std::span(corners).first(2)).size(), 2);
        EXPECT_EQ(mesh->positionOf(mesh->pointAtVertex(corners[1])), mesh->position(corners[1]));
      }
    });
}

// No shortest path turns at the rim, but at its seed.
TEST(Growth, ExactDistancesFromTheRimOfADisc)
{
  expectLinear(500,
    [](Index around)
    {
      const Surface surface = disc(around);
      const std::vector<double> found =
        distances<ExactSolver>(meshOf(surface), { seedAt(*meshOf(surface), 1) });
      EXPECT_LT(relativeError(found, straightLines(surface, surface.points[1])).largest, 1e-9);
    });
}

// Each edge from the centre to the rim is far longer than the way from seed to seed. The areas
// nearest to n seeds among 10 n edges cross some n^1.5 of these: 8 times as many.
TEST(Growth, ExactDistancesFromManySeedsInADisc)
{
  expectGrowth(12.0, 1000,
    [](Index around)
    {
      const Surface surface = disc(around);
      const auto mesh = meshOf(surface);
      std::mt19937 random(1);
      std::uniform_real_distribution<double> part(0.0, 1.0);
      std::uniform_int_distribution<Index> triangle(0, around - 1);
      std::vector<Seed> seeds;
      std::vector<double> truth(surface.points.size(), DistanceField::Unreached);
      for (Index i = 0; i < around / 10; ++i)
      {
        const double a = part(random);
        const double b = (1.0 - a) * part(random);
        seeds.push_back(Seed::atPoint({ triangle(random), { a, b, 1.0 - a - b } }));
        const Vector3 place = mesh->positionOf(seeds.back().points[0]);
        for (Index point = 0; point < truth.size(); ++point)
        {
          truth[point] = std::min(truth[point], norm(surface.points[point] - place));
        }
      }
      const std::vector<double> found = distances<ExactSolver>(mesh, seeds);
      EXPECT_LT(relativeError(found, truth).largest, 1e-9);
    });
}

// All triangles have one edge, and seeds that are nearer and nearer to it. Each could send a window
// into each triangle, but only those that are nearest at a place of the edge may.
TEST(Growth, ExactDistancesFromManySeedsAtOneEdge)
{
  expectLinear(1000,
    [](Index count)
    {
      const Surface surface = pages(count);
      const auto mesh = meshOf(surface);
      const Index number = count / 10;
      std::vector<Seed> seeds;
      std::vector<double> truth(surface.points.size(), DistanceField::Unreached);
      double nearest = DistanceField::Unreached;
      for (Index i = 0; i < number; ++i)
      {
        nearest = 0.9 - 0.8 * i / number;
        SurfacePoint place{ i, {} };
        for (Index k = 0; k < 3; ++k)
        {
          const Index point = mesh->pointOfVertex(mesh->triangle(i)[k]);
          place.weights[k] = point < 2 ? 0.5 * (1.0 - nearest) : nearest;
          truth[point] = point < 2 ? truth[point] : 1.0 - nearest;
        }
        seeds.push_back(Seed::atPoint(place));
      }
      const std::vector<double> found = distances<ExactSolver>(mesh, seeds);
      EXPECT_NEAR(found[0], std::hypot(nearest, 0.5), 1e-12);
      for (Index point = 2; point < found.size(); ++point)
      {
        EXPECT_NEAR(found[point], std::min(truth[point], 1.0 + nearest), 1e-12);
      }
    });
}

// The path crosses edges from the centre to the rim.
TEST(Growth, PathAcrossADisc)
{
  expectLinear(1000,
    [](Index around)
    { EXPECT_GT(pathBetween(disc(around), 1, 1 + around / 3).size(), around / 4); });
}

// A trace follows the strip's borders, with many bends, each of which can be shortened. Up to a
// limit the straightener works off one after the other, so that a strip must not be short.
TEST(Growth, PathAlongAStrip)
{
  expectLinear(40000,
    [](Index cells)
    {
      const Surface strip = planeGrid(cells, 1, cells, 1.0);
      EXPECT_GT(pathBetween(strip, 0, 2 * cells + 1).size(), cells);
    });
}

// Paths from points beside each other to one of as many ends.
TEST(Growth, PathsFromManyStartsToManyEnds)
{
  expectLinear(100,
    [](Index count)
    {
      const auto mesh = meshOf(planeGrid(count, 8, count, 8.0));
      std::vector<SurfacePoint> starts;
      std::vector<SurfacePoint> ends;
      for (Index i = 0; i < count; ++i)
      {
        starts.push_back(mesh->pointAtVertex(mesh->vertexOfPoint(i)));
        ends.push_back(mesh->pointAtVertex(mesh->vertexOfPoint(8 * (count + 1) + i)));
      }
      FastMarchingSolver solver(mesh);
      PathFinder finder(solver, ends, {}, Straight);
      finder.march(starts);
      for (const SurfacePoint& start : starts)
      {
        // A tenth of an edge off at most: where ends are so dense, not all reach as far.
        EXPECT_NEAR(lengthOf(*mesh, finder.pathFrom(start).value()), 8.0, 0.1);
      }
    });
}

// Points on the edges from the centre to the rim.
TEST(Growth, SeedsOnEdgesOfADisc)
{
  expectLinear(200,
    [](Index around)
    {
      const auto mesh = meshOf(disc(around));
      const Index centre = mesh->vertexOfPoint(0);
      std::vector<Seed> seeds;
      for (Index i = 0; i < around; ++i)
      {
        SurfacePoint point = mesh->pointAtVertex(mesh->vertexOfPoint(1 + i));
        const Triangle& corners = mesh->triangle(point.triangle);
        for (int c = 0; c < 3; ++c)
        {
          point.weights[c] = corners[c] == centre || point.weights[c] == 1.0 ? 0.5 : 0.0;
        }
        seeds.push_back(Seed::atPoint(point));
      }
      Partition onePiece;
      SeedFront front;
      makeSeedFront(*mesh, ClosedTriangles(*mesh, {}), seeds, false, goesOn, onePiece, front);
      // An edge has two faces with four corners.
      EXPECT_EQ(front.starts.size(), 4 * around);
    });
}

// A seed in each face of a disc with a barrier: whether it lies in a closed triangle is not asked
// round the centre.
TEST(Growth, SeedsInFacesOfADiscWithABarrier)
{
  expectLinear(200,
    [](Index around)
    {
      const auto mesh = meshOf(disc(around));
      std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
      closed[0] = 1;
      std::vector<Seed> seeds;
      for (Index t = 1; t < mesh->numberOfTriangles(); ++t)
      {
        seeds.push_back(Seed::atPoint({ t, { 0.25, 0.25, 0.5 } }));
      }
      SolveOptions options;
      options.closedTriangles = closed;
      Partition onePiece;
      checkSeedsAreOpen(*mesh, seeds, options, ClosedTriangles(*mesh, closed), onePiece);
    });
}

TEST(Growth, SeedsInOneFace)
{
  expectLinear(500,
    [](Index count)
    {
      const auto mesh = meshOf(planeGrid(8, 8, 8.0, 8.0));
      std::vector<Seed> seeds;
      for (Index i = 0; i < count; ++i)
      {
        // Along a spiral in the face.
        const double part = (i + 0.5) / count;
        const double radius = 0.2 * std::sqrt(part);
        seeds.push_back(seedNear(
          mesh, { 3.7 + radius * std::cos(2.4 * i), 3.3 + radius * std::sin(2.4 * i), 0.0 }));
      }
      FastMarchingSolver(mesh).solve(seeds);
    });
}
