// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact distances against CGAL, against all face sequences of small meshes, and against themselves.

#include "windows/ExactSolver.h"
#include "ClosedTwins.h"
#include "ExactDistances.h"
#include "FaceSequences.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "base/WorkCount.h"
#include "path/PathFinder.h"
#include "windows/BoundedSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Largest difference, in parts of the largest distance; -1 in the truth means unreached. */
double differenceFrom(const std::vector<double>& truth, const std::vector<double>& d)
{
  double difference = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const bool isReached = truth[i] >= 0.0 && std::isfinite(truth[i]);
    if (isReached != std::isfinite(d[i]))
    {
      return DistanceField::Unreached;
    }
    if (isReached)
    {
      difference = std::max(difference, std::abs(d[i] - truth[i]));
      largest = std::max(largest, truth[i]);
    }
  }
  return largest > 0.0 ? difference / largest : difference;
}

void expectExact(const Surface& surface, const std::vector<Index>& sources, double tolerance)
{
  const auto mesh = meshOf(surface);
  for (const Index source : sources)
  {
    const auto d = distances<ExactSolver>(mesh, { seedAt(*mesh, source) });
    EXPECT_LE(differenceFrom(exactDistances(surface, { source }), d), tolerance)
      << "from point " << source;
  }
}

Surface moved(Surface surface, const Vector3& stretch, const Vector3& by)
{
  for (Vector3& p : surface.points)
  {
    p = Vector3{ p.x * stretch.x, p.y * stretch.y, p.z * stretch.z } + by;
  }
  return surface;
}

/** The surface of the unit cube with cells x cells squares a side. */
Surface cube(Index cells)
{
  Surface all;
  const Surface side = planeGrid(cells, cells, 1.0, 1.0);
  for (int face = 0; face < 6; ++face)
  {
    const double height = face % 2;
    Surface turned = side;
    for (Vector3& p : turned.points)
    {
      p = face < 2 ? Vector3{ p.x, p.y, height }
        : face < 4 ? Vector3{ height, p.x, p.y }
                   : Vector3{ p.y, height, p.x };
    }
    all = joined(all, turned);
  }
  // Points of equal coordinates are one.
  std::vector<Index> number(all.points.size());
  Surface surface;
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    const auto same = std::find(surface.points.begin(), surface.points.end(), all.points[i]);
    number[i] = static_cast<Index>(same - surface.points.begin());
    if (same == surface.points.end())
    {
      surface.points.push_back(all.points[i]);
    }
  }
  for (std::size_t i = 0; i < all.triangles.size(); ++i)
  {
    const Triangle& t = all.triangles[i];
    const Triangle corners{ number[t[0]], number[t[1]], number[t[2]] };
    // Every other face is seen from inside.
    const bool isTurned = i / (all.triangles.size() / 6) % 2 == 0;
    surface.triangles.push_back(
      isTurned ? Triangle{ corners[0], corners[2], corners[1] } : corners);
  }
  return surface;
}

}

TEST(Exact, IsThatOfCgalOnCurvedSurfaces)
{
  expectExact(spot(), { 1700 }, 1e-11);
  expectExact(icosphere(4), { 1001 }, 1e-11);
  expectExact(torus(60, 30, 1.0, 0.4), { 777 }, 1e-11);
}

TEST(Exact, IsThatOfCgalOnFlatAndRegularSurfaces)
{
  expectExact(delaunayPlane(2000, 5), { 1000 }, 1e-11);
  expectExact(planeGrid(40, 40, 1.0, 1.0), { 800 }, 1e-11);
  expectExact(jitteredGrid(100, 10, 1000.0, 10.0, 0.3, 1), { 500 }, 1e-11);
  // At a corner and inside a side: all ties that symmetry makes.
  expectExact(cube(8), { 0, 40 }, 1e-11);
}

TEST(Exact, IsThatOfCgalOnNeedlesAndFarFromTheOrigin)
{
  expectExact(moved(spot(), { 1e-3, 1, 1 }, {}), { 1700 }, 1e-11);
  // The oracle itself loses digits out there, but on the way back none is lost.
  const Surface far = moved(spot(), { 1, 1, 1 }, { 1e6, 1e6, 1e6 });
  const Surface near = moved(far, { 1, 1, 1 }, { -1e6, -1e6, -1e6 });
  const auto mesh = meshOf(far);
  const auto d = distances<ExactSolver>(mesh, { seedAt(*mesh, 1700) });
  EXPECT_LE(differenceFrom(exactDistances(near, { 1700 }), d), 1e-11);
}

TEST(Exact, IsThatOfCgalFromPointsOnEdgesAndInFaces)
{
  const auto mesh = meshOf(spot());
  for (const auto& [triangle, weights, tolerance] :
    std::vector<std::tuple<Index, std::array<double, 3>, double>>{ { 10, { 0.5, 0.3, 0.2 }, 1e-11 },
      { 2000, { 0.01, 0.01, 0.98 }, 1e-11 },
      // The oracle moves a point on an edge by a billionth of the face.
      { 3000, { 0.4, 0.6, 0.0 }, 1e-9 } })
  {
    Seed seed = Seed::atPoint({ triangle, weights });
    SurfacePoint inInput{ mesh->sourceOfTriangle(triangle), weights };
    // The mesh may begin the triangle at another corner.
    const Triangle& given = spot().triangles[inInput.triangle];
    for (int c = 0; c < 3; ++c)
    {
      const auto place =
        std::find(given.begin(), given.end(), mesh->pointOfVertex(mesh->triangle(triangle)[c]));
      inInput.weights[place - given.begin()] = weights[c];
    }
    const auto d = distances<ExactSolver>(mesh, { seed });
    EXPECT_LE(differenceFrom(exactDistancesFrom(spot(), inInput), d), tolerance);
  }
}

TEST(Exact, IsThatOfCgalOnRandomManifolds)
{
  const std::vector<MeshKind> kinds{ MeshKind::Closed, MeshKind::Terrain, MeshKind::Grid,
    MeshKind::Torus, MeshKind::Needles, MeshKind::Graded, MeshKind::Strip };
  for (unsigned seed = 0; seed < 21; ++seed)
  {
    const MeshKind kind = kinds[seed % kinds.size()];
    SCOPED_TRACE(nameOf(kind) + " " + std::to_string(seed));
    const Surface surface = randomSurface(kind, seed);
    expectExact(surface, { surface.triangles[seed][0] }, kind == MeshKind::Needles ? 1e-9 : 1e-11);
  }
}

// Random triangles over few points: edges of many triangles, borders, sheets that meet in points or
// cross, doubled triangles, parts. All face sequences, and all turns at vertices, are the truth.
TEST(Exact, IsTheLeastOfAllFaceSequences)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int round = 0; round < 10000; ++round)
  {
    const Index points = 6 + round % 5;
    const bool isFlat = round % 3 == 0;
    Surface surface;
    for (Index i = 0; i < points; ++i)
    {
      const double x = uniform(random);
      const double y = uniform(random) * (round % 7 == 0 ? 1e-3 : 1.0);
      surface.points.push_back({ x, y, isFlat ? 0.0 : uniform(random) });
    }
    std::vector<Index> order(points);
    for (Index i = 0; i < points; ++i)
    {
      order[i] = i;
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
        const auto d = distances<ExactSolver>(mesh, { seedAt(*mesh, source) });
        ASSERT_LE(differenceFrom(truth[source], d), 1e-11) << "round " << round << " " << source;
      }
    }
  }
}

// Also where CGAL has no answer: non-manifold and careless surfaces, holes, parts.
// Sheets that lie on each other and share edges: windows that go from sheet to sheet and back must
// die out. Once 15 million of them crossed 8 triangles, and round 1,680 did not end.
TEST(Exact, WindowsDieOutBetweenSheets)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int round = 0; round < 1800; ++round)
  {
    const Index points = 6 + round % 5;
    Surface surface;
    for (Index i = 0; i < points; ++i)
    {
      const double x = uniform(random);
      const double y = uniform(random) * (round % 7 == 0 ? 1e-3 : 1.0);
      surface.points.push_back({ x, y, round % 3 == 0 ? 0.0 : uniform(random) });
    }
    std::vector<Index> order(points);
    std::iota(order.begin(), order.end(), Index{ 0 });
    for (int t = 0; t < 8; ++t)
    {
      std::shuffle(order.begin(), order.end(), random);
      surface.triangles.push_back({ order[0], order[1], order[2] });
    }
    const auto mesh = meshOf(surface);
    ExactSolver exact(mesh);
    BoundedSolver bounded(mesh);
    for (DistanceSolver* solver : std::array<DistanceSolver*, 2>{ &exact, &bounded })
    {
      for (Index vertex = 0; vertex < mesh->numberOfVertices(); ++vertex)
      {
        const Seed seed = Seed::atPoint(mesh->pointAtVertex(vertex));
        const std::size_t before = WorkCount::steps();
        SolveOptions options;
        options.onProgress = [&](std::size_t) { return WorkCount::steps() - before < 1'000'000; };
        solver->solve({ &seed, 1 }, options);
        ASSERT_LT(WorkCount::steps() - before, 100'000u) << "round " << round;
      }
    }
  }
}

TEST(Exact, IsSymmetricOnRandomMeshes)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const MeshKind kind = meshKinds()[seed % meshKinds().size()];
    const auto mesh = meshOf(randomSurface(kind, seed));
    ExactSolver solver(mesh);
    std::vector<Index> ends;
    for (Index i = 0; i < 6; ++i)
    {
      ends.push_back(i * (mesh->numberOfVertices() - 1) / 5);
    }
    std::vector<std::vector<double>> between;
    double largest = 0.0;
    for (const Index a : ends)
    {
      const Seed source = Seed::atPoint(mesh->pointAtVertex(a));
      const DistanceField& field = solver.solve({ &source, 1 });
      largest = std::max(largest, field.largestDistance());
      between.emplace_back();
      for (const Index b : ends)
      {
        between.back().push_back(field.distance(b));
      }
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (between[i][j] != between[j][i])
        {
          ASSERT_NEAR(between[i][j], between[j][i], 1e-11 * largest) << nameOf(kind) << " " << seed;
        }
      }
    }
  }
}

TEST(Exact, DoesNotDependOnTheOrderOfTheInput)
{
  for (const MeshKind kind : { MeshKind::Terrain, MeshKind::NonManifold, MeshKind::Careless })
  {
    const Surface surface = randomSurface(kind, 3);
    std::vector<Index> newId;
    const Surface other = shuffled(surface, 7, newId);
    const auto mesh = meshOf(surface);
    const auto otherMesh = meshOf(other);
    const Index source = surface.triangles[5][0];
    const auto d = distances<ExactSolver>(mesh, { seedAt(*mesh, source) });
    const auto e = distances<ExactSolver>(otherMesh, { seedAt(*otherMesh, newId[source]) });
    std::vector<double> back(d.size());
    for (std::size_t i = 0; i < d.size(); ++i)
    {
      back[i] = e[newId[i]];
    }
    EXPECT_LE(differenceFrom(d, back), 1e-12) << nameOf(kind);
  }
}

// The field of several seeds is the least of their single fields with their values added, and so
// is its nearest seed.
TEST(Exact, SeveralSeedsGiveTheLeastOfTheirFields)
{
  const auto mesh = meshOf(spot());
  std::vector<Seed> seeds{ seedAt(*mesh, 0), seedAt(*mesh, 1500), seedAt(*mesh, 2900),
    Seed::atPoint({ 77, { 0.2, 0.5, 0.3 } }) };
  seeds[1].value = 0.2;
  seeds[3].value = 5.0;
  ExactSolver together(mesh);
  ExactSolver single(mesh);
  const DistanceField& field = together.solve(seeds);
  std::vector<double> least(mesh->numberOfVertices(), DistanceField::Unreached);
  std::vector<Index> nearest(mesh->numberOfVertices(), NoIndex);
  for (Index s = 0; s < seeds.size(); ++s)
  {
    const DistanceField& one = single.solve({ &seeds[s], 1 });
    for (Index v = 0; v < mesh->numberOfVertices(); ++v)
    {
      if (one.distance(v) < least[v])
      {
        least[v] = one.distance(v);
        nearest[v] = s;
      }
    }
  }
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    ASSERT_NEAR(field.distance(v), least[v], 1e-12);
    ASSERT_EQ(field.nearestSeed(v), nearest[v]);
  }
  EXPECT_EQ(std::count(nearest.begin(), nearest.end(), Index{ 3 }), 0);
}

// Past the end of a slit the shortest path turns there: two straight parts.
TEST(Exact, PathsTurnAtTheEndOfABarrier)
{
  const Surface plane = planeGrid(20, 20, 20.0, 20.0);
  const auto mesh = meshOf(plane);
  const Vector3 source{ 10, 2, 0 };
  const auto at = [&](const Vector3& p)
  {
    return static_cast<Index>(
      std::find(plane.points.begin(), plane.points.end(), p) - plane.points.begin());
  };
  const Seed seed = seedAt(*mesh, at(source));
  // Cells between y = 8 and 9, up to x = 15, are closed.
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles(), 0);
  for (Index t = 0; t < mesh->numberOfTriangles(); ++t)
  {
    const Vector3 middle = mesh->positionOf({ t, { 1.0 / 3, 1.0 / 3, 1.0 / 3 } });
    closed[t] = middle.x < 15.0 && middle.y > 8.0 && middle.y < 9.0 ? 1 : 0;
  }
  SolveOptions options;
  options.closedTriangles = closed;
  const auto d = distances<ExactSolver>(mesh, { seed }, options);
  const Vector3 low{ 15, 8, 0 };
  const Vector3 high{ 15, 9, 0 };
  const Vector3 behind{ 3, 12, 0 };
  EXPECT_NEAR(d[at(behind)], norm(low - source) + 1.0 + norm(behind - high), 1e-12);
  const Vector3 beside{ 19, 10, 0 };
  EXPECT_NEAR(d[at(beside)], norm(beside - source), 1e-12);
}

// A path traced down an exact field and straightened is a way over the surface, so never shorter
// than the distance, and mostly the shortest; of other ways round a bump it may have taken the
// longer one.
TEST(Exact, PathsFollowTheField)
{
  const auto mesh = meshOf(spot());
  ExactSolver solver(mesh);
  const SurfacePoint end = mesh->pointAtVertex(100);
  const Seed seed = Seed::atPoint(end);
  const auto field = solver.solve({ &seed, 1 }).distances();
  const std::vector<double> exact(field.begin(), field.end());
  int shortest = 0;
  const int paths = 40;
  for (int i = 0; i < paths; ++i)
  {
    const Index start = static_cast<Index>(70 * i + 3);
    const auto path = shortestPath(solver, mesh->pointAtVertex(start), end, {}, {});
    ASSERT_TRUE(path);
    const double excess = lengthOf(*mesh, *path) / exact[start] - 1.0;
    EXPECT_GE(excess, -1e-12);
    EXPECT_LE(excess, 0.01);
    shortest += excess < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(shortest, paths * 8 / 10);
}

TEST(Exact, RefusesWhatItCannotDo)
{
  const auto mesh = meshOf(planeGrid(30, 30, 1.0, 1.0));
  const auto messageOf = [&](const Seed& seed, const SolveOptions& options) {
    return errorOf([&] { ExactSolver(mesh).solve({ &seed, 1 }, options); });
  };
  const std::vector<double> cost(mesh->numberOfVertices(), 2.0);
  SolveOptions costly;
  costly.cost = cost;
  EXPECT_NE(messageOf(seedAt(*mesh, 0), costly).find("with costs"), std::string::npos);
  SolveOptions tight;
  tight.memoryLimit = 1000;
  const Seed middle = seedAt(*mesh, 400);
  const std::string message = errorOf<std::runtime_error>(
    [&] {
      ExactSolver(mesh).solve({ &middle, 1 }, tight);
    });
  EXPECT_NE(message.find("more than the memory limit of 1e-06 GB"), std::string::npos) << message;
  EXPECT_NE(message.find("of 961 vertices"), std::string::npos) << message;
}

// A run leaves nothing for the next one, whether it came to its end or not.
TEST(Exact, ARunAfterACancelledOneIsWhole)
{
  const auto mesh = meshOf(icosphere(4));
  const Seed seed = seedAt(*mesh, 0);
  ExactSolver solver(mesh);
  const std::vector<double> whole = [&]
  {
    const auto d = solver.solve({ &seed, 1 }).distances();
    return std::vector<double>(d.begin(), d.end());
  }();
  SolveOptions options;
  options.onProgress = [](std::size_t count) { return count < 1000; };
  EXPECT_EQ(solver.solve({ &seed, 1 }, options).stopReason(), StopReason::Cancelled);
  const auto again = solver.solve({ &seed, 1 }).distances();
  EXPECT_TRUE(std::equal(whole.begin(), whole.end(), again.begin(), again.end()));
}

TEST(Exact, ARunAfterOneThatNeededTooMuchMemoryIsWhole)
{
  const auto mesh = meshOf(icosphere(4));
  const Seed seed = seedAt(*mesh, 0);
  ExactSolver solver(mesh);
  SolveOptions tight;
  tight.memoryLimit = 1000;
  EXPECT_NE(errorOf<std::runtime_error>([&] { solver.solve({ &seed, 1 }, tight); }), "");
  const auto again = solver.solve({ &seed, 1 }).distances();
  const std::vector<double> whole = distances<ExactSolver>(mesh, { seed });
  for (Index i = 0; i < mesh->numberOfPoints(); ++i)
  {
    ASSERT_EQ(again[mesh->vertexOfPoint(i)], whole[i]);
  }
}

// A run can be cancelled while its seeds are placed, and where nothing new is reached for long.
TEST(Exact, ManySeedsReportProgress)
{
  const auto mesh = meshOf(planeGrid(2, 2, 1.0, 1.0));
  const std::vector<Seed> seeds(20000, Seed::atPoint({ 0, { 0.3, 0.3, 0.4 } }));
  ExactSolver solver(mesh);
  std::size_t calls = 0;
  SolveOptions options;
  options.onProgress = [&](std::size_t) { return ++calls < 5; };
  EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
  EXPECT_EQ(calls, 5);
}

TEST(Exact, ATriangleOnAClosedOneIsClosed)
{
  expectClosedTwins<ExactSolver>();
}
