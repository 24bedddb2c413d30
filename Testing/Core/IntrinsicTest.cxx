// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Intrinsic triangles, and fast marching over them.

#include "OnIntrinsic.h"
#include "RandomMeshes.h"
#include "RoundedTube.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/IntrinsicMarchingSolver.h"
#include "mesh/IntrinsicTriangles.h"
#include "mesh/ThinTriangles.h"
#include "mesh/TriangleShape.h"
#include "solve/DijkstraSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <string>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

double areaOf(const IntrinsicTriangles& intrinsic)
{
  double area = 0.0;
  for (const Triangle& t : intrinsic.triangles())
  {
    area += 0.25 *
      fourAreas(
        intrinsic.length(t[0], t[1]), intrinsic.length(t[1], t[2]), intrinsic.length(t[2], t[0]));
  }
  return area;
}

/** Of triangles with the same corners one counts. */
double areaOf(const TriangleMesh& mesh)
{
  double area = 0.0;
  std::set<Triangle> known;
  for (const Triangle& t : mesh.triangles())
  {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    area += (known.insert(sorted).second ? 0.5 : 0.0) *
      norm(cross(
        mesh.position(t[1]) - mesh.position(t[0]), mesh.position(t[2]) - mesh.position(t[0])));
  }
  return area;
}

/** The largest number of triangles whose height is less than a tenth of their longest side, in
 * parts of all. */
double partOfThin(const IntrinsicTriangles& intrinsic)
{
  std::size_t thin = 0;
  for (const Triangle& t : intrinsic.triangles())
  {
    const double a = intrinsic.length(t[0], t[1]);
    const double b = intrinsic.length(t[1], t[2]);
    const double c = intrinsic.length(t[2], t[0]);
    const double longest = std::max({ a, b, c });
    thin += fourAreas(a, b, c) < 2.0 * 0.1 * longest * longest ? 1 : 0;
  }
  return static_cast<double>(thin) / static_cast<double>(intrinsic.triangles().size());
}

/** How many vertices a march takes from its queue. */
std::size_t updatesOn(
  const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Seed>& seeds)
{
  std::size_t updates = 0;
  SolveOptions options = intrinsicOptions();
  options.onProgress = [&](std::size_t count)
  {
    updates = count;
    return true;
  };
  IntrinsicMarchingSolver solver(mesh);
  solver.solve(seeds, options);
  return updates;
}

/** The same from point 0. */
std::size_t updatesOn(const std::shared_ptr<const TriangleMesh>& mesh)
{
  return updatesOn(mesh, { seedAt(*mesh, 0) });
}

double largestTooSmall(const std::vector<double>& found, const std::vector<double>& exact)
{
  double most = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    most = exact[i] > 0.0 ? std::max(most, 1.0 - found[i] / exact[i]) : most;
  }
  return most;
}

TEST(Intrinsic, TrianglesAreOfTheSameSurfaceAndNotThin)
{
  for (const Surface& surface : { stretchedPlane(2000, 8.0), flattenedSphere(4, 100.0) })
  {
    const auto mesh = meshOf(surface);
    const IntrinsicTriangles intrinsic(*mesh, {});
    EXPECT_NEAR(areaOf(intrinsic) / areaOf(*mesh), 1.0, 1e-9);
    EXPECT_TRUE(countThinTriangles(*mesh).needOthers());
    // Caps stay.
    EXPECT_LT(partOfThin(intrinsic), 0.015);
  }
}

// Where needles are everywhere, new vertices would be far too many; and round the middle of a fan.
TEST(Intrinsic, HasNoNewVerticesWhereTheyWouldBeTooMany)
{
  for (const Surface& surface : { planeGrid(1, 3000, 1000.0, 1.0), disc(3000) })
  {
    const auto mesh = meshOf(surface);
    const IntrinsicTriangles intrinsic(*mesh, {});
    EXPECT_EQ(intrinsic.numberOfVertices(), mesh->numberOfVertices());
    EXPECT_NEAR(areaOf(intrinsic) / areaOf(*mesh), 1.0, 1e-9);
    EXPECT_LT(updatesOn(mesh), 4u * mesh->numberOfVertices());
  }
}

TEST(Intrinsic, OrdinaryTrianglesStay)
{
  for (const Surface& surface : { planeGrid(20, 20, 1.0, 1.0), icosphere(4) })
  {
    const auto mesh = meshOf(surface);
    const IntrinsicTriangles intrinsic(*mesh, {});
    EXPECT_EQ(intrinsic.numberOfSteps(), 0u);
    EXPECT_TRUE(intrinsic.removedEdges().empty());
    EXPECT_LT(largestDifference(intrinsicDistances(mesh, { seedAt(*mesh, 7) }),
                distances<FastMarchingSolver>(mesh, { seedAt(*mesh, 7) })),
      1e-12);
  }
}

// In a plane the intrinsic triangles lie in it, so a point has one position by both.
TEST(Intrinsic, PointsStayWhereTheyAre)
{
  const Surface surface = stretchedPlane(500, 50.0);
  const auto mesh = meshOf(surface);
  const IntrinsicTriangles intrinsic(*mesh, {});
  // The mesh's vertices are known, the new ones are found by their lengths to them.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  std::size_t looked = 0;
  for (Index t = 0; t < mesh->numberOfTriangles(); ++t)
  {
    SurfacePoint point{ t, { weight(random), weight(random), weight(random) } };
    const double sum = std::accumulate(point.weights.begin(), point.weights.end(), 0.0);
    for (double& w : point.weights)
    {
      w /= sum;
    }
    const SurfacePoint there = intrinsic.pointOf(point);
    const Triangle& corners = intrinsic.triangles()[there.triangle];
    EXPECT_NEAR(std::accumulate(there.weights.begin(), there.weights.end(), 0.0), 1.0, 1e-12);
    if (std::max({ corners[0], corners[1], corners[2] }) < mesh->numberOfVertices())
    {
      Vector3 position;
      for (std::size_t k = 0; k < 3; ++k)
      {
        position = position + there.weights[k] * mesh->position(corners[k]);
      }
      EXPECT_LT(norm(position - mesh->positionOf(point)), 1e-9);
      ++looked;
    }
  }
  EXPECT_GT(looked, 100u);
}

TEST(Intrinsic, DistancesInAPlaneAreStraightLines)
{
  const Surface surface = stretchedPlane(3000, 40.0);
  const auto mesh = meshOf(surface);
  const Vector3 source{ 13.7, 0.4321, 0.0 };
  const Seed seed = seedNear(mesh, source);
  const std::vector<double> truth = straightLines(surface, source);
  const std::vector<double> found = intrinsicDistances(mesh, { seed });
  EXPECT_LT(largestDifference(found, truth), 1e-8 * largestOf(truth));
}

TEST(Intrinsic, IsNearTheTruthOnNeedles)
{
  Surface surface = spot();
  for (Vector3& point : surface.points)
  {
    point.x /= 100.0;
  }
  const auto mesh = meshOf(surface);
  double worst = 0.0;
  double worstOnFaces = 0.0;
  for (const Index source : { 5u, 1000u, 2000u })
  {
    const std::vector<double> exact = exactDistances(surface, { source });
    const std::vector<double> found = intrinsicDistances(mesh, { seedAt(*mesh, source) });
    const std::vector<double> onFaces =
      distances<FastMarchingSolver>(mesh, { seedAt(*mesh, source) });
    worst = std::max(worst, largestTooSmall(found, exact));
    worstOnFaces = std::max(worstOnFaces, largestTooSmall(onFaces, exact));
    EXPECT_LT(relativeError(found, exact).mean, 0.006);
  }
  EXPECT_LT(worst, 0.06);
  EXPECT_GT(worstOnFaces, 0.08);
}

// Behind the fillets fronts come from two sides. Where they met within a long side of a flat part,
// all distances beyond were 5 % too small.
TEST(Intrinsic, LongSidesAreHalved)
{
  Surface surface = boxWithFillets(8);
  for (Vector3& point : surface.points)
  {
    point.y /= 10.0;
  }
  const auto mesh = meshOf(surface);
  const IntrinsicTriangles intrinsic(*mesh, {});
  for (const Triangle& corners : intrinsic.triangles())
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_LE(intrinsic.length(corners[i], corners[(i + 1) % 3]), 1.31 * mesh->meanLongestEdge());
    }
  }
  double worst = 0.0;
  for (const Index source : { 5u, 700u, 1033u, 1358u })
  {
    const std::vector<double> exact = exactDistances(surface, { source });
    const std::vector<double> found = intrinsicDistances(mesh, { seedAt(*mesh, source) });
    worst = std::max(worst, largestTooSmall(found, exact));
    EXPECT_LT(relativeError(found, exact).mean, 0.003);
  }
  EXPECT_LT(worst, 0.025);
}

// Where vertices crowd in one place, the space between the others is not filled as densely; where
// that would take too many all the same, none is added.
TEST(Intrinsic, NewVerticesAreSomeTimesAsManyAtMost)
{
  constexpr Index points = 3000;
  for (const double grading : { 1.0, 1.5, 2.0, 4.0, 8.0 })
  {
    const auto mesh = meshOf(delaunayPlane(points, 1, grading));
    const Index vertices = IntrinsicTriangles(*mesh, {}).numberOfVertices();
    EXPECT_EQ(vertices > points, grading < 4.0) << grading;
    EXPECT_LT(vertices, 2u * points) << grading;
  }
}

TEST(Intrinsic, TakesFewUpdatesWhereTrianglesAreOfAllSizes)
{
  for (const RoundedTube& tube : { RoundedTube(4, 20, 30.0, 1), RoundedTube(16, 20, 100.0, 1) })
  {
    const auto mesh = meshOf(tube.surface());
    const Index vertices = IntrinsicTriangles(*mesh, {}).numberOfVertices();
    EXPECT_LT(updatesOn(mesh), 3u * vertices);
    EXPECT_LT(vertices, 3u * mesh->numberOfVertices());
  }
}

// No distance is more than along an edge of the mesh, though the front does not follow these.
// It took 87 updates a vertex on the smaller mesh as long as caps were halved: each half is
// thinner, and so on. On the larger one fronts march in groups of vertices with near numbers, which
// new ones are not part of, as they have the last numbers wherever they are.
TEST(Intrinsic, TakesFewUpdatesFromManySeeds)
{
  for (const Index points : { 40000u, 60000u })
  {
    const auto mesh = meshOf(stretchedPlane(points, 30.0));
    std::mt19937 random(1);
    std::uniform_int_distribution<Index> anyVertex(0, mesh->numberOfVertices() - 1);
    std::vector<Seed> seeds(500);
    std::generate(seeds.begin(), seeds.end(), [&] { return seedAt(*mesh, anyVertex(random)); });
    EXPECT_LT(updatesOn(mesh, seeds), 5u * mesh->numberOfVertices());
  }
}

TEST(Intrinsic, DistancesAreNotMoreThanAlongEdges)
{
  for (const Surface& surface : { stretchedPlane(2000, 30.0), flattenedSphere(4, 30.0) })
  {
    const auto mesh = meshOf(surface);
    const std::vector<double> found = intrinsicDistances(mesh, { seedAt(*mesh, 7) });
    for (const Triangle& t : surface.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index a = t[k];
        const Index b = t[(k + 1) % 3];
        const double length = norm(surface.points[a] - surface.points[b]);
        ASSERT_LE(std::abs(found[a] - found[b]), length * (1.0 + 1e-9));
      }
    }
    const std::vector<double> alongEdges = distances<DijkstraSolver>(mesh, { seedAt(*mesh, 7) });
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_LE(found[i], alongEdges[i] * (1.0 + 1e-9));
    }
  }
}

// The order of an input's points and triangles decides nothing.
TEST(Intrinsic, IsTheSameOnShuffledSurfaces)
{
  const Surface surface = flattenedSphere(4, 20.0);
  const auto mesh = meshOf(surface);
  const std::vector<double> expected =
    intrinsicDistances(mesh, { seedAt(*mesh, 3), seedAt(*mesh, 400) });
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    std::vector<Index> newId;
    const auto other = meshOf(shuffled(surface, seed, newId));
    const std::vector<double> found =
      intrinsicDistances(other, { seedAt(*other, newId[3]), seedAt(*other, newId[400]) });
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_NEAR(found[newId[i]], expected[i], 1e-9 * largestOf(expected));
    }
  }
}

// Anything may come: sheets that meet, doubled triangles, points without area.
TEST(Intrinsic, SurvivesAnyMesh)
{
  for (const MeshKind kind : meshKinds())
  {
    for (const unsigned number : { 1u, 2u, 3u, 4u })
    {
      SCOPED_TRACE(nameOf(kind) + " " + std::to_string(number));
      Surface surface = randomSurface(kind, number);
      for (Vector3& point : surface.points)
      {
        point.y /= number == 1 ? 1.0 : 50.0;
      }
      const auto mesh = meshOf(surface);
      const IntrinsicTriangles intrinsic(*mesh, {});
      EXPECT_NEAR(areaOf(intrinsic) / areaOf(*mesh), 1.0, 1e-6);
      const std::vector seeds{ Seed::atPoint(mesh->pointAtVertex(mesh->numberOfVertices() / 2)),
        Seed::atPoint(snapped({ mesh->numberOfTriangles() / 3, { 0.5, 0.3, 0.2 } })) };
      for (const Seed& seed : seeds)
      {
        const std::vector<double> found = intrinsicDistances(mesh, { seed });
        const std::vector<double> exact = distances<ExactSolver>(mesh, { seed });
        for (std::size_t i = 0; i < found.size(); ++i)
        {
          ASSERT_EQ(std::isfinite(found[i]), std::isfinite(exact[i])) << i;
          if (std::isfinite(exact[i]))
          {
            ASSERT_LT(std::abs(found[i] - exact[i]), 0.2 * largestOf(exact)) << i;
          }
        }
      }
    }
  }
}

}
