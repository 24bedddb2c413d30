// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// A march towards targets leaves out most of the surface, and nothing that matters: where paths to
// the targets can pass, the field is the one without a goal, and paths are as long.

#include "PathStyles.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "path/PathFinder.h"
#include "solve/DijkstraSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

SurfacePoint randomPoint(const TriangleMesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(0.05, 0.45);
  SurfacePoint point{ static_cast<Index>(random() % mesh.numberOfTriangles()), { 1.0, 0.0, 0.0 } };
  const double a = part(random);
  const double b = part(random);
  switch (random() % 3)
  {
    case 0:
      return point;
    case 1:
      point.weights = { 1.0 - a, a, 0.0 };
      return point;
    default:
      point.weights = { 1.0 - a - b, a, b };
      return point;
  }
}

/** How far values are off that matter for paths to a goal, in parts of the goal's distance. */
struct Inside
{
  int vertices = 0;
  double most = 0.0;
};

/** The field with and without a goal at a vertex. @param detour  with which the way to the goal is
 * guessed; 0 for no guess */
template <class Solver>
Inside insideOf(const RandomCase& c, Index goal, double detour)
{
  Solver whole(c.mesh);
  Solver directed(c.mesh);
  SolveOptions options = c.options();
  const DistanceField& truth = whole.solve(c.seeds, options);
  const double least = c.cost.empty() ? 1.0 : *std::min_element(c.cost.begin(), c.cost.end());
  const double distance = truth.distance(goal);
  const Triangle target{ goal, goal, goal };
  options.targets = { &target, 1 };
  options.targetMode = TargetMode::All;
  options.onlyTowardsTargets = true;
  options.maximumDistance = detour > 0.0 ? detour * distance : options.maximumDistance;
  const DistanceField& field = directed.solve(c.seeds, options);
  EXPECT_EQ(field.isReached(goal), truth.isReached(goal)) << c.description();
  Inside inside;
  for (const Index vertex : truth.reached())
  {
    const double left = least * norm(c.mesh->position(vertex) - c.mesh->position(goal));
    if (truth.isReached(goal) && truth.distance(vertex) + left <= distance)
    {
      ++inside.vertices;
      inside.most =
        std::max(inside.most, std::abs(field.distance(vertex) - truth.distance(vertex)) / distance);
    }
  }
  return inside;
}

template <class Solver>
void expectSameInside(const CaseLimits& limits, unsigned cases, double detour, double tolerance)
{
  int vertices = 0;
  for (unsigned seed = 0; seed < cases; ++seed)
  {
    const RandomCase c = randomCase(seed, limits);
    std::mt19937 random(seed);
    const Index goal = static_cast<Index>(random() % c.mesh->numberOfVertices());
    const Inside inside = insideOf<Solver>(c, goal, detour);
    vertices += inside.vertices;
    EXPECT_LE(inside.most, tolerance) << c.description();
  }
  EXPECT_GT(vertices, 5 * static_cast<int>(cases));
}

/** A solver that goes to all sides, whatever its goal. */
class ToAllSides final : public DistanceSolver
{
public:
  explicit ToAllSides(DistanceSolver& solver)
    : Solver(solver)
  {
  }
  const TriangleMesh& mesh() const override { return this->Solver.mesh(); }
  const DistanceField& solve(std::span<const Seed> seeds, const SolveOptions& options) override
  {
    SolveOptions toAllSides = options;
    toAllSides.onlyTowardsTargets = false;
    return this->Solver.solve(seeds, toAllSides);
  }
  bool crossesFaces() const override { return this->Solver.crossesFaces(); }
  bool findsPaths() const override { return this->Solver.findsPaths(); }
  std::optional<FoundPath> pathFrom(const SurfacePoint& start) const override
  {
    return this->Solver.pathFrom(start);
  }

private:
  DistanceSolver& Solver;
};

struct Lengths
{
  /** None without a path. */
  std::optional<double> directed;
  std::optional<double> toAllSides;
};

std::optional<double> lengthBetween(DistanceSolver& solver, const SurfacePoint& from,
  const SurfacePoint& to, const SolveOptions& options, const PathStyle& style)
{
  const auto path = shortestPath(solver, from, to, options, style);
  // It goes round no vertex for ever.
  EXPECT_LE(path ? path->size() : 0, 100 * std::size_t{ solver.mesh().numberOfVertices() });
  return path ? std::optional(lengthOf(solver.mesh(), *path)) : std::nullopt;
}

Lengths lengthsBetween(DistanceSolver& solver, const SurfacePoint& from, const SurfacePoint& to,
  const SolveOptions& options, const PathStyle& style)
{
  ToAllSides other(solver);
  return { lengthBetween(solver, from, to, options, style),
    lengthBetween(other, from, to, options, style) };
}

struct Comparison
{
  int paths = 0;
  int longer = 0;
  double most = 0.0;
  double sumDirected = 0.0;
  double sumToAllSides = 0.0;

  void add(const Lengths& lengths)
  {
    EXPECT_EQ(lengths.directed.has_value(), lengths.toAllSides.has_value());
    if (lengths.directed && lengths.toAllSides)
    {
      const double excess =
        *lengths.toAllSides > 0.0 ? *lengths.directed / *lengths.toAllSides - 1.0 : 0.0;
      ++this->paths;
      this->longer += excess > 1e-12 ? 1 : 0;
      this->most = std::max(this->most, excess);
      this->sumDirected += *lengths.directed;
      this->sumToAllSides += *lengths.toAllSides;
    }
  }
};

/** Random pairs of points of random cases. */
template <class Solver>
Comparison compare(unsigned cases, const CaseLimits& limits, const PathStyle& style)
{
  Comparison comparison;
  for (unsigned seed = 0; seed < cases; ++seed)
  {
    const RandomCase c = randomCase(seed, limits);
    Solver solver(c.mesh);
    std::mt19937 random(seed);
    for (int i = 0; i < 4; ++i)
    {
      const SurfacePoint to = randomPoint(*c.mesh, random);
      try
      {
        comparison.add(lengthsBetween(solver, c.seeds[0].points[0], to, c.options(), style));
      }
      catch (const std::invalid_argument&)
      {
        // The point lies on a barrier.
      }
    }
  }
  return comparison;
}

constexpr CaseLimits WithBarriers{ 1, false, true };
constexpr CaseLimits WithAll{ 1, true, true };

}

TEST(Goal, LeavesTheFieldAsItIsWhereItMatters)
{
  for (const double detour : { 0.0, 1.0 + 1e-9, 1.1 })
  {
    expectSameInside<FastMarchingSolver>(WithAll, 120, detour, 1e-9);
    expectSameInside<ReferenceSolver>(WithAll, 120, detour, 1e-9);
    expectSameInside<DijkstraSolver>(WithAll, 120, detour, 1e-12);
    expectSameInside<ExactSolver>(WithBarriers, 120, detour, 1e-12);
  }
}

// Fast marching keeps some edges beside the ellipse. The points whose way to both ends is at most
// as long as the straight line times 1.1 lie in an ellipse.
TEST(Goal, LeavesOutWhatLiesElsewhere)
{
  const auto mesh = meshOf(planeGrid(200, 200, 1.0, 1.0));
  const Seed seed = seedNear(mesh, { 0.25, 0.5, 0.0 });
  const Index goal = mesh->triangle(seedNear(mesh, { 0.75, 0.5, 0.0 }).points[0].triangle)[0];
  const Triangle target{ goal, goal, goal };
  SolveOptions options;
  options.targets = { &target, 1 };
  options.targetMode = TargetMode::All;
  options.onlyTowardsTargets = true;
  options.maximumDistance = 0.5 * 1.1;
  const auto partReachedBy = [&](DistanceSolver& solver)
  {
    return static_cast<double>(solver.solve({ &seed, 1 }, options).reached().size()) /
      static_cast<double>(mesh->numberOfVertices());
  };
  const double ellipse = 0.25 * std::numbers::pi * 0.55 * std::sqrt(0.55 * 0.55 - 0.5 * 0.5);
  FastMarchingSolver fast(mesh);
  ReferenceSolver reference(mesh);
  ExactSolver exact(mesh);
  DijkstraSolver dijkstra(mesh);
  EXPECT_LT(partReachedBy(fast), 2.0 * ellipse);
  EXPECT_LT(partReachedBy(reference), 2.0 * ellipse);
  EXPECT_LT(partReachedBy(exact), 1.0 * ellipse);
  EXPECT_LT(partReachedBy(dijkstra), 1.0 * ellipse);
}

TEST(Goal, LosesNoExactPath)
{
  const Comparison paths = compare<ExactSolver>(240, WithBarriers, Straight);
  EXPECT_GT(paths.paths, 500);
  EXPECT_EQ(paths.longer, 0) << "of " << paths.paths << ", worst " << paths.most;
}

TEST(Goal, MakesNoPathOfFastMarchingLonger)
{
  for (const PathStyle& style : { Straight, Traced, AlongEdges })
  {
    const Comparison paths =
      compare<FastMarchingSolver>(480, style.straighten ? WithBarriers : WithAll, style);
    EXPECT_GT(paths.paths, 1000);
    EXPECT_EQ(paths.longer, 0) << "of " << paths.paths << ", worst " << paths.most;
    EXPECT_LE(paths.sumDirected, paths.sumToAllSides * (1.0 + 1e-12));
  }
}

// The tracer needs more of Dijkstra's field than what lies on shortest paths along edges.
TEST(Goal, LeavesAPathAcrossFacesInDijkstrasFieldAsItIs)
{
  const Comparison paths = compare<DijkstraSolver>(480, WithAll, Traced);
  EXPECT_GT(paths.paths, 1000);
  EXPECT_EQ(paths.longer, 0) << "of " << paths.paths << ", worst " << paths.most;
}

TEST(Goal, MakesNoPathAlongEdgesLonger)
{
  const Comparison paths = compare<DijkstraSolver>(480, WithAll, AlongEdges);
  EXPECT_GT(paths.paths, 1000);
  EXPECT_EQ(paths.longer, 0) << "of " << paths.paths << ", worst " << paths.most;
}
