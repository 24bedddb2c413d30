// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances with a promised error, against CGAL, exact windows and all face sequences.

#include "windows/BoundedSolver.h"
#include "ExactDistances.h"
#include "FaceSequences.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "base/WorkCount.h"
#include "windows/ExactSolver.h"
#include "windows/Window.h"
#include "windows/WindowList.h"
#include "windows/WindowMerging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr double Tolerances[] = { 1e-1, 1e-2, 1e-3, 1e-4 };

/** Rounding of exact distances themselves, in parts of the largest; needles cost the oracle digits.
 */
constexpr double Rounding = 1e-11;
constexpr double RoundingOnNeedles = 1e-9;

/** Expects each distance to be at least the truth, and at most larger by the tolerance; what is not
 * finite in the truth, or below 0, is unreached. */
void expectWithin(const std::vector<double>& truth, const std::vector<double>& d, double tolerance,
  double rounding = Rounding)
{
  const double off = rounding * largestOf(truth);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(d[i]), std::isfinite(truth[i]) && truth[i] >= 0.0) << "point " << i;
    if (std::isfinite(d[i]))
    {
      ASSERT_GE(d[i], truth[i] - off) << "point " << i << ", tolerance " << tolerance;
      ASSERT_LE(d[i], truth[i] * (1.0 + tolerance) + off)
        << "point " << i << ", tolerance " << tolerance;
    }
  }
}

std::vector<double> bounded(
  const std::shared_ptr<const TriangleMesh>& mesh, const Seed& seed, double tolerance)
{
  SolveOptions options;
  options.tolerance = tolerance;
  return distances<BoundedSolver>(mesh, { seed }, options);
}

void expectPromise(const Surface& surface, Index source, double rounding = Rounding)
{
  const auto mesh = meshOf(surface);
  const Seed seed = seedAt(*mesh, source);
  const auto truth = distances<ExactSolver>(mesh, { seed });
  for (const double tolerance : Tolerances)
  {
    expectWithin(truth, bounded(mesh, seed, tolerance), tolerance, rounding);
  }
}

Surface flattened(Surface surface, double times)
{
  for (Vector3& p : surface.points)
  {
    p.x /= times;
  }
  return surface;
}

double windowsPerVertex(const Surface& surface, double tolerance)
{
  const auto mesh = meshOf(surface);
  const std::size_t before = WorkCount::steps();
  bounded(mesh, seedAt(*mesh, 0), tolerance);
  return static_cast<double>(WorkCount::steps() - before) / mesh->numberOfVertices();
}

}

TEST(Bounded, KeepsItsPromiseAgainstCgal)
{
  for (const auto& [surface, source] : std::vector<std::pair<Surface, Index>>{
         { spot(), 1700 }, { icosphere(4), 1001 }, { torus(60, 30, 1.0, 0.4), 777 } })
  {
    const auto truth = exactDistances(surface, { source });
    const auto mesh = meshOf(surface);
    for (const double tolerance : Tolerances)
    {
      expectWithin(truth, bounded(mesh, seedAt(*mesh, source), tolerance), tolerance);
    }
  }
}

TEST(Bounded, KeepsItsPromiseOnFlatAndRegularSurfaces)
{
  expectPromise(delaunayPlane(2000, 5), 1000);
  expectPromise(planeGrid(40, 40, 1.0, 1.0), 800);
  expectPromise(jitteredGrid(100, 10, 1000.0, 10.0, 0.3, 1), 500);
  // A cube cut in four as often as its sides have ties.
  expectPromise(subdivided(icosphere(0), 4), 0);
}

TEST(Bounded, KeepsItsPromiseOnNeedles)
{
  for (const double times : { 10.0, 100.0, 1000.0 })
  {
    expectPromise(flattened(spot(), times), 1700, RoundingOnNeedles);
    expectPromise(flattened(torus(60, 30, 1.0, 0.4), times), 777, RoundingOnNeedles);
    expectPromise(flattened(icosphere(4), times), 1001, RoundingOnNeedles);
  }
}

TEST(Bounded, KeepsItsPromiseOnALargeScan)
{
  expectPromise(bunny(), 17000);
}

// Non-manifold and careless surfaces, holes, parts; several seeds with values, on edges and in
// faces; barriers of points and cells.
TEST(Bounded, KeepsItsPromiseOnRandomMeshes)
{
  CaseLimits limits;
  limits.mostSeeds = 4;
  limits.mayHaveCosts = false;
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    const RandomCase c = randomCase(seed, limits);
    SCOPED_TRACE(c.description());
    const auto truth = distances<ExactSolver>(c.mesh, c.seeds, c.options());
    SolveOptions options = c.options();
    options.tolerance = Tolerances[seed / meshKinds().size() % std::size(Tolerances)];
    expectWithin(truth, distances<BoundedSolver>(c.mesh, c.seeds, options), options.tolerance,
      RoundingOnNeedles);
  }
}

// Random triangles over few points, all face sequences and all turns at vertices as the truth. In
// one of them a merged window once had its source in a vertex, but for rounding, and turned round
// it without end.
TEST(Bounded, IsWithinTheLeastOfAllFaceSequences)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int round = 0; round < 300; ++round)
  {
    const Index points = 6 + round % 5;
    Surface surface;
    std::vector<Index> order;
    for (Index i = 0; i < points; ++i)
    {
      const double x = uniform(random);
      const double y = uniform(random) * (round % 7 == 0 ? 1e-3 : 1.0);
      surface.points.push_back({ x, y, round % 3 == 0 ? 0.0 : uniform(random) });
      order.push_back(i);
    }
    for (int t = 0; t < 8; ++t)
    {
      std::shuffle(order.begin(), order.end(), random);
      surface.triangles.push_back({ order[0], order[1], order[2] });
    }
    const auto truth = leastOfFaceSequences(surface);
    const auto mesh = meshOf(surface);
    for (Index source = 0; source < points; ++source)
    {
      if (mesh->vertexOfPoint(source) != NoIndex)
      {
        SCOPED_TRACE("round " + std::to_string(round) + " from " + std::to_string(source));
        const double tolerance = Tolerances[round % 4];
        expectWithin(truth[source], bounded(mesh, seedAt(*mesh, source), tolerance), tolerance);
      }
    }
  }
}

// Exact windows a vertex grow with the root of the number of vertices: 51 and 99 here.
TEST(Bounded, WindowsAVertexStayFewOnFinerSurfaces)
{
  EXPECT_LE(windowsPerVertex(icosphere(5), 1e-3), 4.0);
  EXPECT_LE(windowsPerVertex(icosphere(6), 1e-3), 4.0);
  EXPECT_LE(windowsPerVertex(flattened(torus(200, 200, 1.0, 0.4), 1000.0), 1e-3), 16.0);
}

// Fields of other orders differ by the tolerance at most, as each is within it.
TEST(Bounded, TheOrderOfTheInputMattersWithinTheTolerance)
{
  for (const MeshKind kind : { MeshKind::Terrain, MeshKind::NonManifold, MeshKind::Needles })
  {
    const Surface surface = randomSurface(kind, 3);
    std::vector<Index> newId;
    const auto otherMesh = meshOf(shuffled(surface, 7, newId));
    const auto mesh = meshOf(surface);
    const Index source = surface.triangles[5][0];
    const auto d = bounded(mesh, seedAt(*mesh, source), 1e-3);
    const auto e = bounded(otherMesh, seedAt(*otherMesh, newId[source]), 1e-3);
    for (std::size_t i = 0; i < d.size(); ++i)
    {
      if (std::isfinite(d[i]) || std::isfinite(e[newId[i]]))
      {
        ASSERT_NEAR(d[i], e[newId[i]], 1e-3 * d[i] + 1e-12) << nameOf(kind);
      }
    }
  }
}

TEST(Bounded, StopsLeaveValuesWithinThePromise)
{
  const auto mesh = meshOf(spot());
  const Seed seed = seedAt(*mesh, 1700);
  const auto truth = distances<ExactSolver>(mesh, { seed });
  SolveOptions options;
  options.tolerance = 1e-2;
  options.maximumDistance = 0.4 * largestOf(truth);
  const auto near = distances<BoundedSolver>(mesh, { seed }, options);
  SolveOptions aimed;
  aimed.tolerance = 1e-2;
  const Index target = mesh->vertexOfPoint(400);
  const Triangle targets[] = { { target, target, target } };
  aimed.targets = targets;
  const auto upTo = distances<BoundedSolver>(mesh, { seed }, aimed);
  ASSERT_TRUE(std::isfinite(upTo[400]));
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    for (const auto& [d, stop] :
      { std::pair{ near[i], options.maximumDistance }, std::pair{ upTo[i], upTo[400] } })
    {
      EXPECT_LE(std::isfinite(d) ? d : 0.0, stop);
      if (truth[i] * 1.01 <= stop)
      {
        EXPECT_LE(d, truth[i] * 1.01);
        EXPECT_GE(d, truth[i] * (1.0 - Rounding));
      }
    }
  }
}

TEST(Bounded, RefusesWhatItCannotDo)
{
  const auto mesh = meshOf(planeGrid(3, 3, 1.0, 1.0));
  const auto messageOf = [&](const Seed& seed, const SolveOptions& options) {
    return errorOf([&] { BoundedSolver(mesh).solve({ &seed, 1 }, options); });
  };
  const std::vector<double> cost(mesh->numberOfVertices(), 2.0);
  SolveOptions options;
  options.cost = cost;
  EXPECT_NE(
    messageOf(seedAt(*mesh, 0), options).find("Bounded distances can't be measured with costs"),
    std::string::npos);
  for (const double tolerance : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    SolveOptions wrong;
    wrong.tolerance = tolerance;
    EXPECT_NE(messageOf(seedAt(*mesh, 0), wrong).find("it must be above 0"), std::string::npos);
  }
}

// What the proof rests on: a merged window is nowhere farther than the two, as far as they at its
// ends, and its excess covers what it lost.
TEST(Bounded, MergedWindowsAreLowerBoundsWithTheirExcess)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int merges = 0;
  for (int round = 0; round < 20000; ++round)
  {
    // Two windows that agree where they join, as the least of two fronts or behind a shadow's edge.
    const double join = 0.2 + 0.6 * uniform(random);
    const double far = std::pow(10.0, 3.0 * uniform(random) - 1.0);
    Window left{ 0.0, join, far * (uniform(random) - 0.5), far * uniform(random), uniform(random),
      0, false, static_cast<float>(1e-4 * uniform(random)) };
    Window right{ join, 1.0, far * (uniform(random) - 0.5), far * uniform(random), 0.0, 0, false,
      0.0F };
    // Either may be a straight front.
    for (Window* window : { &left, &right })
    {
      if (random() % 3 == 0)
      {
        window->isStraight = true;
        window->x = 1.9 * uniform(random) - 0.95;
        window->y = std::sqrt(1.0 - window->x * window->x);
        window->offset += 2.0;
      }
    }
    right.offset = left.distanceAt(join) - right.lineTo(join);
    WindowList list;
    list.insert(left);
    list.insert(right);
    WindowMerging(0.1).merge(list);
    if (list.windows().size() != 1)
    {
      continue;
    }
    ++merges;
    const Window merged = list.windows().front();
    EXPECT_NEAR(merged.distanceAt(0.0), left.distanceAt(0.0), 1e-12 * far);
    EXPECT_NEAR(merged.distanceAt(1.0), right.distanceAt(1.0), 1e-12 * far);
    EXPECT_LE(merged.excess, 0.1 * merged.leastDistance());
    for (double at = 0.0; at <= 1.0; at += 1.0 / 64)
    {
      const Window& part = at < join ? left : right;
      ASSERT_LE(merged.distanceAt(at), part.distanceAt(at) + 1e-11 * far) << round;
      ASSERT_GE(
        merged.distanceAt(at) + merged.excess, part.distanceAt(at) + part.excess - 1e-12 * far)
        << round;
    }
  }
  EXPECT_GE(merges, 1000);
}
