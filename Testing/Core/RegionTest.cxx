// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The regions that lines divide a surface into.

#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "search/ClosestPointTree.h"
#include "split/RegionCut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using Positions = std::vector<Vector3>;

/** A surface on which lines through positions in space are cut. */
class Subject
{
public:
  explicit Subject(const Surface& surface)
    : Mesh(meshOf(surface))
    , Regions(std::make_shared<const RegionMesh>(Mesh))
    , Tree(Mesh)
    , Solver(Mesh)
  {
  }

  const TriangleMesh& mesh() const { return *this->Mesh; }
  SurfacePoint at(const Vector3& position) const { return this->Tree.closestPoint(position).point; }
  SurfacePath line(const Positions& positions)
  {
    std::vector<SurfacePoint> points;
    for (const Vector3& position : positions)
    {
      points.push_back(this->at(position));
    }
    return joinedCurve(this->Solver, points, "Test line");
  }
  RegionCut cut(const std::vector<Positions>& lines)
  {
    std::vector<SurfacePath> paths;
    for (const Positions& positions : lines)
    {
      paths.push_back(this->line(positions));
    }
    return RegionCut(this->Regions, paths);
  }
  const std::shared_ptr<const RegionMesh>& regionMesh() const { return this->Regions; }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  std::shared_ptr<const RegionMesh> Regions;
  ClosestPointTree Tree;
  FastMarchingSolver Solver;
};

/** A closed regular polygon in the plane z = 0. */
Positions polygon(double x, double y, double radius, int corners, double turn = 0.1)
{
  Positions positions;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = turn + 2.0 * std::numbers::pi * (i % corners) / corners;
    positions.push_back({ x + radius * std::cos(angle), y + radius * std::sin(angle), 0.0 });
  }
  return positions;
}

double polygonArea(double radius, int corners)
{
  return 0.5 * corners * radius * radius * std::sin(2.0 * std::numbers::pi / corners);
}

double polygonLength(double radius, int corners)
{
  return 2.0 * corners * radius * std::sin(std::numbers::pi / corners);
}

/** The triangles after the cut, with points as corners, and the region of each. */
struct Result
{
  std::vector<Triangle> triangles;
  std::vector<Index> regions;
};

Result resultOf(const TriangleMesh& mesh, const RegionCut& cut)
{
  Result result;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    if (cut.regionOf(t) != NoIndex)
    {
      result.triangles.push_back(mesh.triangle(t));
      result.regions.push_back(cut.regionOf(t));
    }
  }
  for (const RegionCut::Piece& piece : cut.pieces())
  {
    result.triangles.push_back(piece.corners);
    result.regions.push_back(piece.region);
  }
  return result;
}

using Edge = std::pair<Index, Index>;

std::map<Edge, int> edgesOf(std::span<const Triangle> triangles)
{
  std::map<Edge, int> count;
  for (const Triangle& t : triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      ++count[std::minmax(t[c], t[(c + 1) % 3])];
    }
  }
  return count;
}

/** How many edges have one triangle, two, or more; and the Euler characteristic. */
struct Topology
{
  std::size_t border = 0;
  std::size_t manifold = 0;
  std::size_t more = 0;
  std::ptrdiff_t euler = 0;
};

Topology topologyOf(std::span<const Triangle> triangles)
{
  Topology topology;
  std::set<Index> points;
  const auto edges = edgesOf(triangles);
  for (const auto& [edge, count] : edges)
  {
    topology.border += count == 1;
    topology.manifold += count == 2;
    topology.more += count > 2;
    points.insert({ edge.first, edge.second });
  }
  topology.euler = static_cast<std::ptrdiff_t>(points.size() + triangles.size()) -
    static_cast<std::ptrdiff_t>(edges.size());
  return topology;
}

double total(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/** What holds for each cut of a surface without repeated triangles, whatever the lines are. */
void expectSound(const TriangleMesh& mesh, const RegionCut& cut, std::size_t lines)
{
  const Result result = resultOf(mesh, cut);
  double area = 0.0;
  for (const Triangle& t : mesh.triangles())
  {
    area += 0.5 *
      norm(cross(
        mesh.position(t[1]) - mesh.position(t[0]), mesh.position(t[2]) - mesh.position(t[0])));
  }
  EXPECT_NEAR(total(cut.areas()), area, 1e-12 * area);
  for (const Triangle& t : result.triangles)
  {
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  }
  const Topology before = topologyOf(mesh.triangles());
  const Topology after = topologyOf(result.triangles);
  EXPECT_EQ(after.euler, before.euler);
  EXPECT_EQ(before.border == 0, after.border == 0);
  EXPECT_EQ(before.more == 0, after.more == 0);
  // Every edge between two regions lies on a line.
  std::set<Edge> onLines;
  for (std::size_t line = 0; line < lines; ++line)
  {
    const std::vector<Index> points = cut.pointsOf(line);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      onLines.insert(std::minmax(points[i - 1], points[i]));
    }
  }
  std::map<Edge, Index> regionAt;
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Edge edge = std::minmax(result.triangles[t][c], result.triangles[t][(c + 1) % 3]);
      const auto known = regionAt.emplace(edge, result.regions[t]).first;
      EXPECT_TRUE(known->second == result.regions[t] || onLines.contains(edge));
    }
  }
  for (const Edge& edge : onLines)
  {
    EXPECT_TRUE(regionAt.contains(edge)) << "a line leaves the edges";
  }
}

}

// Areas by the formula of the regular polygon; lengths likewise.
TEST(Region, OfNestedLoopsOnAPlaneHaveTheAreasOfTheFormula)
{
  Subject plane(jitteredGrid(40, 40, 1.0, 1.0, 0.3, 1));
  const RegionCut cut =
    plane.cut({ polygon(0.5, 0.5, 0.4, 7), polygon(0.5, 0.5, 0.2, 5), polygon(0.45, 0.5, 0.1, 3) });
  const double outer = polygonArea(0.4, 7);
  const double middle = polygonArea(0.2, 5);
  const double inner = polygonArea(0.1, 3);
  const std::vector<double> expected{ 1.0 - outer, outer - middle, middle - inner, inner };
  std::vector<double> sorted = expected;
  std::ranges::sort(sorted, std::greater<>{});
  ASSERT_EQ(cut.areas().size(), 4u);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(cut.areas()[i], sorted[i], 1e-12);
  }
  const Index outside = cut.regionsAt(plane.at({ 0.01, 0.01, 0.0 })).front();
  EXPECT_NEAR(cut.perimeters()[outside], 4.0 + polygonLength(0.4, 7), 1e-11);
  EXPECT_NEAR(cut.perimeters()[cut.regionsAt(plane.at({ 0.45, 0.5, 0.0 })).front()],
    polygonLength(0.1, 3), 1e-11);
  expectSound(plane.mesh(), cut, 3);
  for (std::size_t line = 0; line < 3; ++line)
  {
    EXPECT_TRUE(cut.separates(line));
  }
}

// A square loop round a box whose sides are unit squares: the line z = 0.3 cuts off 4 * 0.3 + 1.
TEST(Region, OfALoopRoundAPrismHasTheAreaOfTheFormula)
{
  const Positions corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const std::vector<Triangle> faces{ { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 },
    { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 },
    { 3, 4, 7 } };
  Subject box({ corners, faces });
  RegionCut cut =
    box.cut({ { { 0, 0, 0.3 }, { 1, 0, 0.3 }, { 1, 1, 0.3 }, { 0, 1, 0.3 }, { 0, 0, 0.3 } } });
  ASSERT_EQ(cut.areas().size(), 2u);
  EXPECT_NEAR(cut.areas()[0], 1.0 + 4 * 0.7, 1e-14);
  EXPECT_NEAR(cut.areas()[1], 1.0 + 4 * 0.3, 1e-14);
  EXPECT_NEAR(cut.perimeters()[0], 4.0, 1e-14);
  EXPECT_NEAR(cut.perimeters()[1], 4.0, 1e-14);
  cut.putFirst(cut.regionsAt(box.at({ 0.5, 0.5, 0.0 })).front());
  EXPECT_NEAR(cut.areas()[0], 1.0 + 4 * 0.3, 1e-14);
  EXPECT_EQ(cut.regionsAt(box.at({ 0.5, 0.5, 0.0 })), std::vector<Index>{ 0 });
  EXPECT_EQ(cut.regionsAt(box.at({ 0.5, 0.0, 0.9 })), std::vector<Index>{ 1 });
  EXPECT_EQ(cut.regionsAt(box.at({ 0.5, 0.0, 0.3 })), (std::vector<Index>{ 0, 1 }));
  expectSound(box.mesh(), cut, 1);
}

// Cap of the unit sphere over the circle at height h: 2 pi (1 - h). The mesh's own area is off by
// O(edge^2), and so is the cap's.
TEST(Region, CapOfASphereConverges)
{
  const double height = 0.6;
  std::vector<double> errors;
  for (int levels : { 3, 4, 5 })
  {
    Subject sphere(icosphere(levels));
    Positions circle;
    const int corners = 400;
    for (int i = 0; i <= corners; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * (i % corners) / corners;
      circle.push_back({ 0.8 * std::cos(angle), 0.8 * std::sin(angle), height });
    }
    RegionCut cut = sphere.cut({ circle });
    cut.putFirst(cut.regionsAt(sphere.at({ 0, 0, 1 })).front());
    errors.push_back(std::abs(cut.areas()[0] / (2.0 * std::numbers::pi * (1.0 - height)) - 1.0));
  }
  EXPECT_LT(errors[0], 0.02);
  EXPECT_LT(errors[1], 0.6 * errors[0]);
  EXPECT_LT(errors[2], 0.6 * errors[1]);
}

// All points of the loop lie in the two faces of a square.
TEST(Region, OfALoopOfManyPointsInOneFace)
{
  Subject plane(planeGrid(1, 1, 1.0, 1.0));
  const int corners = 5000;
  const RegionCut cut = plane.cut({ polygon(0.5, 0.5, 0.3, corners) });
  ASSERT_EQ(cut.areas().size(), 2u);
  EXPECT_NEAR(cut.areas()[1], polygonArea(0.3, corners), 1e-12);
  EXPECT_NEAR(cut.perimeters()[1], polygonLength(0.3, corners), 1e-10);
  expectSound(plane.mesh(), cut, 1);
}

TEST(Region, WithoutLinesEachComponentIsOne)
{
  Subject two(joined(icosphere(2), planeGrid(3, 3, 10.0, 10.0)));
  const RegionCut cut = two.cut({});
  ASSERT_EQ(cut.areas().size(), 2u);
  EXPECT_NEAR(cut.areas()[0], 100.0, 1e-12);
  EXPECT_NEAR(cut.perimeters()[0], 40.0, 1e-12);
  EXPECT_EQ(cut.perimeters()[1], 0.0);
  EXPECT_TRUE(cut.pieces().empty());
}

// Lines along edges need no new point; through vertices they split faces beside those only.
TEST(Region, AlongEdgesAndThroughVertices)
{
  Subject plane(planeGrid(10, 10, 1.0, 1.0));
  const RegionCut along = plane.cut(
    { { { 0.2, 0.2, 0 }, { 0.8, 0.2, 0 }, { 0.8, 0.8, 0 }, { 0.2, 0.8, 0 }, { 0.2, 0.2, 0 } } });
  EXPECT_TRUE(along.pieces().empty());
  ASSERT_EQ(along.areas().size(), 2u);
  EXPECT_NEAR(along.areas()[1], 0.36, 1e-14);
  EXPECT_NEAR(along.perimeters()[1], 2.4, 1e-14);
  const RegionCut across = plane.cut({ { { 0.0, 0.0, 0 }, { 0.5, 1.0, 0 } } });
  ASSERT_EQ(across.areas().size(), 2u);
  EXPECT_NEAR(across.areas()[1], 0.25, 1e-12);
  const RegionCut diagonal = plane.cut({ { { 0.0, 1.0, 0 }, { 1.0, 0.0, 0 } } });
  ASSERT_EQ(diagonal.areas().size(), 2u);
  EXPECT_NEAR(diagonal.areas()[0], 0.5, 1e-12);
  EXPECT_NEAR(diagonal.areas()[1], 0.5, 1e-12);
  for (const RegionCut* cut : { &along, &across, &diagonal })
  {
    expectSound(plane.mesh(), *cut, 1);
  }
}

TEST(Region, CrossingTouchingDoubledAndOpenLines)
{
  Subject plane(jitteredGrid(15, 15, 1.0, 1.0, 0.25, 2));
  // A cross of two lines from border to border, one of them twice.
  const Positions upright{ { 0.31, 0.0, 0 }, { 0.31, 1.0, 0 } };
  const Positions level{ { 0.0, 0.47, 0 }, { 1.0, 0.47, 0 } };
  const RegionCut cross = plane.cut({ upright, level, upright });
  ASSERT_EQ(cross.areas().size(), 4u);
  EXPECT_NEAR(cross.areas()[0], 0.69 * 0.53, 1e-12);
  EXPECT_NEAR(cross.areas()[3], 0.31 * 0.47, 1e-12);
  expectSound(plane.mesh(), cross, 3);
  // Two squares that touch along a part of a side, and a loop that touches one of them in a point.
  const RegionCut touching = plane.cut(
    { { { 0.1, 0.1, 0 }, { 0.4, 0.1, 0 }, { 0.4, 0.4, 0 }, { 0.1, 0.4, 0 }, { 0.1, 0.1, 0 } },
      { { 0.4, 0.2, 0 }, { 0.7, 0.2, 0 }, { 0.7, 0.5, 0 }, { 0.4, 0.5, 0 }, { 0.4, 0.2, 0 } },
      { { 0.55, 0.5, 0 }, { 0.65, 0.8, 0 }, { 0.45, 0.8, 0 }, { 0.55, 0.5, 0 } } });
  ASSERT_EQ(touching.areas().size(), 4u);
  EXPECT_NEAR(touching.areas()[1], 0.09, 1e-12);
  EXPECT_NEAR(touching.areas()[2], 0.09, 1e-12);
  EXPECT_NEAR(touching.areas()[3], 0.03, 1e-12);
  expectSound(plane.mesh(), touching, 3);
  // A slit separates nothing, but is cut.
  const RegionCut slit = plane.cut({ { { 0.3, 0.3, 0 }, { 0.7, 0.6, 0 } } });
  EXPECT_EQ(slit.areas().size(), 1u);
  EXPECT_FALSE(slit.separates(0));
  EXPECT_FALSE(slit.pieces().empty());
  EXPECT_NEAR(slit.perimeters()[0], 4.0, 1e-12);
  expectSound(plane.mesh(), slit, 1);
}

TEST(Region, ALoopRoundAHandleSeparatesNothing)
{
  Subject ring(torus(60, 30, 2.0, 0.7));
  const auto meridian = [](double angle)
  {
    Positions loop;
    for (int i = 0; i <= 24; ++i)
    {
      const double across = 2.0 * std::numbers::pi * (i % 24) / 24;
      const double radius = 2.0 + 0.7 * std::cos(across);
      loop.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), 0.7 * std::sin(across) });
    }
    return loop;
  };
  const RegionCut one = ring.cut({ meridian(0.3) });
  EXPECT_EQ(one.areas().size(), 1u);
  EXPECT_FALSE(one.separates(0));
  const RegionCut two = ring.cut({ meridian(0.3), meridian(1.9) });
  EXPECT_EQ(two.areas().size(), 2u);
  EXPECT_TRUE(two.separates(0));
  EXPECT_TRUE(two.separates(1));
  expectSound(ring.mesh(), two, 2);
}

namespace
{

/** Loops of random size at random places. */
std::vector<Positions> randomLoops(const TriangleMesh& mesh, int count, std::mt19937& random)
{
  std::uniform_int_distribution<Index> vertex(0, mesh.numberOfVertices() - 1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::uniform_int_distribution<int> corners(2, 6);
  std::vector<Positions> loops;
  for (int i = 0; i < count; ++i)
  {
    const Vector3 centre = mesh.position(vertex(random));
    const double size = mesh.meanLongestEdge() * std::exp(3.0 * unit(random));
    Positions loop;
    for (int c = corners(random); c > 0; --c)
    {
      loop.push_back(centre + size * Vector3{ unit(random), unit(random), unit(random) });
    }
    loop.push_back(loop.front());
    loops.push_back(std::move(loop));
  }
  return loops;
}

Surface box(Index cells)
{
  Surface surface = planeGrid(cells, cells, 1.0, 1.0);
  const Surface side = surface;
  const auto add = [&](auto place)
  {
    Surface next = side;
    for (Vector3& p : next.points)
    {
      p = place(p.x, p.y);
    }
    surface = joined(surface, next);
  };
  add([](double x, double y) { return Vector3{ x, y, 1.0 }; });
  add([](double x, double y) { return Vector3{ x, 0.0, y }; });
  add([](double x, double y) { return Vector3{ x, 1.0, y }; });
  add([](double x, double y) { return Vector3{ 0.0, x, y }; });
  add([](double x, double y) { return Vector3{ 1.0, x, y }; });
  // Points of equal coordinates are one.
  std::map<std::array<double, 3>, Index> numbers;
  Surface welded;
  std::vector<Index> numberOf;
  for (const Vector3& p : surface.points)
  {
    const auto [place, isNew] =
      numbers.emplace(std::array{ p.x, p.y, p.z }, static_cast<Index>(welded.points.size()));
    if (isNew)
    {
      welded.points.push_back(p);
    }
    numberOf.push_back(place->second);
  }
  for (const Triangle& t : surface.triangles)
  {
    welded.triangles.push_back({ numberOf[t[0]], numberOf[t[1]], numberOf[t[2]] });
  }
  return welded;
}

}

TEST(Region, OfAThousandRandomLoopsAreSound)
{
  std::mt19937 random(7);
  const std::vector<Surface> surfaces{ bunny(), spot(), torus(40, 20, 2.0, 0.7), box(1), box(7) };
  for (const Surface& surface : surfaces)
  {
    Subject subject(surface);
    const bool isLarge = subject.mesh().numberOfTriangles() > 20000;
    const int runs = isLarge ? 5 : 50;
    const int perRun = 200 / runs;
    for (int run = 0; run < runs && !::testing::Test::HasFailure(); ++run)
    {
      const auto loops = randomLoops(subject.mesh(), perRun, random);
      SCOPED_TRACE(std::to_string(surface.points.size()) + " points, run " + std::to_string(run));
      expectSound(subject.mesh(), subject.cut(loops), loops.size());
    }
  }
}

// Edges of many triangles, needles, doubled triangles: the parts have the area of the whole.
TEST(Region, OfSurfacesOfAllKindsAddUp)
{
  for (const MeshKind kind : meshKinds())
  {
    for (unsigned seed = 0; seed < 20 && !::testing::Test::HasFailure(); ++seed)
    {
      SCOPED_TRACE(nameOf(kind) + " " + std::to_string(seed));
      Subject subject(randomSurface(kind, seed));
      std::mt19937 random(seed);
      std::vector<SurfacePath> lines;
      for (const Positions& loop : randomLoops(subject.mesh(), 4, random))
      {
        try
        {
          lines.push_back(subject.line(loop));
        }
        catch (const std::invalid_argument&)
        {
          // Its points are on parts that are not connected.
        }
      }
      const RegionCut cut(subject.regionMesh(), lines);
      double area = 0.0;
      for (Index t = 0; t < subject.mesh().numberOfTriangles(); ++t)
      {
        area += subject.regionMesh()->areaOf(t);
      }
      EXPECT_NEAR(total(cut.areas()), area, 1e-9 * area);
      std::set<Index> split;
      for (const RegionCut::Piece& piece : cut.pieces())
      {
        split.insert(piece.triangle);
      }
      for (Index t = 0; t < subject.mesh().numberOfTriangles(); ++t)
      {
        EXPECT_EQ(cut.regionOf(t) == NoIndex, split.contains(t));
      }
    }
  }
}
