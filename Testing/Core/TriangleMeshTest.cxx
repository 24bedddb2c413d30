// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What the mesh keeps of its input.

#include "RandomMeshes.h"
#include "Solving.h"
#include "march/LabelMargin.h"
#include "march/TriangleSlack.h"
#include "march/UpdateBounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

std::multiset<Triangle> asSet(const std::vector<Triangle>& triangles)
{
  std::multiset<Triangle> set;
  for (Triangle t : triangles)
  {
    std::sort(t.begin(), t.end());
    set.insert(t);
  }
  return set;
}

/** The triangles that the rings hold, each found once from each of its corners. */
std::vector<Triangle> trianglesOfRings(const TriangleMesh& mesh)
{
  std::vector<Triangle> found;
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const auto ring = mesh.ring(v);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (ring[i].opensTriangle())
      {
        found.push_back({ mesh.pointOfVertex(v), mesh.pointOfVertex(ring[i].neighbour()),
          mesh.pointOfVertex(ring[i + 1].neighbour()) });
      }
    }
  }
  return found;
}

void expectRingsHold(const Surface& surface)
{
  const auto mesh = meshOf(surface);
  std::vector<Triangle> thrice;
  for (int i = 0; i < 3; ++i)
  {
    thrice.insert(thrice.end(), surface.triangles.begin(), surface.triangles.end());
  }
  EXPECT_EQ(asSet(trianglesOfRings(*mesh)), asSet(thrice));
}

}

TEST(TriangleMesh, RingsHoldEveryTriangle)
{
  expectRingsHold(planeGrid(5, 7, 1.0, 1.0));
  expectRingsHold(icosphere(2));
  expectRingsHold(cone(200, 3, 1.0, 2.0));
}

TEST(TriangleMesh, RingsHoldTrianglesOfAnyOrientationAndMultiplicity)
{
  // Five sheets on one edge, one of them twice, another reversed.
  expectRingsHold(
    { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
      { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 }, { 0, 1, 5 }, { 0, 1, 2 }, { 2, 1, 0 } } });
}

TEST(TriangleMesh, AManifoldVertexHasOneFan)
{
  const auto mesh = meshOf(icosphere(2));
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    const auto ring = mesh->ring(v);
    EXPECT_EQ(ring.front().neighbour(), ring.back().neighbour());
    EXPECT_EQ(
      std::count_if(ring.begin(), ring.end(), [](RingEntry e) { return e.opensTriangle(); }),
      static_cast<long>(ring.size()) - 1);
  }
}

TEST(TriangleMesh, PointsOutsideOfTrianglesAreNoVertices)
{
  Surface surface = planeGrid(2, 2, 1.0, 1.0);
  surface.points.insert(surface.points.begin(), { { 9.0, 9.0, 9.0 } });
  for (Triangle& t : surface.triangles)
  {
    t = { t[0] + 1, t[1] + 1, t[2] + 1 };
  }
  const auto mesh = meshOf(surface);
  EXPECT_EQ(mesh->numberOfPoints(), 10u);
  EXPECT_EQ(mesh->numberOfVertices(), 9u);
  EXPECT_EQ(mesh->vertexOfPoint(0), NoIndex);
}

TEST(TriangleMesh, VerticesKeepTheirNumbersWithoutSomeTriangles)
{
  const Surface surface = icosphere(3);
  const TriangleMesh whole(
    surface.points, surface.triangles, CoincidentPoints::Merge, ThreadTeam(), &updateMeasurer());
  // All triangles of one vertex, and some others.
  const Index bare = 5;
  std::vector<bool> leftOut;
  std::vector<Triangle> kept;
  for (Index t = 0; t < whole.numberOfTriangles(); ++t)
  {
    const Triangle& corners = whole.triangle(t);
    leftOut.push_back(
      t % 7 == 0 || std::find(corners.begin(), corners.end(), bare) != corners.end());
    if (!leftOut.back())
    {
      kept.push_back(surface.triangles[whole.sourceOfTriangle(t)]);
    }
  }
  const TriangleMesh part = whole.without(leftOut);
  ASSERT_EQ(part.numberOfVertices(), whole.numberOfVertices());
  ASSERT_EQ(part.numberOfTriangles(), kept.size());
  for (Index t = 0; t < part.numberOfTriangles(); ++t)
  {
    EXPECT_EQ(surface.triangles[part.sourceOfTriangle(t)], kept[t]);
  }
  for (Index v = 0; v < whole.numberOfVertices(); ++v)
  {
    EXPECT_EQ(part.pointOfVertex(v), whole.pointOfVertex(v));
    EXPECT_EQ(part.vertexOfPoint(whole.pointOfVertex(v)), v);
  }
  EXPECT_TRUE(part.ring(bare).empty());
  EXPECT_EQ(part.longestEdgeAround(bare), 0.0);
  // Rings and what is measured with them are those of a mesh of these triangles.
  const TriangleMesh anew(
    surface.points, kept, CoincidentPoints::Merge, ThreadTeam(), &updateMeasurer());
  const UpdateBounds bounds(part);
  const UpdateBounds boundsAnew(anew);
  for (Index v = 0; v < anew.numberOfVertices(); ++v)
  {
    const Index same = part.vertexOfPoint(anew.pointOfVertex(v));
    EXPECT_EQ(part.ring(same).size(), anew.ring(v).size());
    EXPECT_EQ(part.longestEdgeAround(same), anew.longestEdgeAround(v));
    EXPECT_EQ(bounds.margins()[same], boundsAnew.margins()[v]);
  }
}

TEST(TriangleMesh, PointsOfOneKindAreOneVertex)
{
  // The last column of one grid is the first of the other, but for rounding.
  const Surface left = planeGrid(1, 1, 1.0, 1.0);
  Surface both = joined(left, left);
  for (Index point = 4; point < 8; ++point)
  {
    both.points[point].x += 1.0 + 1e-7;
  }
  std::vector<Index> kinds{ 0, 1, 2, 3, 1, 5, 3, 7 };
  const TriangleMesh mesh(both.points, both.triangles, kinds);
  EXPECT_EQ(mesh.numberOfVertices(), 6u);
  EXPECT_EQ(mesh.numberOfTriangles(), 4u);
  EXPECT_EQ(mesh.vertexOfPoint(1), mesh.vertexOfPoint(4));
  EXPECT_EQ(mesh.vertexOfPoint(3), mesh.vertexOfPoint(6));
  EXPECT_EQ(mesh.pointOfVertex(mesh.vertexOfPoint(4)), 1u);
  EXPECT_EQ(mesh.position(mesh.vertexOfPoint(4)), both.points[1]);
  // Equal coordinates do not make one vertex of different kinds.
  const Surface twice = joined(left, left);
  kinds = { 0, 1, 2, 3, 4, 5, 6, 7 };
  EXPECT_EQ(TriangleMesh(twice.points, twice.triangles, kinds).numberOfVertices(), 8u);
  // The lowest point that a triangle uses stands for its kind.
  both.points.insert(both.points.begin(), Vector3{ 9.0, 9.0, 9.0 });
  for (Triangle& t : both.triangles)
  {
    t = { t[0] + 1, t[1] + 1, t[2] + 1 };
  }
  kinds = { 2, 0, 2, 1, 3, 2, 4, 3, 5 };
  const TriangleMesh withBare(both.points, both.triangles, kinds);
  EXPECT_EQ(withBare.numberOfVertices(), 6u);
  EXPECT_EQ(withBare.vertexOfPoint(0), NoIndex);
  EXPECT_EQ(withBare.pointOfVertex(withBare.vertexOfPoint(5)), 2u);
  // All that triangles use are to be finite, not only those.
  both.points[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TriangleMesh(both.points, both.triangles, kinds), std::invalid_argument);
}

TEST(TriangleMesh, CoincidentPointsMergeOnRequest)
{
  const Surface twice = joined(planeGrid(3, 3, 1.0, 1.0), planeGrid(3, 3, -1.0, 1.0));
  EXPECT_EQ(meshOf(twice, CoincidentPoints::Separate)->numberOfVertices(), 32u);
  const auto merged = meshOf(twice, CoincidentPoints::Merge);
  EXPECT_EQ(merged->numberOfVertices(), 28u);
  EXPECT_EQ(merged->vertexOfPoint(0), merged->vertexOfPoint(16));
  EXPECT_EQ(merged->pointOfVertex(merged->vertexOfPoint(16)), 0u);
}

// Far from the origin the leading bits of the curve are all alike: equal points must still meet.
TEST(TriangleMesh, CoincidentPointsMergeBesideAnOutlier)
{
  Surface surface = joined(planeGrid(40, 40, 1.0, 1.0), planeGrid(40, 40, -1.0, 1.0));
  surface.points.push_back({ 1e9, 0.0, 0.0 });
  surface.triangles.push_back({ 0, 1, static_cast<Index>(surface.points.size() - 1) });
  const auto merged = meshOf(surface, CoincidentPoints::Merge);
  EXPECT_EQ(merged->numberOfVertices(), 2u * 41u * 41u - 41u + 1u);
}

// Triangles of the same corners are found all, by three, two or one of these.
TEST(TriangleMesh, FindsTrianglesThatLieOnEachOther)
{
  const auto mesh = meshOf({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { 0, 1, 2 }, { 2, 1, 0 }, { 1, 3, 2 } } });
  const auto sourcesAt = [&](std::vector<Index> points)
  {
    for (Index& point : points)
    {
      point = mesh->vertexOfPoint(point);
    }
    std::vector<Index> sources;
    for (const Index t : mesh->trianglesWith(points))
    {
      sources.push_back(mesh->sourceOfTriangle(t));
    }
    std::sort(sources.begin(), sources.end());
    return sources;
  };
  const std::vector<Index> twins{ 0, 1 };
  EXPECT_EQ(sourcesAt({ 0, 1, 2 }), twins);
  EXPECT_EQ(sourcesAt({ 0, 1 }), twins);
  EXPECT_EQ(sourcesAt({ 0 }), twins);
  EXPECT_EQ(sourcesAt({ 1, 2 }), (std::vector<Index>{ 0, 1, 2 }));
}

// Also where triangles lie on each other, and round vertices that are the lowest of very many.
TEST(TriangleMesh, FindsTheFirstTriangleOfSomeCorners)
{
  std::vector<Surface> surfaces{ disc(100), pages(50), joined(disc(40), disc(40)) };
  for (const MeshKind kind :
    { MeshKind::Closed, MeshKind::Grid, MeshKind::Needles, MeshKind::NonManifold })
  {
    surfaces.push_back(randomSurface(kind, 3));
  }
  for (Surface& surface : surfaces)
  {
    const std::vector<Triangle> again = surface.triangles;
    surface.triangles.insert(surface.triangles.end(), again.begin(), again.end());
    const auto mesh = meshOf(surface);
    std::mt19937 random(1);
    std::uniform_int_distribution<Index> any(0, mesh->numberOfVertices() - 1);
    const auto expectFirst = [&](std::span<const Index> corners)
    {
      const std::vector<Index> all = mesh->trianglesWith(corners);
      EXPECT_EQ(mesh->firstTriangleWith(corners), all.empty() ? NoIndex : all.front());
      EXPECT_EQ(mesh->hasTriangleWith(corners), !all.empty());
    };
    for (const Triangle& triangle : mesh->triangles())
    {
      for (std::size_t count = 1; count <= triangle.size(); ++count)
      {
        expectFirst(std::span(triangle).first(count));
      }
      const Triangle other{ triangle[0], triangle[1], any(random) };
      if (other[2] != other[0] && other[2] != other[1])
      {
        expectFirst(std::span(other).last(2));
        expectFirst(other);
      }
    }
  }
}

TEST(TriangleMesh, PointAtVertexIsThere)
{
  const auto mesh = meshOf(icosphere(3));
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    EXPECT_EQ(mesh->positionOf(mesh->pointAtVertex(v)), mesh->position(v));
  }
}

TEST(TriangleMesh, EdgeLengthsAreMeasured)
{
  const auto mesh = meshOf({ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } });
  EXPECT_FLOAT_EQ(mesh->meanLongestEdge(), 5.0);
  EXPECT_FLOAT_EQ(mesh->longestEdgeLength(), 5.0);
  EXPECT_GE(mesh->longestEdgeLength(), 5.0);
  EXPECT_GE(mesh->longestEdgeAround(mesh->vertexOfPoint(0)), 5.0);
  EXPECT_NEAR(UpdateBounds(*mesh).meanMargin(), labelMargin(5.0, 2.4), 1e-5);
}

TEST(TriangleMesh, MarginTellsOfTheHeight)
{
  EXPECT_DOUBLE_EQ(heightOfMargin(5.0, labelMargin(5.0, 2.6)), 2.6);
  EXPECT_DOUBLE_EQ(heightOfMargin(5.0, labelMargin(5.0, 0.1)), 2.5);
  EXPECT_EQ(heightOfMargin(0.0, 0.0), 0.0);
}

namespace
{

void expectSameBounds(const UpdateBounds& some, const UpdateBounds& other, std::size_t entries)
{
  EXPECT_EQ(some.meanMargin(), other.meanMargin());
  ASSERT_TRUE(std::ranges::equal(some.margins(), other.margins()));
  // As bits: the slack of an entry that opens no triangle is infinite.
  ASSERT_EQ(std::memcmp(some.slacks(), other.slacks(), entries * sizeof(EntryNumber)), 0);
}

/** On any number of threads the same: 2, 3 and 9, which is more than count triangles. */
void expectThreadsChangeNothing(const Surface& surface, CoincidentPoints coincident)
{
  const TriangleMesh one(
    surface.points, surface.triangles, coincident, ThreadTeam(1), &updateMeasurer());
  const TriangleMesh plain(surface.points, surface.triangles, coincident, ThreadTeam(1));
  const UpdateBounds ofOne(one, ThreadTeam(1));
  for (unsigned threads : { 2u, 3u, 9u })
  {
    ASSERT_EQ(ThreadTeam(threads).numberOfRanges(one.numberOfVertices()), threads);
    const TriangleMesh other(
      surface.points, surface.triangles, coincident, ThreadTeam(threads), &updateMeasurer());
    ASSERT_EQ(other.numberOfVertices(), one.numberOfVertices());
    ASSERT_EQ(other.numberOfTriangles(), one.numberOfTriangles());
    EXPECT_EQ(other.meanLongestEdge(), one.meanLongestEdge());
    EXPECT_EQ(other.longestEdgeLength(), one.longestEdgeLength());
    for (Index i = 0; i < one.numberOfPoints(); ++i)
    {
      ASSERT_EQ(other.vertexOfPoint(i), one.vertexOfPoint(i));
    }
    for (Index t = 0; t < one.numberOfTriangles(); ++t)
    {
      ASSERT_EQ(other.triangle(t), one.triangle(t));
      ASSERT_EQ(other.sourceOfTriangle(t), one.sourceOfTriangle(t));
    }
    for (Index v = 0; v < one.numberOfVertices(); ++v)
    {
      ASSERT_EQ(other.position(v), one.position(v));
      ASSERT_EQ(other.pointOfVertex(v), one.pointOfVertex(v));
      ASSERT_EQ(other.longestEdgeAround(v), one.longestEdgeAround(v));
      ASSERT_TRUE(std::ranges::equal(other.ring(v), one.ring(v)));
    }
    expectSameBounds(UpdateBounds(other), ofOne, one.rings().numberOfEntries());
    const UpdateBounds ofPlain(plain, ThreadTeam(threads));
    expectSameBounds(ofPlain, UpdateBounds(plain, ThreadTeam(1)), one.rings().numberOfEntries());
  }
}

}

// What is found side by side must not depend on where the work was cut.
TEST(TriangleMesh, ThreadsChangeNothing)
{
  std::vector<Index> newId;
  // Points in no order, some of them twice, a part on top of another and a bare triangle.
  Surface surface =
    shuffled(joined(icosphere(5), joined(icosphere(5), torus(80, 60, 2.0, 0.5))), 1, newId);
  surface.triangles.push_back({ 0, 0, 1 });
  for (CoincidentPoints coincident : { CoincidentPoints::Separate, CoincidentPoints::Merge })
  {
    expectThreadsChangeNothing(surface, coincident);
  }
}

// Rings of one fan, of several, of more than 255 triangles and of none that closes.
TEST(TriangleMesh, NumbersMadeAlongWithRingsAreThoseOfAPass)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const std::span<const MeshKind> kinds = meshKinds();
    const Surface surface = randomSurface(kinds[seed % kinds.size()], seed);
    const TriangleMesh along(surface.points, surface.triangles, CoincidentPoints::Merge,
      ThreadTeam(1 + seed % 3), &updateMeasurer());
    const TriangleMesh plain(surface.points, surface.triangles, CoincidentPoints::Merge);
    const UpdateBounds some(along);
    const UpdateBounds other(plain);
    ASSERT_EQ(along.rings().numberOfEntries(), plain.rings().numberOfEntries());
    ASSERT_NEAR(some.meanMargin(), other.meanMargin(), 1e-6 * other.meanMargin());
    for (Index v = 0; v < plain.numberOfVertices(); ++v)
    {
      ASSERT_NEAR(some.margins()[v], other.margins()[v], 1e-5 * other.margins()[v]);
    }
    for (std::size_t i = 0; i < plain.rings().numberOfEntries() + VertexRings::Overrun; ++i)
    {
      const float slack = TriangleSlack::from(other.slacks()[i]).value();
      const float slackAlong = TriangleSlack::from(some.slacks()[i]).value();
      if (std::isinf(slack))
      {
        ASSERT_TRUE(std::isinf(slackAlong));
        continue;
      }
      // From another corner, a height is rounded in another way; so a slack may come to lie a step
      // or two of its 8 significant bits away.
      ASSERT_NEAR(slackAlong, slack, std::abs(slack) / 64.0 + 1e-6 * plain.longestEdgeLength());
    }
  }
}

// All triangles have their lowest corner in the first thread's part, and others anywhere.
TEST(TriangleMesh, ThreadsChangeNothingRoundOnePoint)
{
  Surface fan;
  fan.points.push_back({ 0.0, 0.0, 0.0 });
  constexpr Index rim = 12000;
  for (Index i = 1; i <= rim; ++i)
  {
    const double angle = 1.5 * i / rim;
    fan.points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    if (i > 1)
    {
      fan.triangles.push_back({ 0, i - 1, i });
    }
  }
  expectThreadsChangeNothing(fan, CoincidentPoints::Separate);
}

// Of several mistakes the first is named, whichever thread finds one.
TEST(TriangleMesh, TheFirstMistakeIsNamedOnAnyNumberOfThreads)
{
  Surface sphere = icosphere(5);
  sphere.triangles[20000] = { 0, 1, 900001 };
  sphere.triangles[15000] = { 0, 1, 900000 };
  sphere.triangles[100] = { 0, 1, 900002 };
  for (unsigned threads : { 1u, 2u, 3u })
  {
    try
    {
      TriangleMesh(
        sphere.points, sphere.triangles, CoincidentPoints::Separate, ThreadTeam(threads));
      FAIL() << "a point that does not exist was accepted";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(
        std::string(error.what()).find("Triangle 100 uses point 900002"), std::string::npos);
    }
  }
}
