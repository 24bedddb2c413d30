// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles split along curves, and cut open along them.

#include "split/SplitMesh.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "split/BaseMeshPath.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

double area(const TriangleMesh& mesh, Index t)
{
  const Triangle& c = mesh.triangle(t);
  return 0.5 *
    norm(
      cross(mesh.position(c[1]) - mesh.position(c[0]), mesh.position(c[2]) - mesh.position(c[0])));
}

double area(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    sum += area(mesh, t);
  }
  return sum;
}

std::size_t borderEdges(const TriangleMesh& mesh)
{
  std::map<std::pair<Index, Index>, int> count;
  for (const Triangle& t : mesh.triangles())
  {
    for (int c = 0; c < 3; ++c)
    {
      ++count[std::minmax(t[c], t[(c + 1) % 3])];
    }
  }
  std::size_t border = 0;
  for (const auto& [edge, triangles] : count)
  {
    border += triangles == 1 ? 1 : 0;
  }
  return border;
}

SurfacePath curveThrough(
  const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Vector3>& positions)
{
  std::vector<SurfacePoint> points;
  for (const Vector3& position : positions)
  {
    points.push_back(pointNear(mesh, position));
  }
  FastMarchingSolver solver(mesh);
  return joinedCurve(solver, points, "Test curve");
}

/** A closed regular polygon round (0.5, 0.5) in the unit square. */
std::vector<Vector3> loop(double radius, int corners, double turn = 0.1)
{
  std::vector<Vector3> positions;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = turn + 2.0 * std::numbers::pi * (i % corners) / corners;
    positions.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0 });
  }
  return positions;
}

}

// Curves that cross each other and themselves, on a real surface.
TEST(SplitMesh, KeepsTheSurface)
{
  const auto base = meshOf(spot());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<SurfacePath> curves;
  for (int i = 0; i < 5; ++i)
  {
    std::vector<Vector3> positions;
    for (int j = 0; j < 6; ++j)
    {
      positions.push_back({ coordinate(random), coordinate(random), coordinate(random) });
    }
    curves.push_back(curveThrough(base, positions));
  }
  const SplitMesh split(base, curves, {});
  EXPECT_GT(split.mesh()->numberOfVertices(), base->numberOfVertices() + 50);
  EXPECT_NEAR(area(*split.mesh()), area(*base), 1e-12 * area(*base));
  EXPECT_EQ(borderEdges(*split.mesh()), borderEdges(*base));
  for (Index t = 0; t < split.mesh()->numberOfTriangles(); ++t)
  {
    EXPECT_LE(area(*split.mesh(), t), area(*base, split.baseTriangleOf(t)) * (1.0 + 1e-12));
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const std::vector<SurfacePoint> points = split.curve(i);
    double length = 0.0;
    for (std::size_t j = 1; j < points.size(); ++j)
    {
      const Index ends[] = { PathPoint::at(*split.mesh(), points[j - 1]).carriers()[0],
        PathPoint::at(*split.mesh(), points[j]).carriers()[0] };
      EXPECT_FALSE(split.mesh()->trianglesWith(ends).empty()) << "curve " << i << " point " << j;
      length += norm(split.mesh()->position(ends[0]) - split.mesh()->position(ends[1]));
    }
    EXPECT_NEAR(length, lengthOf(*base, curves[i]), 1e-7 * length);
  }
}

// Of two points on an edge that are both near enough to a third one, the nearer one is taken.
TEST(SplitMesh, APointOnAnEdgeBecomesTheNearestOne)
{
  const auto base = meshOf(planeGrid(1, 1, 1.0, 1.0));
  // The diagonal is the edge between the corners that two triangles have in common.
  const Index a = base->vertexOfPoint(0);
  const Index b = base->vertexOfPoint(3);
  const Index off = base->vertexOfPoint(1);
  ASSERT_EQ(base->trianglesWith(std::array{ a, b }).size(), 2u);
  const auto at = [&](double fraction) { return PathPoint::onEdge(a, b, fraction); };
  constexpr double tolerance = 1e-9;
  const double low = 0.25;
  const double high = low + 1.5 * tolerance;
  for (const auto& [place, nearer] :
    { std::pair{ low + 0.6 * tolerance, low }, std::pair{ low + 0.9 * tolerance, high } })
  {
    const std::vector<SurfacePath> curves{ { PathPoint::atVertex(off), at(low) },
      { PathPoint::atVertex(off), at(high) }, { PathPoint::atVertex(off), at(place) } };
    const SplitMesh split(base, curves, {});
    const auto endOf = [&](std::size_t curve)
    { return PathPoint::at(*split.mesh(), split.curve(curve).back()).carriers()[0]; };
    ASSERT_NE(endOf(0), endOf(1));
    EXPECT_EQ(endOf(2), endOf(nearer == low ? 0 : 1));
  }
}

// What stands for a vertex of the base mesh on a cut is excluded, new points on cuts are for paths
// along edges only.
TEST(SplitMesh, ExcludesVerticesOnCuts)
{
  const auto base = meshOf(planeGrid(4, 4, 1.0, 1.0));
  // From the vertex at (0.25, 0.5) along an edge to (0.5, 0.5), and on into the square beside it.
  const Index first = base->vertexOfPoint(11);
  const Index second = base->vertexOfPoint(12);
  const Index third = base->vertexOfPoint(13);
  const Index beside = base->vertexOfPoint(18);
  const SurfacePath cut{ PathPoint::atVertex(first), PathPoint::atVertex(second),
    PathPoint::onEdge(third, beside, 0.5) };
  const std::vector<SurfacePath> cuts{ cut };
  std::vector<std::uint8_t> baseExcluded(base->numberOfVertices(), 0);
  baseExcluded[beside] = 1;
  const SplitMesh split(base, {}, cuts);
  const auto excluded = split.excluded(baseExcluded);
  const auto forEdges = split.excludedForEdges(baseExcluded);
  for (Index v = 0; v < split.mesh()->numberOfVertices(); ++v)
  {
    const PathPoint& origin = split.origin(v);
    const bool isOld = isVertex(origin);
    const Index carrier = origin.carriers()[0];
    const bool isOnCut = !isOld || carrier == first || carrier == second;
    // The cut is one-sided at its ends; inside, one side keeps the vertex and the other is new.
    const bool isKept = isOld && split.vertexOf(carrier) == v;
    EXPECT_EQ(excluded[v] != 0, isKept && (isOnCut || carrier == beside)) << v;
    EXPECT_EQ(forEdges[v] != 0, isOnCut || carrier == beside) << v;
  }
}

TEST(SplitMesh, FindsPointsAgain)
{
  const auto base = meshOf(spot());
  const std::vector<SurfacePath> curves{ curveThrough(base, { { -1, 0, 0 }, { 1, 0, 0 } }) };
  const SplitMesh split(base, curves, {});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  for (Index t = 0; t < base->numberOfTriangles(); ++t)
  {
    SurfacePoint point{ t, { weight(random), weight(random), weight(random) } };
    point = snapped({ t,
      { point.weights[0] / 3.0, point.weights[1] / 3.0,
        1.0 - (point.weights[0] + point.weights[1]) / 3.0 } });
    const SurfacePoint there = split.pointOf(point);
    const PathPoint onBase = basePoint(
      PathPoint::at(*split.mesh(), there), [&](Index vertex) { return split.origin(vertex); });
    const Vector3 back = onBase.position(*base);
    EXPECT_LT(norm(split.mesh()->positionOf(there) - base->positionOf(point)), 1e-9);
    EXPECT_LT(norm(back - base->positionOf(point)), 1e-9);
  }
}

// A coarse square of 8 x 8 cells, and loops of every size, also inside one cell.
TEST(SplitMesh, ALoopConfinesTheFront)
{
  const auto base = meshOf(planeGrid(8, 8, 1.0, 1.0));
  for (double radius : { 0.02, 0.05, 0.11, 0.13, 0.2, 0.31, 0.45 })
  {
    for (int corners : { 3, 4, 5, 7, 24 })
    {
      const auto positions = loop(radius, corners);
      const std::vector<SurfacePath> cuts{ curveThrough(base, positions) };
      const SplitMesh split(base, {}, cuts);
      const auto excluded = split.excluded({});
      SolveOptions options;
      options.excluded = excluded;
      FastMarchingSolver solver(split.mesh());
      const auto isInside = [&](const Vector3& p)
      {
        for (std::size_t i = 1; i < positions.size(); ++i)
        {
          const Vector3 side = positions[i] - positions[i - 1];
          if (cross(side, p - positions[i - 1]).z <= 0.0)
          {
            return false;
          }
        }
        return true;
      };
      const Seed centre = Seed::atPoint(split.pointOf(pointNear(base, { 0.5001, 0.5002, 0.0 })));
      const DistanceField& field = solver.solve({ &centre, 1 }, options);
      for (Index v = 0; v < base->numberOfVertices(); ++v)
      {
        EXPECT_EQ(field.isReached(split.vertexOf(v)), isInside(base->position(v)))
          << "radius " << radius << ", " << corners << " corners, at " << base->position(v).x
          << ", " << base->position(v).y;
        if (field.isReached(split.vertexOf(v)))
        {
          EXPECT_NEAR(field.distance(split.vertexOf(v)),
            norm(base->position(v) - Vector3{ 0.5001, 0.5002, 0.0 }), 1e-9);
        }
      }
      const Seed corner = Seed::atPoint(split.pointOf(pointNear(base, { 0.01, 0.02, 0.0 })));
      const DistanceField& outside = solver.solve({ &corner, 1 }, options);
      for (Index v = 0; v < base->numberOfVertices(); ++v)
      {
        EXPECT_EQ(outside.isReached(split.vertexOf(v)), !isInside(base->position(v)))
          << "outside, radius " << radius << ", " << corners << " corners";
      }
    }
  }
}

// A wall across the square but for a gap at one end: the way round its end is two straight lines.
TEST(SplitMesh, TheFrontGoesRoundTheEndOfAWall)
{
  for (Index cells : { 20u, 80u })
  {
    const auto base = meshOf(jitteredGrid(cells, cells, 1.0, 1.0, 0.3, 4));
    const Vector3 end{ 0.613, 0.507, 0.0 };
    const std::vector<SurfacePath> cuts{ curveThrough(base, { { 0.0, 0.507, 0.0 }, end }) };
    const SplitMesh split(base, {}, cuts);
    const auto excluded = split.excluded({});
    SolveOptions options;
    options.excluded = excluded;
    FastMarchingSolver solver(split.mesh());
    const Vector3 source{ 0.2, 0.2, 0.0 };
    const Seed seed = Seed::atPoint(split.pointOf(pointNear(base, source)));
    const DistanceField& field = solver.solve({ &seed, 1 }, options);
    double worst = 0.0;
    for (Index v = 0; v < base->numberOfVertices(); ++v)
    {
      const Vector3 p = base->position(v);
      const bool isHidden = p.y > 0.507 && cross(end - source, p - source).z > 0.0;
      const double exact = isHidden ? norm(end - source) + norm(p - end) : norm(p - source);
      const double error = field.distance(split.vertexOf(v)) - exact;
      EXPECT_GT(error, -1e-9);
      worst = std::max(worst, error);
    }
    EXPECT_LT(worst, 1.0 / cells) << cells << " cells";
  }
}

TEST(SplitMesh, ASeedOnAWallIsKnown)
{
  const auto base = meshOf(planeGrid(8, 8, 1.0, 1.0));
  const std::vector<SurfacePath> cuts{ curveThrough(
    base, { { 0.1, 0.52, 0.0 }, { 0.9, 0.57, 0.0 } }) };
  const SplitMesh split(base, {}, cuts);
  EXPECT_TRUE(split.isOnCut(split.pointOf(pointNear(base, { 0.5, 0.545, 0.0 }))));
  EXPECT_TRUE(split.isOnCut(split.pointOf(pointNear(base, { 0.1, 0.52, 0.0 }))));
  EXPECT_FALSE(split.isOnCut(split.pointOf(pointNear(base, { 0.5, 0.546, 0.0 }))));
  EXPECT_FALSE(split.isOnCut(split.pointOf(pointNear(base, { 0.05, 0.51, 0.0 }))));
}

// Along a straight seed curve that crosses faces at any angle the field is the distance to it.
// First order where the front of the line ends and the one round its end begins, exact beyond.
TEST(SplitMesh, ACurveSeedCrossesFaces)
{
  for (Index cells : { 50u, 100u, 200u })
  {
    const auto base = meshOf(jitteredGrid(cells, cells, 1.0, 1.0, 0.3, 9));
    const Vector3 a{ 0.213, 0.307, 0.0 };
    const Vector3 b{ 0.771, 0.642, 0.0 };
    const std::vector<SurfacePath> curves{ curveThrough(base, { a, b }) };
    const SplitMesh split(base, curves, {});
    const Seed seed = Seed::alongCurve(split.curve(0));
    FastMarchingSolver solver(split.mesh());
    const DistanceField& field = solver.solve({ &seed, 1 });
    double sum = 0.0;
    for (Index v = 0; v < base->numberOfVertices(); ++v)
    {
      const Vector3 p = base->position(v);
      const double along = dot(p - a, b - a) / dot(b - a, b - a);
      const double exact = norm(p - (a + std::clamp(along, 0.0, 1.0) * (b - a)));
      const double error = field.distance(split.vertexOf(v)) - exact;
      EXPECT_GT(error, -1e-9);
      EXPECT_LT(error, (along < 0.0 || along > 1.0 ? 0.1 : 0.5) / cells);
      sum += error;
    }
    EXPECT_LT(sum / base->numberOfVertices(), 0.025 / cells);
  }
}
