// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of windows ends at a cost that follows the surface, and leaves no point out, where
// rounding hides which of two lines is shorter.

#include "Solving.h"
#include "Surfaces.h"
#include "base/WorkCount.h"
#include "windows/BoundedSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <type_traits>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

template <class Solver>
class WindowMarch : public ::testing::Test
{
};

using WindowSolvers = ::testing::Types<ExactSolver, BoundedSolver>;
TYPED_TEST_SUITE(WindowMarch, WindowSolvers);

/** How many windows cross a triangle in a run. */
template <class Solver>
std::size_t windows(Solver& solver, const std::vector<Seed>& seeds)
{
  const std::size_t before = WorkCount::steps();
  solver.solve(seeds, {});
  return WorkCount::steps() - before;
}

/** A surface that is flattened along an axis, after all points were moved at random a little. */
Surface flattenedGrid(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  Surface surface = jitteredGrid(20 + seed % 20, 20, 1.0, 1.0, 0.3, seed);
  const double roughness = std::pow(10.0, -9.0 + 7.0 * (part(random) + 0.5));
  const double height = std::pow(10.0, -3.0 - seed % 5);
  for (Vector3& p : surface.points)
  {
    p.x += roughness * part(random);
    p.y = height * (p.y + roughness * part(random));
    p.z += roughness * part(random);
  }
  return surface;
}

}

// A line past the tip goes round it as often as the angle there fits into half a turn.
TYPED_TEST(WindowMarch, EndsRoundTheTipOfASpike)
{
  constexpr double tolerance = std::is_same_v<TypeParam, ExactSolver> ? 1e-9 : 1e-3;
  for (const double radius : { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10 })
  {
    for (const Index around : { 3, 20 })
    {
      const Index along = 50;
      const auto mesh = meshOf(cone(around, along, radius, 1.0));
      const Index source = 20 * around;
      TypeParam solver(mesh);
      EXPECT_LT(
        windows(solver, { seedAt(*mesh, source) }), 3000 * (mesh->numberOfVertices() + 1000))
        << around << " triangles at a tip, radius " << radius;
      const Vector3& from = mesh->position(mesh->vertexOfPoint(source));
      const DistanceField& field = solver.solve(std::vector{ seedAt(*mesh, source) }, {});
      for (Index v = 0; v < mesh->numberOfVertices(); ++v)
      {
        const double straight = norm(mesh->position(v) - from);
        ASSERT_GE(field.distance(v), straight * (1.0 - 1e-9));
        ASSERT_LE(field.distance(v), (straight + 4.0 * radius) * (1.0 + tolerance));
      }
    }
  }
}

// Rounding decides between lines past either side of a vertex, and none may lead behind it.
TYPED_TEST(WindowMarch, LeavesNoPointOfNeedlesOut)
{
  constexpr double rounding = std::is_same_v<TypeParam, ExactSolver> ? 1e-9 : 2e-3;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const auto mesh = meshOf(flattenedGrid(seed));
    TypeParam solver(mesh);
    const Index source = seed * 7919 % mesh->numberOfPoints();
    const DistanceField& field = solver.solve(std::vector{ seedAt(*mesh, source) }, {});
    for (Index v = 0; v < mesh->numberOfVertices(); ++v)
    {
      ASSERT_TRUE(std::isfinite(field.distance(v))) << "case " << seed << ", vertex " << v;
      for (const RingEntry& entry : mesh->ring(v))
      {
        const double edge = norm(mesh->position(v) - mesh->position(entry.neighbour()));
        ASSERT_LE(field.distance(v), (field.distance(entry.neighbour()) + edge) * (1.0 + rounding))
          << "case " << seed << ", vertex " << v;
      }
    }
  }
}

TYPED_TEST(WindowMarch, OfALineCostsTheSameAtAnyScale)
{
  std::vector<std::size_t> counts;
  for (const double scale : { 1.0, 0x1p-80, 0x1p80 })
  {
    Surface surface = icosphere(3);
    for (Vector3& p : surface.points)
    {
      p = scale * p;
    }
    const auto mesh = meshOf(surface);
    std::vector<SurfacePoint> line;
    for (const RingEntry& entry : mesh->ring(0))
    {
      line.push_back(mesh->pointAtVertex(entry.neighbour()));
    }
    TypeParam solver(mesh);
    counts.push_back(windows(solver, { Seed::alongCurve(line) }));
  }
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_EQ(counts[0], counts[2]);
}
