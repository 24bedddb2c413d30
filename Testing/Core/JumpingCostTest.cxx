// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Costs that differ by orders of magnitude from one vertex to the next, on usual and thin
// triangles: distances and paths against the truth.

#include "PathStyles.h"
#include "RandomDraws.h"
#include "Solving.h"
#include "WeightedDistances.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "path/PathFinder.h"
#include "solve/ClosedTriangles.h"
#include "solve/Detours.h"
#include "solve/Partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr Index CellsOfSide = 24;

/** A plane grid with a seed in its middle, whose points are shaken. */
class Plane
{
public:
  /** @param width  of a cell; its height is 1 */
  explicit Plane(double width, Random& random)
  {
    Surface surface = planeGrid(CellsOfSide, CellsOfSide, CellsOfSide, CellsOfSide);
    for (Vector3& point : surface.points)
    {
      const bool isInside = point.x > 0.5 && point.x < CellsOfSide - 0.5 && point.y > 0.5 &&
        point.y < CellsOfSide - 0.5;
      point.x += isInside ? between(-0.3, 0.3, random) : 0.0;
      point.y += isInside ? between(-0.3, 0.3, random) : 0.0;
      point.x *= width;
    }
    this->Mesh = meshOf(surface);
    this->Cost.assign(this->Mesh->numberOfVertices(), 1.0);
    this->Source =
      this->Mesh->vertexOfPoint((CellsOfSide + 1) * (CellsOfSide / 2) + CellsOfSide / 2);
    this->Width = width;
  }

  /** Costs at random, spread by a factor of e^sigma. */
  void drawCosts(double sigma, Random& random)
  {
    std::normal_distribution<double> normal(0.0, sigma);
    for (double& cost : this->Cost)
    {
      cost = std::exp(normal(random));
    }
  }
  /** A column of dear cells across, which the seed is in or not. */
  void makeWall(double cost, double from, double to)
  {
    for (Index v = 0; v < this->Cost.size(); ++v)
    {
      const double column = this->Mesh->position(v).x / this->Width;
      this->Cost[v] = column > from && column < to ? cost : 1.0;
    }
  }

  const std::shared_ptr<const TriangleMesh>& mesh() const { return this->Mesh; }
  SolveOptions options() const
  {
    SolveOptions options;
    options.cost = this->Cost;
    return options;
  }
  SurfacePoint source() const { return this->Mesh->pointAtVertex(this->Source); }
  std::vector<double> truth() const
  {
    return weightedDistances(*this->Mesh, this->Cost, this->Source);
  }

  struct Errors
  {
    /** Of the distances, and of it the part of those that are too small. */
    double mean = 0.0;
    double tooSmall = 0.0;
    /** By what part paths cost more than the shortest ones. */
    double ofPaths = 0.0;
  };
  Errors errors() const
  {
    const std::vector<double> truth = this->truth();
    const SolveOptions options = this->options();
    FastMarchingSolver solver(this->Mesh);
    const Seed seed = Seed::atPoint(this->source());
    const DistanceField& field = solver.solve({ &seed, 1 }, options);
    Errors errors;
    const double each = 1.0 / static_cast<double>(truth.size() - 1);
    for (Index v = 0; v < truth.size(); ++v)
    {
      const double off = truth[v] > 0.0 ? field.distance(v) / truth[v] - 1.0 : 0.0;
      errors.mean += each * std::abs(off);
      errors.tooSmall += each * std::max(-off, 0.0);
    }
    std::vector<Index> starts;
    std::vector<SurfacePoint> points;
    for (Index v = 7; v < truth.size(); v += 31)
    {
      if (v != this->Source)
      {
        starts.push_back(v);
        points.push_back(this->Mesh->pointAtVertex(v));
      }
    }
    const SurfacePoint end = this->source();
    PathFinder finder(solver, { &end, 1 }, options, Traced);
    finder.march(points);
    for (std::size_t i = 0; i < starts.size(); ++i)
    {
      EXPECT_TRUE(finder.pathFrom(points[i]));
      errors.ofPaths +=
        (finder.cost() / truth[starts[i]] - 1.0) / static_cast<double>(starts.size());
    }
    return errors;
  }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  std::vector<double> Cost;
  Index Source = NoIndex;
  double Width = 1.0;
};

/** The mean of the errors on some planes. */
template <class Prepare>
Plane::Errors meanErrors(double width, const Prepare& prepare)
{
  constexpr int planes = 4;
  Random random(1);
  Plane::Errors mean;
  for (int i = 0; i < planes; ++i)
  {
    Plane plane(width, random);
    prepare(plane, random);
    const Plane::Errors errors = plane.errors();
    mean.mean += errors.mean / planes;
    mean.tooSmall += errors.tooSmall / planes;
    mean.ofPaths += errors.ofPaths / planes;
  }
  return mean;
}

Plane::Errors ofRandomCosts(double width, double sigma)
{
  return meanErrors(width, [&](Plane& plane, Random& random) { plane.drawCosts(sigma, random); });
}

}

// Without detours distances were 18, 36 and 45 % off in the mean, and paths cost 1.3, 3.7 and 67
// times the shortest.
TEST(JumpingCost, AtRandomDistancesAreNearTheTruth)
{
  for (const double sigma : { 1.0, 2.0, 4.0 })
  {
    const Plane::Errors errors = ofRandomCosts(1.0, sigma);
    EXPECT_LT(errors.mean, 0.06) << sigma;
    EXPECT_LT(errors.tooSmall, 0.01) << sigma;
    EXPECT_LT(errors.ofPaths, 0.08) << sigma;
  }
}

// 94 % off, and 11 times the shortest.
TEST(JumpingCost, AtRandomThinTrianglesHaveDistancesToo)
{
  const Plane::Errors errors = ofRandomCosts(0.2, 2.0);
  EXPECT_LT(errors.mean, 0.1);
  EXPECT_LT(errors.tooSmall, 0.01);
  EXPECT_LT(errors.ofPaths, 0.15);
}

// 83 and 40 % off: each column of thin triangles cost what one does.
TEST(JumpingCost, AWallOfThinTrianglesCostsItsWidth)
{
  // The seed is in the wall, or before it.
  for (const double from : { 9.5, 13.5 })
  {
    const Plane::Errors errors =
      meanErrors(0.2, [&](Plane& plane, Random&) { plane.makeWall(100.0, from, from + 5.0); });
    EXPECT_LT(errors.mean, 0.2) << from;
    EXPECT_LT(errors.tooSmall, 0.01) << from;
  }
}

// Costs that differ by a third from point to point: 5 to 15 % too small where only dear triangles
// are bypassed, and not those at the seed.
TEST(JumpingCost, MildNoiseMakesNoShortCutsAtTheSeed)
{
  for (const double width : { 1.0, 0.5, 0.2, 0.1 })
  {
    const Plane::Errors errors = ofRandomCosts(width, 0.3);
    EXPECT_LT(errors.mean, 0.12) << width;
    EXPECT_LT(errors.tooSmall, 0.02) << width;
  }
}

// One rim vertex is cheap: fronts from the hub went round by it, from each triangle to the next.
TEST(JumpingCost, ACheapRimVertexOfAFanIsNoShortCut)
{
  const Surface surface = disc(100);
  const auto mesh = meshOf(surface);
  const Index cheap = mesh->vertexOfPoint(30);
  for (const double cost : { 0.45, 0.1 })
  {
    std::vector<double> costs(mesh->numberOfVertices(), 1.0);
    costs[cheap] = cost;
    const Index hub = mesh->vertexOfPoint(0);
    const std::vector<double> truth = weightedDistances(*mesh, costs, hub);
    SolveOptions options;
    options.cost = costs;
    const auto found = distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 0) }, options);
    for (Index p = 0; p < found.size(); ++p)
    {
      EXPECT_GE(found[p], 0.95 * truth[mesh->vertexOfPoint(p)]) << cost << ", point " << p;
    }
  }
}

// Linear fronts across needles lowered one another for 100 updates a vertex and more.
TEST(JumpingCost, FrontsOnNeedlesSettle)
{
  Random random(6);
  for (const double width : { 0.05, 0.01, 0.001 })
  {
    Plane plane(width, random);
    plane.drawCosts(2.0, random);
    const std::vector<Seed> seeds{ Seed::atPoint(plane.source()) };
    std::size_t updates = 0;
    SolveOptions options = plane.options();
    options.progressInterval = 1;
    options.onProgress = [&](std::size_t taken)
    {
      updates = taken;
      return true;
    };
    distances<FastMarchingSolver>(plane.mesh(), seeds, options);
    EXPECT_LT(updates, 10u * plane.mesh()->numberOfVertices()) << width;
  }
}

// As where there is no data, a cost of almost nothing, and no way.
TEST(JumpingCost, OfExcludedVerticesDoesNotMatter)
{
  const auto mesh = meshOf(jitteredGrid(20, 20, 20.0, 4.0, 0.3, 5));
  std::vector<double> costs(mesh->numberOfVertices(), 1.0);
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices(), 0);
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles(), 0);
  for (Index v = 5; v < mesh->numberOfVertices(); v += 17)
  {
    excluded[v] = 1;
  }
  for (Index t = 0; t < mesh->numberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh->triangle(t);
    closed[t] = std::any_of(
      corners.begin(), corners.end(), [&](Index vertex) { return excluded[vertex] != 0; });
  }
  SolveOptions options;
  options.excluded = excluded;
  options.closedTriangles = closed;
  const std::vector<Seed> seeds{ Seed::atPoint(mesh->pointAtVertex(mesh->numberOfVertices() / 2)) };
  ASSERT_EQ(excluded[mesh->numberOfVertices() / 2], 0);
  options.cost = costs;
  const auto before = distances<FastMarchingSolver>(mesh, seeds, options);
  for (Index v = 0; v < costs.size(); ++v)
  {
    costs[v] = excluded[v] != 0 ? 1e-6 : 1.0;
  }
  const auto after = distances<FastMarchingSolver>(mesh, seeds, options);
  for (Index p = 0; p < after.size(); ++p)
  {
    EXPECT_TRUE(after[p] == before[p] || std::abs(after[p] - before[p]) < 1e-9) << p;
  }
}

TEST(JumpingCost, BothTiersAgree)
{
  Random random(3);
  for (const double sigma : { 0.3, 1.0, 4.0 })
  {
    Plane plane(0.3, random);
    plane.drawCosts(sigma, random);
    const std::vector<Seed> seeds{ Seed::atPoint(plane.source()) };
    const auto fast = distances<FastMarchingSolver>(plane.mesh(), seeds, plane.options());
    const auto reference = distances<ReferenceSolver>(plane.mesh(), seeds, plane.options());
    EXPECT_LT(relativeError(fast, reference).largest, 1e-9) << sigma;
  }
}

// Each vertex near the face of many seeds keeps a value of each: more than are sought one by one.
TEST(JumpingCost, OfManySeedsInOneFaceBothTiersAgree)
{
  for (const double range : { 0.0, 1.0, 3.0, 6.0, 12.0 })
  {
    for (unsigned trial = 0; trial < 6; ++trial)
    {
      Random random(trial);
      const auto mesh = meshOf(jitteredGrid(8, 8, 1.0, 1.0, 0.3, trial));
      std::vector<double> cost;
      for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
      {
        cost.push_back(std::exp(between(-range, range, random)));
      }
      SolveOptions options;
      options.cost = cost;
      std::vector<Seed> seeds;
      const Index face = below(mesh->numberOfTriangles(), random);
      for (int i = 0; i < 400; ++i)
      {
        SurfacePoint point = randomPoint(*mesh, random);
        point.triangle = face;
        seeds.push_back(Seed::atPoint(point, between(0.0, 0.01, random)));
      }
      FastMarchingSolver solver(mesh);
      ReferenceSolver reference(mesh);
      const DistanceField& field = solver.solve(seeds, options);
      const DistanceField& known = reference.solve(seeds, options);
      for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
      {
        EXPECT_NEAR(field.distance(vertex), known.distance(vertex), 1e-9 * known.largestDistance())
          << "costs of 1:e^" << 2.0 * range << ", trial " << trial << ", vertex " << vertex;
        EXPECT_EQ(field.nearestSeed(vertex), known.nearestSeed(vertex));
      }
    }
  }
}

// The disc of final values ends where the cost jumps: in it they were length times the mean of both
// ends, 50 a unit of length, where all triangles but those at the wall cost 1.
TEST(JumpingCost, ASeedInAWallPaysForTheWallOnce)
{
  Random random(4);
  Plane plane(1.0, random);
  plane.makeWall(100.0, 11.5, 12.5);
  const std::vector<double> truth = plane.truth();
  const auto found =
    distances<FastMarchingSolver>(plane.mesh(), { Seed::atPoint(plane.source()) }, plane.options());
  for (Index p = 0; p < found.size(); ++p)
  {
    const double shortest = truth[plane.mesh()->vertexOfPoint(p)];
    EXPECT_GE(found[p], 0.9 * shortest) << p;
    EXPECT_LE(found[p], 1.1 * shortest) << p;
  }
}

namespace
{

Detours detoursOf(
  const TriangleMesh& mesh, const std::vector<double>& cost, SolveOptions options = {})
{
  Partition onePiece;
  options.cost = cost;
  return { mesh, mesh.rings().longestSides(), ClosedTriangles(mesh, options.closedTriangles),
    options, onePiece };
}

/** The limits of a strip of squares, whose costs jump in the middle. */
class DetoursOfStrip : public ::testing::Test
{
protected:
  void make(double width)
  {
    constexpr Index squares = 40;
    this->Mesh = meshOf(planeGrid(squares, 1, squares * width, 1.0));
    std::vector<double> cost;
    for (const Vector3& p : this->Mesh->positions())
    {
      cost.push_back(p.x < 0.5 * squares * width ? 100.0 : 1.0);
    }
    this->Found = detoursOf(*this->Mesh, cost);
  }
  /** The limit of the lower vertex that is so many squares before the jump. */
  double limit(Index before) const
  {
    return this->Found.limit(this->Mesh->vertexOfPoint(19 - before));
  }

  std::shared_ptr<const TriangleMesh> Mesh;
  Detours Found;
};

}

TEST_F(DetoursOfStrip, LeadAsFarAsTheLongestSide)
{
  // With sides of 0.1 the way to the cheap part may be some ten squares long.
  this->make(0.1);
  EXPECT_LT(this->limit(0), 20.0);
  EXPECT_LT(this->limit(5), 100.0);
  EXPECT_NEAR(this->limit(18), 160.0, 1e-6);
  this->make(1.0);
  EXPECT_LT(this->limit(0), 100.0);
  EXPECT_NEAR(this->limit(3), 160.0, 1e-6);
}

TEST_F(DetoursOfStrip, AreNoneOnPointsInOnePlace)
{
  const auto mesh = meshOf({ { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, { { 0, 1, 2 } } });
  const std::vector<double> cost{ 1.0, 10.0, 100.0 };
  const Detours found = detoursOf(*mesh, cost);
  for (Index v = 0; v < 3; ++v)
  {
    EXPECT_FALSE(std::isnan(found.limit(v)));
  }
}
