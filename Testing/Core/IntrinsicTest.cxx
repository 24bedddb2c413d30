// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Intrinsic triangles, and fast marching over them.

#include "ExactDistances.h"
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

/** A square of random points, stretched along x. */
Surface stretchedPlane(Index points, double factor)
{
  Surface surface = delaunayPlane(points, 1);
  for (Vector3& point : surface.points)
  {
    point.x *= factor;
  }
  return surface;
}

Surface flattenedSphere(int levels, double factor)
{
  Surface surface = icosphere(levels);
  for (Vector3& point : surface.points)
  {
    point.z /= factor;
  }
  return surface;
}

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

SolveOptions intrinsicOptions(SolveOptions options = {})
{
  options.isIntrinsic = true;
  return options;
}

std::vector<double> intrinsicDistances(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options = {})
{
  return distances<IntrinsicMarchingSolver>(mesh, seeds, intrinsicOptions(options));
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

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const bool isSame = a[i] == b[i];
    largest = std::max(largest, isSame ? 0.0 : std::abs(a[i] - b[i]));
  }
  return largest;
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

// As pieces on several ranks have copies of each other's triangles.
TEST(Intrinsic, TrianglesThatLieOnOthersCountOnce)
{
  for (const bool hasBarriers : { false, true })
  {
    const Surface surface = stretchedPlane(1000, 30.0);
    Surface doubled = surface;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3)
    {
      const auto& [a, b, c] = surface.triangles[t];
      doubled.triangles.push_back({ b, c, a });
    }
    std::vector<double> found[2];
    for (const bool isDoubled : { false, true })
    {
      const auto mesh = meshOf(isDoubled ? doubled : surface);
      std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
      for (Index t = 0; hasBarriers && t < closed.size(); ++t)
      {
        const std::size_t source = mesh->sourceOfTriangle(t);
        const std::size_t count = surface.triangles.size();
        // One of two is enough, whichever it is.
        const bool isCopy = source >= count;
        const std::size_t original = isCopy ? 3 * (source - count) : source;
        const bool isOfBoth = isDoubled && original % 3 == 0;
        const bool isClosed = original % 21 == 0;
        closed[t] = isClosed && (!isOfBoth || isCopy == (original % 2 == 0)) ? 1 : 0;
      }
      SolveOptions options;
      options.closedTriangles = closed;
      found[isDoubled ? 1 : 0] = intrinsicDistances(mesh, { seedAt(*mesh, 0) }, options);
    }
    EXPECT_LT(largestDifference(found[0], found[1]), 1e-9 * largestOf(found[0]));
  }
}

TEST(Intrinsic, KeepsWithinBarriers)
{
  // A wall of closed triangles, and one of excluded vertices, each with a gap at one end.
  const Surface surface = stretchedPlane(3000, 20.0);
  const auto mesh = meshOf(surface);
  std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
  for (Index t = 0; t < closed.size(); ++t)
  {
    const Vector3 middle = mesh->positionOf({ t, { 0.4, 0.3, 0.3 } });
    closed[t] = std::abs(middle.x - 8.0) < 0.6 && middle.y > 0.2 ? 1 : 0;
  }
  std::vector<std::uint8_t> excluded(mesh->numberOfVertices());
  for (Index v = 0; v < excluded.size(); ++v)
  {
    const Vector3& position = mesh->position(v);
    excluded[v] = std::abs(position.x - 14.0) < 0.6 && position.y < 0.8 ? 1 : 0;
  }
  SolveOptions options;
  options.closedTriangles = closed;
  options.excluded = excluded;
  const Seed seed = seedNear(mesh, { 1.0, 0.5, 0.0 });
  const std::vector<double> exact = distances<ExactSolver>(mesh, { seed }, options);
  const std::vector<double> found = intrinsicDistances(mesh, { seed }, options);
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(found[i]), std::isfinite(exact[i]));
    if (std::isfinite(exact[i]))
    {
      ASSERT_NEAR(found[i], exact[i], 0.02 * exact[i] + 1e-9);
    }
  }
  // Other barriers, and then the first ones again, with one solver.
  IntrinsicMarchingSolver solver(mesh);
  const std::vector seeds{ seed };
  solver.solve(seeds, intrinsicOptions(options));
  const double withoutBarriers =
    solver.solve(seeds, intrinsicOptions()).distance(mesh->vertexOfPoint(2));
  EXPECT_NEAR(withoutBarriers, norm(surface.points[2] - Vector3{ 1.0, 0.5, 0.0 }), 1e-6);
  // On the faces, and then again with what that run had.
  solver.solve(seeds, options);
  SolveOptions kept = intrinsicOptions(options);
  kept.keepsSurface = true;
  const DistanceField& again = solver.solve(seeds, kept);
  for (Index i = 0; i < mesh->numberOfPoints(); ++i)
  {
    ASSERT_EQ(again.distance(mesh->vertexOfPoint(i)), found[i]);
  }
}

TEST(Intrinsic, NearestSeedsAreThoseOfTheLeastField)
{
  const Surface surface = flattenedSphere(4, 20.0);
  const auto mesh = meshOf(surface);
  std::vector<Seed> seeds;
  std::vector<std::vector<double>> single;
  for (const Index point : { 3u, 700u, 1500u, 2200u })
  {
    seeds.push_back(seedAt(*mesh, point));
    single.push_back(intrinsicDistances(mesh, { seeds.back() }));
  }
  IntrinsicMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(seeds, intrinsicOptions());
  const double tolerance = 1e-4 * field.largestDistance();
  for (Index i = 0; i < mesh->numberOfPoints(); ++i)
  {
    const Index vertex = mesh->vertexOfPoint(i);
    double least = DistanceField::Unreached;
    for (const auto& distances : single)
    {
      least = std::min(least, distances[i]);
    }
    ASSERT_NEAR(field.distance(vertex), least, tolerance);
    ASSERT_NEAR(single[field.nearestSeed(vertex)][i], least, tolerance);
  }
}

TEST(Intrinsic, StopsAsOnFaces)
{
  const Surface surface = flattenedSphere(4, 50.0);
  const auto mesh = meshOf(surface);
  const std::vector<double> whole = intrinsicDistances(mesh, { seedAt(*mesh, 3) });
  SolveOptions options;
  options.maximumDistance = 0.7;
  const std::vector<double> near = intrinsicDistances(mesh, { seedAt(*mesh, 3) }, options);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(near[i]), whole[i] <= 0.7);
    ASSERT_TRUE(whole[i] > 0.7 || std::abs(near[i] - whole[i]) < 1e-9);
  }
  const Index target = mesh->vertexOfPoint(1200);
  const std::vector<Triangle> targets{ { target, target, target } };
  options = intrinsicOptions();
  options.targets = targets;
  IntrinsicMarchingSolver solver(mesh);
  const DistanceField& field = solver.solve(std::vector{ seedAt(*mesh, 3) }, options);
  EXPECT_EQ(field.stopReason(), StopReason::Targets);
  EXPECT_NEAR(field.distance(target), whole[1200], 1e-9);
  EXPECT_LE(field.largestDistance(), whole[1200] * (1.0 + 1e-12));
}

TEST(Intrinsic, EndsWhereverItIsCancelled)
{
  const Surface surface = flattenedSphere(4, 50.0);
  const auto mesh = meshOf(surface);
  const std::vector seeds{ seedAt(*mesh, 3) };
  IntrinsicMarchingSolver whole(mesh);
  std::size_t calls = 0;
  SolveOptions options = intrinsicOptions();
  options.onProgress = [&](std::size_t)
  {
    ++calls;
    return true;
  };
  const double largest = whole.solve(seeds, options).largestDistance();
  for (std::size_t end = 0; end < calls; end += 1 + calls / 40)
  {
    IntrinsicMarchingSolver solver(mesh);
    std::size_t count = 0;
    options.onProgress = [&](std::size_t) { return count++ < end; };
    EXPECT_EQ(solver.solve(seeds, options).stopReason(), StopReason::Cancelled);
    EXPECT_EQ(solver.solve(seeds, intrinsicOptions()).largestDistance(), largest);
  }
}

TEST(Intrinsic, IsTheSameOnThreads)
{
  const Surface surface = flattenedSphere(6, 20.0);
  const auto mesh = meshOf(surface);
  const std::vector<double> one = intrinsicDistances(mesh, { seedAt(*mesh, 3) });
  SolveOptions options;
  options.threads = 3;
  options.verticesOfThread = 1;
  const std::vector<double> three = intrinsicDistances(mesh, { seedAt(*mesh, 3) }, options);
  EXPECT_LT(largestDifference(one, three), 1e-9 * largestOf(one));
}

TEST(Intrinsic, OtherRequestsAreOnFacesOrAnError)
{
  const auto mesh = meshOf(stretchedPlane(300, 30.0));
  const std::vector seeds{ seedAt(*mesh, 3) };
  const std::vector<double> cost(mesh->numberOfVertices(), 2.0);
  SolveOptions options;
  options.cost = cost;
  EXPECT_EQ(distances<IntrinsicMarchingSolver>(mesh, seeds, options),
    distances<FastMarchingSolver>(mesh, seeds, options));
  EXPECT_FALSE(IntrinsicMarchingSolver::canMarchIntrinsically(seeds, options));
  IntrinsicMarchingSolver solver(mesh);
  EXPECT_FALSE(solver.solve(seeds, options).isIntrinsic());
  EXPECT_TRUE(solver.solve(seeds, intrinsicOptions()).isIntrinsic());
  EXPECT_FALSE(solver.solve(seeds).isIntrinsic());
  EXPECT_NE(errorOf([&] { intrinsicDistances(mesh, seeds, options); }), "");
}

TEST(Intrinsic, SeedsOfVerticesAreThere)
{
  for (const unsigned number : { 5u, 7u, 8u, 23u })
  {
    for (const MeshKind kind : { MeshKind::NonManifold, MeshKind::Graded, MeshKind::Careless })
    {
      Surface surface = randomSurface(kind, number);
      for (Vector3& point : surface.points)
      {
        point.x *= 1000.0;
      }
      const auto mesh = meshOf(surface);
      IntrinsicMarchingSolver solver(mesh);
      for (Index vertex = 0; vertex < mesh->numberOfVertices(); vertex += 29)
      {
        const std::vector seeds{ Seed::atPoint(mesh->pointAtVertex(vertex)) };
        ASSERT_EQ(solver.solve(seeds, intrinsicOptions()).distance(vertex), 0.0);
      }
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
