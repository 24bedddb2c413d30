// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves of constant distance under costs: uniform ones, a linear speed and Snell's law against
// formulas, smooth random ones and jumps against a count of the curves; and round lines of seeds
// that cross faces.

#include "IsolineShape.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/EikonalUpdate.h"
#include "march/FastMarchingSolver.h"
#include "path/Isolines.h"
#include "search/ClosestPointTree.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using MeshPointer = std::shared_ptr<const TriangleMesh>;

std::vector<double> atVertices(
  const TriangleMesh& mesh, const std::function<double(const Vector3&)>& function)
{
  std::vector<double> values;
  for (const Vector3& p : mesh.positions())
  {
    values.push_back(function(p));
  }
  return values;
}

template <class Solver = FastMarchingSolver>
std::vector<double> fieldOf(
  const MeshPointer& mesh, const std::vector<Seed>& seeds, const std::vector<double>& cost)
{
  Solver solver(mesh);
  SolveOptions options;
  options.cost = cost;
  const auto distances = solver.solve(seeds, options).distances();
  return { distances.begin(), distances.end() };
}

std::vector<Isoline> linesOf(const TriangleMesh& mesh, const std::vector<double>& values,
  const std::vector<double>& cost, const std::vector<double>& levels)
{
  return isolines(mesh, EdgeTable(mesh), values, cost, levels, [] { return true; });
}

/** How many curves the linear interpolation has at a level that no vertex has. */
std::size_t numberOfLinearCurves(
  const TriangleMesh& mesh, const std::vector<double>& field, double level)
{
  std::map<std::pair<Index, Index>, std::size_t> nodes;
  std::vector<std::size_t> parents;
  const auto rootOf = [&](std::size_t node)
  {
    while (parents[node] != node)
    {
      node = parents[node];
    }
    return node;
  };
  for (const Triangle& t : mesh.triangles())
  {
    std::vector<std::size_t> cut;
    for (int c = 0; c < 3; ++c)
    {
      const Index a = t[c];
      const Index b = t[(c + 1) % 3];
      if ((field[a] < level) != (field[b] < level))
      {
        const auto [place, isNew] = nodes.emplace(std::minmax(a, b), parents.size());
        if (isNew)
        {
          parents.push_back(parents.size());
        }
        cut.push_back(place->second);
      }
    }
    if (cut.size() == 2)
    {
      parents[rootOf(cut[0])] = rootOf(cut[1]);
    }
  }
  std::size_t roots = 0;
  for (std::size_t node = 0; node < parents.size(); ++node)
  {
    roots += parents[node] == node ? 1 : 0;
  }
  return roots;
}

/** The march's own value in a face: the least of w S(a / w, b / w) over its sides. */
double valueInFace(const TriangleMesh& mesh, const std::vector<double>& field,
  const std::vector<double>& cost, Index face, const Vector3& p)
{
  const Triangle& t = mesh.triangle(face);
  const double w = (cost[t[0]] + cost[t[1]] + cost[t[2]]) / 3.0;
  double least = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c)
  {
    const Index a = t[c];
    const Index b = t[(c + 1) % 3];
    const Vector3 edge = mesh.position(b) - mesh.position(a);
    const Vector3 side = p - mesh.position(a);
    const Vector3 normal = cross(edge, side);
    const FlatTriangle flat{ dot(edge, edge), dot(edge, side), dot(normal, normal) };
    least = std::min(least, w * pointSourceUpdate(flat, field[a] / w, field[b] / w));
  }
  return least;
}

std::vector<double> smoothCost(const TriangleMesh& mesh, std::mt19937& random, double spread)
{
  std::normal_distribution<double> normal;
  std::vector<std::array<double, 4>> waves;
  for (int i = 0; i < 6; ++i)
  {
    waves.push_back(
      { 4.0 * normal(random), 4.0 * normal(random), 3.0 * normal(random), normal(random) });
  }
  return atVertices(mesh,
    [&](const Vector3& p)
    {
      double sum = 0.0;
      for (const auto& [x, y, phase, height] : waves)
      {
        sum += height * std::sin(x * p.x + y * p.y + phase);
      }
      return std::exp(0.5 * spread * sum);
    });
}

std::vector<Seed> randomSeeds(const MeshPointer& mesh, std::mt19937& random, int count)
{
  std::uniform_real_distribution<double> place(0.1, 0.9);
  std::vector<Seed> seeds;
  for (int i = 0; i < count; ++i)
  {
    const double x = place(random);
    seeds.push_back(seedNear(mesh, { x, place(random), 0.0 }));
  }
  return seeds;
}

/** Curves end at the border of the unit square only. */
void expectWhole(const std::vector<Isoline>& lines, const std::string& what)
{
  for (const Isoline& line : lines)
  {
    for (const Vector3& p : { line.points.front(), line.points.back() })
    {
      EXPECT_TRUE(isClosed(line) || std::min({ p.x, p.y, 1.0 - p.x, 1.0 - p.y }) < 1e-9) << what;
    }
  }
}

}

TEST(IsolinesUnderCosts, OfUniformCostAreThoseOfCostOne)
{
  for (unsigned number = 0; number < 30; ++number)
  {
    const RandomCase random = randomCase(number, { 3, false, false });
    const std::vector<double> unit(random.mesh->numberOfVertices(), 1.0);
    const std::vector<double> field = fieldOf(random.mesh, random.seeds, unit);
    const double largest = largestOf(field);
    for (const double part : { 0.02, 0.21, 0.53, 0.87 })
    {
      const auto expected = linesOf(*random.mesh, field, {}, { part * largest });
      // On needles the rounding of a product can decide between two curves, that by 1024 has none.
      const auto costs = random.kind == MeshKind::Needles
        ? std::vector{ 0.25, 4.0, 1.0 / 1024.0, 1024.0 }
        : std::vector{ 0.2, 5.0, 1e-3, 1e3 };
      for (const double w : costs)
      {
        std::vector<double> scaled = field;
        for (double& value : scaled)
        {
          value *= w;
        }
        const std::vector<double> cost(random.mesh->numberOfVertices(), w);
        const auto found = linesOf(*random.mesh, scaled, cost, { w * part * largest });
        ASSERT_EQ(found.size(), expected.size()) << random.description() << " " << w;
        for (std::size_t i = 0; i < found.size(); ++i)
        {
          EXPECT_NEAR(found[i].length, expected[i].length, 1e-9 * largest);
          EXPECT_NEAR(found[i].area, expected[i].area, 1e-9 * largest * largest);
        }
      }
    }
  }
}

TEST(IsolinesUnderCosts, OfUniformCostRoundAPointAreCircles)
{
  for (const double w : { 0.2, 5.0, 1e-3, 1e3 })
  {
    const auto mesh = meshOf(jitteredGrid(20, 20, 1.0, 1.0, 0.3, 4));
    const std::vector<double> cost(mesh->numberOfVertices(), w);
    const auto field = fieldOf(mesh, { seedNear(mesh, { 0.513, 0.478, 0 }) }, cost);
    for (const double radius : { 0.001, 0.01, 0.1, 0.45 })
    {
      const auto lines = linesOf(*mesh, field, cost, { w * radius });
      ASSERT_EQ(lines.size(), 1u) << w << " " << radius;
      EXPECT_NEAR(lines[0].length, 2.0 * std::numbers::pi * radius, 1e-9);
      EXPECT_NEAR(lines[0].area, std::numbers::pi * radius * radius, 1e-9);
    }
  }
}

// Cost 1 / (1 + x): fronts are circles with a centre that moves. The seed is in a face, at a vertex
// and on an edge. Second order in the edge's length, from the field of the formula; that of the
// march has an error of its own. Circles in the seed's face are as the march begins, with the mean
// of the costs at both ends.
TEST(IsolinesUnderCosts, OfALinearSpeedAreItsCircles)
{
  for (const Vector3& seed :
    { Vector3{ 0.513, 0.478, 0 }, Vector3{ 0.5, 0.5, 0 }, Vector3{ 0.5125, 0.5, 0 } })
  {
    const auto truth = [&](const Vector3& p)
    {
      const double u = norm(p - seed);
      return std::acosh(1.0 + u * u / (2.0 * (1.0 + seed.x) * (1.0 + p.x)));
    };
    for (const bool isMarched : { false, true })
    {
      double before = 0.0;
      for (const Index cells : { 20, 80 })
      {
        const auto mesh = meshOf(planeGrid(cells, cells, 1.0, 1.0));
        const auto cost = atVertices(*mesh, [](const Vector3& p) { return 1.0 / (1.0 + p.x); });
        const auto field =
          isMarched ? fieldOf(mesh, { seedNear(mesh, seed) }, cost) : atVertices(*mesh, truth);
        double worst = 0.0;
        for (const double level :
          isMarched ? std::vector{ 0.002, 0.01, 0.03, 0.1, 0.25 } : std::vector{ 0.06, 0.1, 0.25 })
        {
          const auto lines = linesOf(*mesh, field, cost, { level });
          ASSERT_EQ(lines.size(), 1u) << level << " " << cells << " " << isMarched;
          EXPECT_TRUE(isClosed(lines[0]));
          const double radius = (1.0 + seed.x) * std::sinh(level);
          worst =
            std::max({ worst, std::abs(lines[0].length / (2.0 * std::numbers::pi * radius) - 1.0),
              std::abs(lines[0].area / (std::numbers::pi * radius * radius) - 1.0) });
          for (const Vector3& p : lines[0].points)
          {
            EXPECT_NEAR(truth(p), level, 0.011 * level);
          }
        }
        EXPECT_LT(worst, isMarched ? 6e-3 : 4e-3);
        if (cells == 80)
        {
          EXPECT_LT(worst, (isMarched ? 0.7 : 0.2) * before);
        }
        before = worst;
      }
    }
  }
}

// Two half planes of cost 1 and 3 that meet between two columns of points: each point of a curve
// has the level by Fermat's principle. First order, as is the field.
TEST(IsolinesUnderCosts, BehindABorderFollowSnellsLaw)
{
  const Vector3 source{ -0.5, 0.1, 0.0 };
  const auto truth = [&](const Vector3& p)
  {
    if (p.x < 0.0)
    {
      return norm(p - source);
    }
    const auto over = [&](double y)
    { return std::hypot(source.x, source.y - y) + 3.0 * std::hypot(p.x, p.y - y); };
    double low = -10.0;
    double high = 10.0;
    for (int i = 0; i < 200; ++i)
    {
      const double y1 = low + (high - low) / 3.0;
      const double y2 = high - (high - low) / 3.0;
      (over(y1) < over(y2) ? high : low) = over(y1) < over(y2) ? y2 : y1;
    }
    return over(0.5 * (low + high));
  };
  double before = 0.0;
  for (const Index cells : { 64, 256 })
  {
    Surface plane = planeGrid(cells, cells, 2.0, 2.0);
    for (Vector3& p : plane.points)
    {
      p = p - Vector3{ 1.0 - 1.0 / cells, 1.0, 0.0 };
    }
    const auto mesh = meshOf(plane);
    const auto cost = atVertices(*mesh, [](const Vector3& p) { return p.x < 0.0 ? 1.0 : 3.0; });
    const auto field = fieldOf(mesh, { seedNear(mesh, source) }, cost);
    double sum = 0.0;
    std::size_t count = 0;
    for (const double level : { 0.2, 0.4, 0.8, 1.3 })
    {
      const auto lines = linesOf(*mesh, field, cost, { level });
      EXPECT_EQ(lines.size(), numberOfLinearCurves(*mesh, field, level)) << level;
      for (const Isoline& line : lines)
      {
        for (const Vector3& p : line.points)
        {
          sum += std::abs(truth(p) - level) / level;
          ++count;
        }
      }
    }
    const double mean = sum / static_cast<double>(count);
    EXPECT_LT(mean, cells == 64 ? 1e-2 : 3e-3);
    EXPECT_TRUE(cells == 64 || mean < 0.5 * before) << mean << " after " << before;
    before = mean;
  }
}

// The curves are as many as the linear interpolation has, far from what it misses: circles round
// seeds between the points. And at their points the march's update from the sides of the face gives
// the level, but for the change of the cost in the face and where fronts meet.
TEST(IsolinesUnderCosts, OfSmoothRandomCostsAreWholeAndHaveTheLevel)
{
  std::mt19937 random(1);
  for (unsigned number = 0; number < 15; ++number)
  {
    const auto mesh = meshOf(jitteredGrid(40, 40, 1.0, 1.0, 0.3, number));
    const auto cost = smoothCost(*mesh, random, number % 2 == 0 ? 0.3 : 1.0);
    const auto seeds = randomSeeds(mesh, random, number % 4 < 2 ? 1 : 3);
    const auto field = fieldOf(mesh, seeds, cost);
    const ClosestPointTree tree(mesh);
    for (const double part : { 0.1, 0.3, 0.5, 0.7, 0.9 })
    {
      const double level = part * largestOf(field);
      const auto lines = linesOf(*mesh, field, cost, { level });
      EXPECT_EQ(lines.size(), numberOfLinearCurves(*mesh, field, level)) << number << " " << part;
      expectWhole(lines, std::to_string(number));
      double sum = 0.0;
      std::size_t count = 0;
      for (const Isoline& line : lines)
      {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        {
          const Vector3 middle = 0.5 * (line.points[i] + line.points[i + 1]);
          const SurfacePoint place = tree.closestPoint(middle).point;
          const Triangle& t = mesh->triangle(place.triangle);
          const double w = (cost[t[0]] + cost[t[1]] + cost[t[2]]) / 3.0;
          const double error =
            std::abs(valueInFace(*mesh, field, cost, place.triangle, middle) - level) / (w * 0.025);
          // Of an edge's cost.
          EXPECT_LT(error, 0.5) << number << " " << part;
          sum += error;
          ++count;
        }
      }
      EXPECT_LT(sum / static_cast<double>(count), 0.025) << number << " " << part;
    }
  }
}

TEST(IsolinesUnderCosts, ThatJumpHaveNoCurvesRoundNothing)
{
  std::mt19937 random(7);
  for (const double jump : { 2.0, 10.0, 1000.0 })
  {
    std::size_t tooMany = 0;
    for (unsigned number = 0; number < 15; ++number)
    {
      const auto mesh = meshOf(jitteredGrid(40, 40, 1.0, 1.0, 0.3, number));
      const auto cost = atVertices(*mesh,
        [&](const Vector3& p) { return std::hypot(p.x - 0.5, p.y - 0.6) < 0.2 ? jump : 1.0; });
      // Seeds in the cheap part, so that circles are larger than faces.
      const Seed seed = seedNear(mesh, { 0.1 + 0.05 * number, 0.2, 0.0 });
      const auto field = fieldOf(mesh, { seed }, cost);
      // The levels of the cheap part, and those of the dear one.
      for (const double level : { 0.1, 0.3, 0.55, 0.7, 0.05 * jump, 0.1 * jump, 0.15 * jump })
      {
        const auto lines = linesOf(*mesh, field, cost, { level });
        expectWhole(lines, std::to_string(number));
        const std::size_t linear = numberOfLinearCurves(*mesh, field, level);
        EXPECT_GE(lines.size(), linear) << jump << " " << number << " " << level;
        tooMany += lines.size() - linear;
      }
    }
    EXPECT_LE(tooMany, jump > 100.0 ? 4u : 0u) << jump;
  }
}

TEST(IsolinesUnderCosts, OfDijkstrasDistancesAreWhole)
{
  std::mt19937 random(3);
  for (unsigned number = 0; number < 20; ++number)
  {
    const auto mesh = meshOf(jitteredGrid(30, 30, 1.0, 1.0, 0.3, number));
    const auto cost = smoothCost(*mesh, random, 0.5);
    const auto field = fieldOf<DijkstraSolver>(mesh, randomSeeds(mesh, random, 1), cost);
    for (const double part : { 0.3, 0.6 })
    {
      const double level = part * largestOf(field);
      const auto lines = linesOf(*mesh, field, cost, { level });
      EXPECT_GE(lines.size(), 1u);
      expectWhole(lines, std::to_string(number));
    }
  }
}

// A line of seeds across faces: the strip beside it is exact, also where no point lies in it.
TEST(Isolines, BesideALineAcrossFacesAreParallelToIt)
{
  const auto mesh = meshOf(jitteredGrid(20, 20, 1.0, 1.0, 0.3, 4));
  const auto height = [](const Vector3& p)
  { return (p.y - 0.31 - 0.3 * p.x) / std::hypot(1.0, 0.3); };
  const auto field = atVertices(*mesh, [&](const Vector3& p) { return std::abs(height(p)); });
  const double length = std::hypot(1.0, 0.3);
  for (const double level : { 1e-4, 0.003, 0.02, 0.1 })
  {
    for (const double w : { 1.0, 0.2, 1e3 })
    {
      std::vector<double> scaled = field;
      for (double& value : scaled)
      {
        value *= w;
      }
      const std::vector<double> cost(mesh->numberOfVertices(), w);
      const auto lines = linesOf(*mesh, scaled, cost, { w * level });
      ASSERT_EQ(lines.size(), 2u) << level;
      for (const Isoline& line : lines)
      {
        EXPECT_NEAR(line.length, length, 1e-9);
        EXPECT_NEAR(line.area, 2.0 * level * length, 1e-9);
        for (const Vector3& p : line.points)
        {
          EXPECT_NEAR(std::abs(height(p)), level, 1e-9);
        }
      }
    }
  }
}
