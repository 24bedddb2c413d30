// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh whose points move is the one that is built of them.

#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/UpdateBounds.h"
#include "mesh/DistinctPositions.h"
#include "methods/KeptSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

Vector3 bent(const Vector3& p)
{
  return { p.x + 0.3 * std::sin(2.0 * p.y), 1.3 * p.y + 0.2 * std::cos(p.z),
    p.z + 0.4 * std::sin(p.x + p.y) };
}

Surface bent(Surface surface)
{
  for (Vector3& p : surface.points)
  {
    p = bent(p);
  }
  return surface;
}

/** The bent input of a mesh; triangles have the numbers of the mesh. */
Surface bentSurfaceOf(const TriangleMesh& mesh)
{
  Surface surface{ std::vector<Vector3>(mesh.numberOfPoints()), {} };
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    surface.points[mesh.pointOfVertex(v)] = bent(mesh.position(v));
  }
  for (const auto& [a, b, c] : mesh.triangles())
  {
    surface.triangles.push_back(
      { mesh.pointOfVertex(a), mesh.pointOfVertex(b), mesh.pointOfVertex(c) });
  }
  return surface;
}

std::shared_ptr<const TriangleMesh> movedTo(
  const TriangleMesh& mesh, const Surface& surface, CoincidentPoints coincident)
{
  auto moved = mesh.withPositions(surface.points, coincident);
  return moved ? std::make_shared<const TriangleMesh>(std::move(*moved)) : nullptr;
}

/** Each ring entry that opens a triangle, by points of the input, with its slack. */
std::vector<std::tuple<Index, Index, Index, EntryNumber>> slacksOf(const TriangleMesh& mesh)
{
  std::vector<std::tuple<Index, Index, Index, EntryNumber>> slacks;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const auto ring = mesh.ring(v);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const EntryNumber slack = mesh.numbers()->ofEntries[mesh.rings().firstEntry(v) + i];
      if (!ring[i].opensTriangle())
      {
        EXPECT_EQ(slack, updateMeasurer().ofNoTriangle());
        continue;
      }
      const auto [a, b] = std::minmax(
        { mesh.pointOfVertex(ring[i].neighbour()), mesh.pointOfVertex(ring[i + 1].neighbour()) });
      slacks.emplace_back(mesh.pointOfVertex(v), a, b, slack);
    }
  }
  std::sort(slacks.begin(), slacks.end());
  return slacks;
}

/** All that a mesh tells of the points of its input, but for the order of vertices. */
void expectSameMesh(const TriangleMesh& moved, const TriangleMesh& built)
{
  ASSERT_EQ(moved.numberOfPoints(), built.numberOfPoints());
  ASSERT_EQ(moved.numberOfVertices(), built.numberOfVertices());
  ASSERT_EQ(moved.numberOfTriangles(), built.numberOfTriangles());
  for (Index p = 0; p < built.numberOfPoints(); ++p)
  {
    const Index v = moved.vertexOfPoint(p);
    const Index w = built.vertexOfPoint(p);
    ASSERT_EQ(v == NoIndex, w == NoIndex);
    if (v != NoIndex)
    {
      ASSERT_EQ(moved.pointOfVertex(v), built.pointOfVertex(w));
      ASSERT_EQ(moved.position(v), built.position(w));
      ASSERT_EQ(moved.longestEdgeAround(v), built.longestEdgeAround(w));
      ASSERT_EQ(moved.numbers()->ofVertices[v], built.numbers()->ofVertices[w]);
    }
  }
  EXPECT_EQ(moved.longestEdgeLength(), built.longestEdgeLength());
  EXPECT_NEAR(moved.meanLongestEdge(), built.meanLongestEdge(), 1e-12 * built.meanLongestEdge());
  EXPECT_EQ(slacksOf(moved), slacksOf(built));
}

/** Values at vertices of one mesh, for another one of the same input. */
template <class Value>
std::vector<Value> valuesOn(
  const TriangleMesh& to, const TriangleMesh& from, const std::vector<Value>& values)
{
  std::vector<Value> result(values.empty() ? 0 : to.numberOfVertices());
  for (Index v = 0; v < result.size(); ++v)
  {
    result[v] = values[from.vertexOfPoint(to.pointOfVertex(v))];
  }
  return result;
}

/** Largest difference of distances at the input's points, in parts of the largest distance. */
double difference(
  const TriangleMesh& a, const DistanceField& ofA, const TriangleMesh& b, const DistanceField& ofB)
{
  double largest = 0.0;
  for (Index p = 0; p < a.numberOfPoints(); ++p)
  {
    if (a.vertexOfPoint(p) != NoIndex)
    {
      const double x = ofA.distance(a.vertexOfPoint(p));
      const double y = ofB.distance(b.vertexOfPoint(p));
      largest = x == y ? largest : std::max(largest, std::abs(x - y));
    }
  }
  return largest / std::max(ofB.largestDistance(), std::numeric_limits<double>::min());
}

bool isMadeOf(const Surface& surface, const std::vector<Triangle>& triangles)
{
  return meshOf(surface, CoincidentPoints::Merge)->isMadeOf(triangles);
}

}

TEST(Motion, GivesTheMeshThatIsBuiltOfThePoints)
{
  for (unsigned seed = 0; seed < 4 * meshKinds().size(); ++seed)
  {
    const MeshKind kind = meshKinds()[seed % meshKinds().size()];
    SCOPED_TRACE(nameOf(kind) + ", " + std::to_string(seed));
    const Surface surface = randomSurface(kind, seed);
    for (const auto coincident : { CoincidentPoints::Separate, CoincidentPoints::Merge })
    {
      const auto mesh = meshOf(surface, coincident);
      const Surface other = bent(surface);
      const auto moved = movedTo(*mesh, other, coincident);
      ASSERT_TRUE(moved);
      EXPECT_TRUE(moved->hasStructureOf(*mesh));
      expectSameMesh(*moved, *meshOf(other, coincident));
      // Once more, and back.
      const auto back = movedTo(*movedTo(*moved, bent(other), coincident), surface, coincident);
      ASSERT_TRUE(back);
      expectSameMesh(*back, *mesh);
      EXPECT_TRUE(std::equal(back->positions().begin(), back->positions().end(),
        mesh->positions().begin(), mesh->positions().end()));
    }
  }
}

TEST(Motion, DoesNotDependOnTheNumberOfThreads)
{
  const Surface surface = torus(120, 60, 1.0, 0.4);
  const auto mesh = meshOf(surface);
  const Surface other = bent(surface);
  for (const unsigned threads : { 1u, 2u, 5u })
  {
    const auto moved =
      mesh->withPositions(other.points, CoincidentPoints::Merge, ThreadTeam(threads));
    ASSERT_TRUE(moved);
    expectSameMesh(*moved, *meshOf(other));
  }
}

// A mesh without a measurer has no numbers but the longest sides.
TEST(Motion, NeedsNoMeasurer)
{
  const Surface surface = icosphere(2);
  const Surface other = bent(surface);
  const auto moved = TriangleMesh(surface.points, surface.triangles)
                       .withPositions(other.points, CoincidentPoints::Separate);
  ASSERT_TRUE(moved);
  EXPECT_FALSE(moved->numbers());
  const TriangleMesh built(other.points, other.triangles);
  for (Index p = 0; p < built.numberOfPoints(); ++p)
  {
    EXPECT_EQ(moved->longestEdgeAround(moved->vertexOfPoint(p)),
      built.longestEdgeAround(built.vertexOfPoint(p)));
  }
}

// The rings of many triangles round one point are linked by sorting.
TEST(Motion, OfADisc)
{
  const Surface surface = disc(500);
  const auto moved = movedTo(*meshOf(surface), bent(surface), CoincidentPoints::Merge);
  ASSERT_TRUE(moved);
  expectSameMesh(*moved, *meshOf(bent(surface)));
}

TEST(Motion, OfAMeshWithoutSomeTriangles)
{
  const Surface surface = icosphere(2);
  std::vector<bool> leftOut(surface.triangles.size());
  for (std::size_t t = 0; t < leftOut.size(); t += 3)
  {
    leftOut[t] = true;
  }
  const Surface other = bent(surface);
  const auto mesh = meshOf(surface);
  const auto moved = mesh->without(leftOut).withPositions(other.points, CoincidentPoints::Merge);
  ASSERT_TRUE(moved);
  EXPECT_FALSE(moved->hasStructureOf(*mesh));
  const auto whole = movedTo(*mesh, other, CoincidentPoints::Merge);
  const TriangleMesh expected = whole->without(leftOut);
  expectSameMesh(*moved, expected);
}

TEST(Motion, EndsWherePointsMeetOrPart)
{
  Surface surface = planeGrid(6, 6, 1.0, 1.0);
  // Two points of one place.
  surface.points[10] = surface.points[11];
  const auto merged = meshOf(surface, CoincidentPoints::Merge);
  const auto separate = meshOf(surface, CoincidentPoints::Separate);
  EXPECT_TRUE(movedTo(*merged, bent(surface), CoincidentPoints::Merge));

  Surface parted = bent(surface);
  parted.points[10].z += 0.1;
  EXPECT_FALSE(movedTo(*merged, parted, CoincidentPoints::Merge));
  EXPECT_TRUE(movedTo(*separate, parted, CoincidentPoints::Separate));

  Surface met = bent(surface);
  met.points[30] = met.points[40];
  EXPECT_FALSE(movedTo(*merged, met, CoincidentPoints::Merge));
  EXPECT_TRUE(movedTo(*separate, met, CoincidentPoints::Separate));
}

// Three points in one place make a triangle that is left out, and they are no vertices.
TEST(Motion, EndsWhereALeftOutTriangleOpens)
{
  Surface surface = planeGrid(3, 3, 1.0, 1.0);
  const Index first = static_cast<Index>(surface.points.size());
  surface.points.insert(surface.points.end(), 3, { 5.0, 5.0, 5.0 });
  surface.triangles.push_back({ first, first + 1, first + 2 });
  const auto mesh = meshOf(surface, CoincidentPoints::Merge);
  ASSERT_EQ(mesh->vertexOfPoint(first), NoIndex);
  EXPECT_TRUE(movedTo(*mesh, bent(surface), CoincidentPoints::Merge));
  surface.points[first].x = 6.0;
  EXPECT_FALSE(movedTo(*mesh, surface, CoincidentPoints::Merge));
  surface.points[first].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(movedTo(*mesh, surface, CoincidentPoints::Merge));
}

TEST(Motion, EndsAtAPositionThatIsNotFinite)
{
  Surface surface = icosphere(2);
  const auto mesh = meshOf(surface);
  surface.points.back().y = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(movedTo(*mesh, surface, CoincidentPoints::Separate));
  surface.points.back().y = 1e40;
  EXPECT_THROW(movedTo(*mesh, surface, CoincidentPoints::Separate), std::invalid_argument);
}

TEST(Motion, KeepsKindsOfPoints)
{
  const Surface surface = joined(planeGrid(4, 4, 1.0, 1.0), planeGrid(4, 4, 1.0, 1.0));
  const Index half = static_cast<Index>(surface.points.size() / 2);
  std::vector<Index> kinds(surface.points.size());
  for (Index p = 0; p < kinds.size(); ++p)
  {
    kinds[p] = p % half;
  }
  const auto built = [&](const Surface& of, const std::vector<Index>& by)
  { return TriangleMesh(of.points, of.triangles, by, ThreadTeam(), &updateMeasurer()); };
  const TriangleMesh mesh = built(surface, kinds);
  const Surface other = bent(surface);
  const auto moved = mesh.withPositions(other.points, kinds);
  ASSERT_TRUE(moved);
  expectSameMesh(*moved, built(other, kinds));
  // The numbers of kinds do not matter.
  std::vector<Index> renumbered = kinds;
  for (Index& kind : renumbered)
  {
    kind = half - 1 - kind;
  }
  EXPECT_TRUE(mesh.withPositions(other.points, renumbered));
  kinds[half] = half;
  EXPECT_FALSE(mesh.withPositions(other.points, kinds));
  EXPECT_FALSE(built(surface, kinds).withPositions(other.points, renumbered));
  Surface broken = other;
  broken.points[half].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(mesh.withPositions(broken.points, renumbered));
}

TEST(Motion, KnowsTheTrianglesOfAMesh)
{
  Surface surface = planeGrid(4, 4, 1.0, 1.0);
  // Two points of one place, with a triangle each, and one that has both and is left out.
  surface.points.push_back(surface.points[0]);
  const Index twin = static_cast<Index>(surface.points.size() - 1);
  surface.triangles.push_back({ twin, 7, 8 });
  surface.triangles.push_back({ 0, twin, 3 });
  const std::vector<Triangle>& triangles = surface.triangles;
  EXPECT_TRUE(isMadeOf(surface, triangles));
  const auto with = [&](std::size_t number, const Triangle& t)
  {
    std::vector<Triangle> others = triangles;
    others[number] = t;
    return others;
  };
  const Triangle third = triangles[2];
  EXPECT_FALSE(isMadeOf(surface, with(2, { third[1], third[2], third[0] })));
  EXPECT_FALSE(isMadeOf(surface, with(2, { third[0], third[0], third[2] })));
  EXPECT_FALSE(isMadeOf(surface, with(2, { third[0], third[1], 1000 })));
  std::vector<Triangle> fewer = triangles;
  fewer.pop_back();
  EXPECT_FALSE(isMadeOf(surface, fewer));
  std::vector<Triangle> more = triangles;
  more.push_back({ 0, twin, 7 });
  EXPECT_FALSE(isMadeOf(surface, more));
  // The same vertices, but the twin is no longer used.
  std::vector<Triangle> withoutTwin = triangles;
  withoutTwin[triangles.size() - 2][0] = 0;
  withoutTwin.back()[1] = 0;
  EXPECT_FALSE(isMadeOf(surface, withoutTwin));
  // The same where no triangle is left out.
  Surface whole = surface;
  whole.triangles.pop_back();
  withoutTwin.pop_back();
  EXPECT_TRUE(isMadeOf(whole, whole.triangles));
  EXPECT_FALSE(isMadeOf(whole, withoutTwin));
  // The left-out triangle opens.
  std::vector<Triangle> open = triangles;
  open.back()[1] = 4;
  EXPECT_FALSE(isMadeOf(surface, open));
}

// Points that only a left-out triangle uses count as used.
TEST(Motion, KnowsTheTrianglesOfAMeshWithBarePoints)
{
  Surface surface = planeGrid(3, 3, 1.0, 1.0);
  const Index first = static_cast<Index>(surface.points.size());
  surface.points.insert(surface.points.end(), 4, { 5.0, 5.0, 5.0 });
  surface.triangles.push_back({ first, first + 1, first + 2 });
  const auto mesh = meshOf(surface, CoincidentPoints::Merge);
  const auto moved = movedTo(*mesh, bent(surface), CoincidentPoints::Merge);
  ASSERT_TRUE(moved);
  std::vector<Triangle> others = surface.triangles;
  others.back()[2] = first + 3;
  for (const auto& of : { mesh, moved })
  {
    EXPECT_TRUE(of->isMadeOf(surface.triangles));
    EXPECT_FALSE(of->isMadeOf(others));
  }
}

// Solvers that go over to a moved mesh keep nothing of the old one: after a run with the same
// options on the old mesh they give, to the bit, the field of a new solver.
TEST(Motion, SolversGoOverToMovedMeshes)
{
  for (unsigned seed = 0; seed < 120; ++seed)
  {
    CaseLimits limits;
    limits.mostSeeds = seed % 2 == 0 ? 1 : 12;
    const RandomCase test = randomCase(seed, limits);
    SCOPED_TRACE("case " + std::to_string(seed) + ": " + test.description());
    const TriangleMesh& mesh = *test.mesh;
    const Surface other = bentSurfaceOf(mesh);
    const auto moved = movedTo(mesh, other, CoincidentPoints::Separate);
    ASSERT_TRUE(moved);
    SolveOptions options = test.options();
    const std::vector<Triangle> targets{ mesh.triangle(mesh.numberOfTriangles() / 2) };
    options.targets = seed % 3 == 0 ? std::span<const Triangle>(targets) : options.targets;
    for (const SolverTraits& method : solverTable())
    {
      if ((!test.cost.empty() && !method.takesCosts) ||
        ((!test.excluded.empty() || !test.closedTriangles.empty()) && !method.takesBarriers))
      {
        continue;
      }
      SCOPED_TRACE(method.name);
      KeptSolver kept;
      kept.get(method, test.mesh).solve(test.seeds, options);
      const DistanceSolver* const before = &kept.get(method, test.mesh);
      DistanceSolver& solver = kept.get(method, moved);
      EXPECT_EQ(&solver.mesh(), moved.get());
      const bool movesOver = std::string(method.name) == "FastMarching" ||
        std::string(method.name) == "Dijkstra" || std::string(method.name) == "Reference";
      EXPECT_TRUE(!movesOver || &solver == before);
      const auto fresh = method.make(moved);
      options.keepsSurface = true;
      const DistanceField& found = solver.solve(test.seeds, options);
      options.keepsSurface = false;
      const DistanceField& truth = fresh->solve(test.seeds, options);
      for (Index v = 0; v < mesh.numberOfVertices(); ++v)
      {
        ASSERT_EQ(found.distance(v), truth.distance(v));
        ASSERT_EQ(found.nearestSeed(v), truth.nearestSeed(v));
      }
    }
  }
}

// The first run on a moved mesh takes neither cost nor barriers for those of the run before, also
// where a caller says that they are.
TEST(Motion, TheFirstRunOnAMovedMeshKeepsNoCostAndNoBarrier)
{
  const auto mesh = meshOf(planeGrid(12, 12, 1.0, 1.0));
  const auto moved = movedTo(*mesh, bentSurfaceOf(*mesh), CoincidentPoints::Separate);
  ASSERT_TRUE(moved);
  const Seed seed = seedAt(*mesh, 0);
  const std::vector<double> cheap(mesh->numberOfVertices(), 1.0);
  const std::vector<double> dear(mesh->numberOfVertices(), 3.0);
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
  for (Index t = 0; t < mesh->numberOfTriangles(); ++t)
  {
    const double x = mesh->positionOf({ t, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } }).x;
    closed[t] = x > 0.4 && x < 0.6 ? 1 : 0;
  }
  for (const SolverTraits& method : solverTable())
  {
    if (!method.takesCosts || !method.takesBarriers)
    {
      continue;
    }
    SCOPED_TRACE(method.name);
    const auto solver = method.make(mesh);
    SolveOptions before;
    before.cost = cheap;
    solver->solve({ &seed, 1 }, before);
    ASSERT_TRUE(solver->moveTo(moved));
    SolveOptions after;
    after.cost = dear;
    after.closedTriangles = closed;
    const auto fresh = method.make(moved);
    const auto truth = fresh->solve({ &seed, 1 }, after).distances();
    after.keepsSurface = true;
    const auto found = solver->solve({ &seed, 1 }, after).distances();
    EXPECT_TRUE(std::equal(truth.begin(), truth.end(), found.begin()));
  }
}

// The order of vertices is that of the first positions, and no field depends on it but for
// rounding.
TEST(Motion, FieldsAreThoseOfAMeshBuiltOfThePoints)
{
  CaseLimits limits;
  limits.mayHaveBarriers = false;
  for (unsigned seed = 0; seed < 120; ++seed)
  {
    const RandomCase test = randomCase(seed, limits);
    SCOPED_TRACE("case " + std::to_string(seed) + ": " + test.description());
    const TriangleMesh& mesh = *test.mesh;
    const Surface other = bentSurfaceOf(mesh);
    // Its sources are the triangles of the first mesh.
    const auto built = meshOf(other);
    const auto moved = movedTo(mesh, other, CoincidentPoints::Separate);
    ASSERT_TRUE(moved);
    std::vector<Seed> seeds;
    for (Seed s : test.seeds)
    {
      for (SurfacePoint& point : s.points)
      {
        Index t = 0;
        while (built->sourceOfTriangle(t) != point.triangle)
        {
          ++t;
        }
        point.triangle = t;
      }
      seeds.push_back(s);
    }
    SolveOptions options = test.options();
    FastMarchingSolver onMoved(moved);
    const DistanceField& found = onMoved.solve(test.seeds, options);
    const std::vector<double> cost = valuesOn(*built, mesh, test.cost);
    options.cost = cost;
    FastMarchingSolver onBuilt(built);
    EXPECT_LE(difference(*moved, found, *built, onBuilt.solve(seeds, options)), 1e-9);
  }
}

// A march leaves out gains below 1e-12 of a value, so that much depends on the order.
TEST(Motion, FieldsOnSmoothSurfacesDifferByRounding)
{
  Surface surface = torus(150, 60, 1.0, 0.4);
  auto mesh = meshOf(surface);
  KeptSolver kept;
  for (int step = 0; step < 5; ++step)
  {
    surface = bent(surface);
    mesh = movedTo(*mesh, surface, CoincidentPoints::Merge);
    ASSERT_TRUE(mesh);
    const DistanceField& found =
      kept.get(solverOfNumber(0), mesh).solve(std::vector{ seedAt(*mesh, 77) }, {});
    const auto built = meshOf(surface);
    FastMarchingSolver fresh(built);
    EXPECT_LE(
      difference(*mesh, found, *built, fresh.solve(std::vector{ seedAt(*built, 77) })), 1e-11);
  }
}

TEST(Motion, DistinctPositionsAreTold)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const std::size_t count : { 1, 2, 63, 1000, 40000 })
  {
    std::vector<Vector3> positions;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double x = uniform(random);
      const double y = uniform(random);
      positions.push_back({ x, y, 0.0 });
    }
    EXPECT_TRUE(areDistinct(positions));
    positions.push_back(positions[count / 3]);
    EXPECT_FALSE(areDistinct(positions));
    // 0 and -0 are equal.
    positions.back().z = -0.0;
    EXPECT_FALSE(areDistinct(positions));
    positions.back().z = std::numeric_limits<double>::denorm_min();
    EXPECT_TRUE(areDistinct(positions));
  }
  EXPECT_TRUE(areDistinct({}));
}
