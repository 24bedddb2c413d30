// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// No distance of fast marching is longer than one along edges, whatever the triangles and however
// many seeds there are.

#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using MeshPointer = std::shared_ptr<const TriangleMesh>;

/** Points of triangles at random. */
std::vector<Seed> randomSeeds(const TriangleMesh& mesh, std::size_t count, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(0.05, 0.45);
  std::vector<Seed> seeds;
  while (seeds.size() < count)
  {
    const double a = part(random);
    const double b = part(random);
    const auto triangle = static_cast<Index>(random() % mesh.numberOfTriangles());
    seeds.push_back(Seed::atPoint({ triangle, { 1.0 - a - b, a, b } }));
  }
  return seeds;
}

/** By how much distances at most differ along an edge beyond its length, or are longer than those
 * along edges, in parts of the largest distance. */
template <class Solver>
double largestExcess(const MeshPointer& mesh, const std::vector<Seed>& seeds)
{
  Solver solver(mesh);
  const DistanceField& field = solver.solve(seeds);
  DijkstraSolver edges(mesh);
  const DistanceField& along = edges.solve(seeds);
  double excess = 0.0;
  for (const Triangle& t : mesh->triangles())
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = t[i];
      const Index b = t[(i + 1) % 3];
      if (along.isReached(a))
      {
        const double length = norm(mesh->position(a) - mesh->position(b));
        excess = std::max({ excess, field.distance(a) - along.distance(a),
          std::abs(field.distance(a) - field.distance(b)) - length });
      }
    }
  }
  return excess / std::max(along.largestDistance(), 1e-300);
}

/** A strip of needles, folded to and fro so that its sheets lie close to each other. */
Surface foldedNeedles(std::mt19937& random)
{
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Surface surface;
  const Index columns = 40;
  const double length = 0.3 + 3.0 * part(random);
  for (Index i = 0; i <= columns; ++i)
  {
    const double place = std::abs(i % 8 - 4.0);
    const double z = 1e-3 * i;
    surface.points.push_back({ 0.1 * place, 0.01 * part(random), z });
    surface.points.push_back({ 0.1 * place, length + 0.01 * part(random), z });
    if (i > 0)
    {
      surface.triangles.push_back({ 2 * i - 2, 2 * i, 2 * i - 1 });
      surface.triangles.push_back({ 2 * i, 2 * i + 1, 2 * i - 1 });
    }
  }
  return surface;
}

}

// Where seeds are dense, a label ends where others near in space are to stand for it. On folds and
// needles these can be far along the surface.
TEST(EdgeLowering, FieldsOfDenseSeedsAreNotLongerThanAlongEdges)
{
  std::mt19937 random(5);
  for (unsigned number = 0; number < 60; ++number)
  {
    const auto kinds = meshKinds();
    const MeshKind kind = kinds[number / 2 % kinds.size()];
    const auto mesh = meshOf(number % 2 == 0 ? foldedNeedles(random) : randomSurface(kind, number));
    const auto seeds = randomSeeds(*mesh, 30, random);
    EXPECT_LE(largestExcess<FastMarchingSolver>(mesh, seeds), 1e-9) << number;
    EXPECT_LE(largestExcess<ReferenceSolver>(mesh, seeds), 1e-9) << number;
  }
}

// Corner 4 is a corner of a triangle at the first segment of a line, and a step from the third
// point of the line, though in no triangle with the segments there.
TEST(EdgeLowering, ALineIsAsNearAlongAnEdgeAsThroughATriangle)
{
  const Surface surface{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 2, 0.1, 0 },
                           { 1.5, -1, 0 }, { 2.5, -1, 0 }, { 2, 1, 0 } },
    { { 0, 1, 4 }, { 1, 5, 2 }, { 2, 6, 3 }, { 2, 7, 4 } } };
  const auto mesh = meshOf(surface);
  std::vector<SurfacePoint> line;
  for (Index point = 0; point < 4; ++point)
  {
    line.push_back(mesh->pointAtVertex(mesh->vertexOfPoint(point)));
  }
  const Seed seed = Seed::alongCurve(line);
  EXPECT_NEAR(distances<FastMarchingSolver>(mesh, { seed })[4], 0.1, 1e-12);
  EXPECT_NEAR(distances<ReferenceSolver>(mesh, { seed })[4], 0.1, 1e-12);
}

// The march within bounds and the lowering go on from the steps before.
TEST(EdgeLowering, ProgressNeverFalls)
{
  std::mt19937 random(5);
  const auto mesh = meshOf(foldedNeedles(random));
  const auto seeds = randomSeeds(*mesh, 30, random);
  std::size_t last = 0;
  SolveOptions options;
  options.progressInterval = 1;
  options.onProgress = [&](std::size_t taken)
  {
    EXPECT_GE(taken, last);
    last = taken;
    return true;
  };
  FastMarchingSolver(mesh).solve(seeds, options);
  ReferenceSolver reference(mesh);
  last = 0;
  reference.solve(seeds, options);
  EXPECT_GT(last, mesh->numberOfVertices());
}
