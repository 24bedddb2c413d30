// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact and bounded distances from curves and regions: against the plane, and against dense points.

#include "RandomMeshes.h"
#include "Solving.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "windows/BoundedSolver.h"
#include "windows/ExactSolver.h"

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

/** A way of some edges from vertex to vertex, which does not turn back at once. */
std::vector<Index> randomWay(const TriangleMesh& mesh, Index from, int edges, std::mt19937& random)
{
  std::vector<Index> way{ from };
  while (static_cast<int>(way.size()) <= edges)
  {
    const auto ring = mesh.ring(way.back());
    const Index next = ring[random() % ring.size()].neighbour();
    if (way.size() < 2 || next != way[way.size() - 2] || ring.size() < 3)
    {
      way.push_back(next);
    }
  }
  return way;
}

Seed curveAlong(const TriangleMesh& mesh, const std::vector<Index>& way)
{
  std::vector<SurfacePoint> points;
  for (const Index vertex : way)
  {
    points.push_back(mesh.pointAtVertex(vertex));
  }
  return Seed::alongCurve(points);
}

double distanceToLine(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 side = b - a;
  const double at = std::clamp(dot(p - a, side) / std::max(dot(side, side), 1e-300), 0.0, 1.0);
  return norm(p - (a + at * side));
}

double distanceToLines(const Vector3& p, const std::vector<Vector3>& line)
{
  double least = norm(p - line[0]);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    least = std::min(least, distanceToLine(p, line[i], line[i + 1]));
  }
  return least;
}

/** A flat surface, and the same one folded along the lines x = 3, 6, ..., which changes no distance
 * on it, as the plane is convex. */
struct FoldedPlane
{
  explicit FoldedPlane(Index cells)
    : flat(jitteredGrid(cells, cells, cells, cells, 0.3, 5))
    , folded(flat)
  {
    // Points beside a fold move on it.
    for (Vector3& p : this->flat.points)
    {
      const double fold = 3.0 * std::round(p.x / 3.0);
      p.x = std::abs(p.x - fold) < 0.45 ? fold : p.x;
    }
    for (std::size_t i = 0; i < this->flat.points.size(); ++i)
    {
      const Vector3 p = this->flat.points[i];
      const double strip = std::floor(p.x / 3.0);
      const double rest = p.x - 3.0 * strip;
      const bool isOdd = static_cast<int>(strip) % 2 != 0;
      this->folded.points[i] = { 3.0 * 0.6 * strip + 0.6 * rest, p.y,
        isOdd ? 0.8 * (3.0 - rest) : 0.8 * rest };
    }
  }

  Surface flat;
  Surface folded;
};

}

TEST(SeedWindows, PointsAreExactWhereAllAnglesAreTwoPi)
{
  // Round each point, rounding makes the angle a little more or a little less: a saddle or none.
  const FoldedPlane plane(30);
  const auto turnedAndMoved = [](Vector3 p, double by)
  {
    const Vector3 turned{ 0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z };
    return Vector3{ turned.x, 0.28 * turned.y - 0.96 * turned.z,
      0.96 * turned.y + 0.28 * turned.z } +
      Vector3{ by, by, by };
  };
  for (const double by : { 0.0, 1e6 })
  {
    Surface surface = plane.folded;
    for (Vector3& p : surface.points)
    {
      p = turnedAndMoved(p, by);
    }
    const auto mesh = meshOf(surface);
    for (const Index source : { 0u, 17u, 480u })
    {
      const auto exact = distances<ExactSolver>(mesh, { seedAt(*mesh, source) });
      const auto bounded = distances<BoundedSolver>(mesh, { seedAt(*mesh, source) });
      for (std::size_t i = 0; i < exact.size(); ++i)
      {
        const double truth = norm(plane.flat.points[i] - plane.flat.points[source]);
        ASSERT_NEAR(exact[i], truth, 1e-10 * 42.0) << "from " << source << " to " << i;
        ASSERT_NEAR(bounded[i], truth, 1e-3 * truth + 1e-9) << "from " << source << " to " << i;
      }
    }
  }
}

TEST(SeedWindows, CurvesAlongEdgesAreExactOnAFoldedPlane)
{
  const FoldedPlane plane(24);
  const auto mesh = meshOf(plane.folded);
  std::mt19937 random(3);
  ExactSolver solver(mesh);
  for (int round = 0; round < 20; ++round)
  {
    const auto start = static_cast<Index>(random() % mesh->numberOfVertices());
    const std::vector<Index> way = randomWay(*mesh, start, 1 + round, random);
    std::vector<Vector3> line;
    for (const Index vertex : way)
    {
      line.push_back(plane.flat.points[mesh->pointOfVertex(vertex)]);
    }
    const Seed seed = curveAlong(*mesh, way);
    const DistanceField& field = solver.solve({ &seed, 1 });
    for (Index v = 0; v < mesh->numberOfVertices(); ++v)
    {
      const double truth = distanceToLines(plane.flat.points[mesh->pointOfVertex(v)], line);
      ASSERT_NEAR(field.distance(v), truth, 2e-11) << "round " << round << ", vertex " << v;
      ASSERT_EQ(field.nearestSeed(v), 0u);
    }
  }
}

TEST(SeedWindows, CurvesInsideFacesAreExactOnAFoldedPlane)
{
  const FoldedPlane plane(24);
  const auto mesh = meshOf(plane.folded);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.05, 1.0);
  const auto inside = [&](Index triangle)
  {
    SurfacePoint point{ triangle, { uniform(random), uniform(random), uniform(random) } };
    const double sum = point.weights[0] + point.weights[1] + point.weights[2];
    for (double& weight : point.weights)
    {
      weight /= sum;
    }
    return point;
  };
  const auto flatPlaceOf = [&](const SurfacePoint& point)
  {
    Vector3 place{};
    for (int k = 0; k < 3; ++k)
    {
      place = place +
        point.weights[k] *
          plane.flat.points[mesh->pointOfVertex(mesh->triangle(point.triangle)[k])];
    }
    return place;
  };
  ExactSolver solver(mesh);
  for (int round = 0; round < 20; ++round)
  {
    const auto triangle = static_cast<Index>(random() % mesh->numberOfTriangles());
    // Through the face to one of its edges, along that, and to a corner.
    std::vector<SurfacePoint> points{ inside(triangle), inside(triangle) };
    points.push_back({ triangle, { 0.25, 0.75, 0.0 } });
    points.push_back({ triangle, { 0.5, 0.5, 0.0 } });
    points.push_back({ triangle, { 1.0, 0.0, 0.0 } });
    points.resize(2 + static_cast<std::size_t>(round) % 4);
    std::vector<Vector3> line;
    for (const SurfacePoint& point : points)
    {
      line.push_back(flatPlaceOf(point));
    }
    Seed seed = Seed::alongCurve(points);
    seed.value = round % 3;
    const DistanceField& field = solver.solve({ &seed, 1 });
    for (Index v = 0; v < mesh->numberOfVertices(); ++v)
    {
      const double truth =
        seed.value + distanceToLines(plane.flat.points[mesh->pointOfVertex(v)], line);
      ASSERT_NEAR(field.distance(v), truth, 2e-11) << "round " << round << ", vertex " << v;
    }
  }
}

TEST(SeedWindows, RegionsAreExactOnAFoldedPlane)
{
  const FoldedPlane plane(20);
  const auto mesh = meshOf(plane.folded);
  const auto flat = [&](Index vertex) { return plane.flat.points[mesh->pointOfVertex(vertex)]; };
  std::mt19937 random(5);
  ExactSolver solver(mesh);
  for (int round = 0; round < 10; ++round)
  {
    // Some discs, which may overlap, and single vertices.
    std::vector<Index> vertices;
    for (int disc = 0; disc < 3; ++disc)
    {
      const Vector3 centre = flat(static_cast<Index>(random() % mesh->numberOfVertices()));
      const double radius = 1.2 * static_cast<double>(random() % 4);
      for (Index v = 0; v < mesh->numberOfVertices(); ++v)
      {
        if (norm(flat(v) - centre) <= radius)
        {
          vertices.push_back(v);
        }
      }
    }
    const auto isIn = [&](Index v)
    { return std::find(vertices.begin(), vertices.end(), v) != vertices.end(); };
    const Seed seed = Seed::onRegion(vertices);
    const DistanceField& field = solver.solve({ &seed, 1 });
    for (Index v = 0; v < mesh->numberOfVertices(); ++v)
    {
      double truth = 1e300;
      for (const Index w : vertices)
      {
        truth = std::min(truth, norm(flat(v) - flat(w)));
        for (const RingEntry& entry : mesh->ring(w))
        {
          if (isIn(entry.neighbour()))
          {
            truth = std::min(truth, distanceToLine(flat(v), flat(w), flat(entry.neighbour())));
          }
        }
      }
      ASSERT_NEAR(field.distance(v), truth, 2e-11) << "round " << round << ", vertex " << v;
    }
  }
}

// Points on a curve bound its distance from above, and from below where half their spacing is taken
// off. All kinds of meshes, with barriers.
TEST(SeedWindows, CurvesAgreeWithDensePointsOnRandomMeshes)
{
  double excess = 0.0;
  int counted = 0;
  for (unsigned round = 0; round < 60; ++round)
  {
    const MeshKind kind = meshKinds()[round % meshKinds().size()];
    const auto mesh = meshOf(randomSurface(kind, round));
    std::mt19937 random(round);
    Index start = 0;
    do
    {
      start = static_cast<Index>(random() % mesh->numberOfVertices());
    } while (mesh->ring(start).empty());
    const std::vector<Index> way = randomWay(*mesh, start, 4, random);
    std::vector<std::uint8_t> closed(round % 2 == 0 ? 0 : mesh->numberOfTriangles(), 0);
    for (std::uint8_t& flag : closed)
    {
      flag = random() % 12 == 0;
    }
    // One open triangle at each edge, so that the request is valid.
    for (std::size_t i = 0; i + 1 < way.size() && !closed.empty(); ++i)
    {
      for (const Index t : mesh->trianglesWith(std::array{ way[i], way[i + 1] }))
      {
        closed[t] = 0;
      }
    }
    SolveOptions options;
    options.closedTriangles = closed;
    const Seed curve = curveAlong(*mesh, way);
    constexpr int parts = 64;
    std::vector<Seed> points;
    double spacing = 0.0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
    {
      const Index t = mesh->trianglesWith(std::array{ way[i], way[i + 1] })[0];
      spacing =
        std::max(spacing, norm(mesh->position(way[i]) - mesh->position(way[i + 1])) / parts);
      for (int part = 0; part <= parts; ++part)
      {
        SurfacePoint point{ t, { 0.0, 0.0, 0.0 } };
        for (int k = 0; k < 3; ++k)
        {
          const double at = static_cast<double>(part) / parts;
          point.weights[k] = mesh->triangle(t)[k] == way[i] ? 1.0 - at
            : mesh->triangle(t)[k] == way[i + 1]            ? at
                                                            : 0.0;
        }
        points.push_back(Seed::atPoint(point));
      }
    }
    const auto exact = distances<ExactSolver>(mesh, { curve }, options);
    const auto dense = distances<ExactSolver>(mesh, points, options);
    const auto bounded = distances<BoundedSolver>(mesh, { curve }, options);
    double largest = 0.0;
    for (const double d : exact)
    {
      largest = std::isfinite(d) ? std::max(largest, d) : largest;
    }
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      ASSERT_EQ(std::isfinite(exact[i]), std::isfinite(dense[i])) << nameOf(kind) << " " << round;
      if (!std::isfinite(exact[i]))
      {
        continue;
      }
      const double rounding = 1e-11 * (largest + spacing);
      ASSERT_LE(exact[i], dense[i] + rounding) << nameOf(kind) << " " << round << " point " << i;
      ASSERT_GE(exact[i], dense[i] - 0.5 * spacing - rounding)
        << nameOf(kind) << " " << round << " point " << i;
      ASSERT_GE(bounded[i], exact[i] - rounding) << nameOf(kind) << " " << round;
      ASSERT_LE(bounded[i], exact[i] * 1.001 + rounding) << nameOf(kind) << " " << round;
      excess += (dense[i] - exact[i]) / spacing;
      ++counted;
    }
  }
  // Where a point is not hit, the detour grows with the square of the spacing.
  EXPECT_LE(excess / counted, 0.02);
}
