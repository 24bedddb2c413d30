// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Seeds that lie apart: their field is the least of the single fields. Where surfaces bend or
// triangles are no right-angled ones the single fields are not exact, and what a vertex keeps of
// several labels decides (see LabelMargin.h).

#include "ExactDistances.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using MeshPointer = std::shared_ptr<const TriangleMesh>;

/** Random vertices, each of which is farther from all others than 20 edges; as many of them as are
 * found at once. */
std::vector<Seed> seedsApart(const TriangleMesh& mesh, std::size_t count, unsigned number)
{
  constexpr double edges = 20.0;
  constexpr int mostTrials = 100000;
  std::mt19937 random(number);
  std::vector<Vector3> places;
  std::vector<Seed> seeds;
  for (int trial = 0; seeds.size() < count && trial < mostTrials; ++trial)
  {
    const Index vertex = random() % mesh.numberOfVertices();
    const Vector3 place = mesh.position(vertex);
    const bool isApart = std::all_of(places.begin(), places.end(),
      [&](const Vector3& other) { return norm(other - place) > edges * mesh.meanLongestEdge(); });
    if (isApart)
    {
      places.push_back(place);
      seeds.push_back(Seed::atPoint(mesh.pointAtVertex(vertex)));
    }
  }
  EXPECT_EQ(seeds.size(), count);
  return seeds;
}

/** The largest difference of the field of seeds to the least of their single fields, as a part of
 * the largest distance. */
double largestDifference(const MeshPointer& mesh, const std::vector<Seed>& seeds)
{
  FastMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(seeds);
  const double farthest = field.largestDistance();
  const std::vector<double> together(field.distances().begin(), field.distances().end());
  std::vector<double> least(together.size(), DistanceField::Unreached);
  SolveOptions options;
  options.maximumDistance = 1.1 * farthest;
  for (const Seed& seed : seeds)
  {
    const DistanceField& alone = solver.solve({ &seed, 1 }, options);
    for (const Index vertex : alone.reached())
    {
      least[vertex] = std::min(least[vertex], alone.distance(vertex));
    }
  }
  double largest = 0.0;
  for (std::size_t v = 0; v < least.size(); ++v)
  {
    largest = std::max(largest, std::abs(together[v] - least[v]));
  }
  return largest / farthest;
}

/** A plane with hills z = 3 sin(x / 9) cos(y / 7); @p stretch is that of x. */
Surface hilly(Surface plane, double stretch = 1.0)
{
  for (Vector3& p : plane.points)
  {
    p.z = 3.0 * std::sin(p.x / (9.0 * stretch)) * std::cos(p.y / 7.0);
  }
  return plane;
}

/** The hilly triangulation of random points, stretched along x. */
Surface hillyRandomPlane(Index points, unsigned number, double stretch)
{
  Surface plane = delaunayPlane(points, number);
  const double side = std::sqrt(static_cast<double>(points));
  for (Vector3& p : plane.points)
  {
    p = { stretch * side * p.x, side * p.y, 0.0 };
  }
  return hilly(std::move(plane), stretch);
}

void expectTwoAreTheLeast(const Surface& surface, unsigned number, double tolerance)
{
  const auto mesh = meshOf(surface);
  EXPECT_LE(largestDifference(mesh, seedsApart(*mesh, 2, number)), tolerance);
}

}

// Each seed has some 1,600 vertices, so that nothing bounds what they keep (see LabelBounds).
TEST(SparseSeeds, AHundredAreTheLeastOfTheirFields)
{
  constexpr Index side = 400;
  for (const Surface& surface : { hilly(planeGrid(side, side, side, side)),
         hilly(jitteredGrid(side, side, side, side, 0.3, 1)) })
  {
    const auto mesh = meshOf(surface);
    const std::vector<Seed> seeds = seedsApart(*mesh, 100, 1);
    EXPECT_FALSE(areDense(*mesh, seeds));
    EXPECT_LE(largestDifference(mesh, seeds), 1e-10);
  }
}

TEST(SparseSeeds, TwoAreTheLeastOfTheirFields)
{
  constexpr double usual = 1e-10;
  // Half of a square is just so slender that the margin is bounded. 4e-10 was measured at one
  // point.
  constexpr double ofSquares = 1e-9;
  constexpr double ofStretched = 1e-5;
  for (unsigned number = 1; number <= 4; ++number)
  {
    expectTwoAreTheLeast(hilly(planeGrid(80, 80, 80.0, 80.0)), number, ofSquares);
    expectTwoAreTheLeast(hilly(jitteredGrid(80, 80, 80.0, 80.0, 0.3, number)), number, usual);
    expectTwoAreTheLeast(torus(160, 60, 1.0, 0.4), number, usual);
    expectTwoAreTheLeast(icosphere(5), number, usual);
    expectTwoAreTheLeast(hillyRandomPlane(5000, number, 1.0), number, usual);
    expectTwoAreTheLeast(hillyRandomPlane(5000, number, 3.0), number, ofStretched);
    expectTwoAreTheLeast(hillyRandomPlane(5000, number, 10.0), number, ofStretched);
  }
}
