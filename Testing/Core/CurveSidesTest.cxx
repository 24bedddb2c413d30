// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// On which side of curves vertices are.

#include "split/CurveSides.h"
#include "LevelSides.h"
#include "Solving.h"
#include "base/DisjointSets.h"
#include "march/FastMarchingSolver.h"
#include "path/SurfaceCurve.h"
#include "search/ClosestPointTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using Positions = std::vector<Vector3>;

class CurvedSurface
{
public:
  explicit CurvedSurface(const Surface& surface)
    : Mesh(meshOf(surface))
    , Regions(std::make_shared<const RegionMesh>(Mesh))
    , Tree(Mesh)
    , Solver(Mesh)
  {
  }

  const TriangleMesh& mesh() const { return *this->Mesh; }
  const std::shared_ptr<const RegionMesh>& regionMesh() const { return this->Regions; }
  SurfacePath line(const Positions& positions)
  {
    std::vector<SurfacePoint> points;
    for (const Vector3& position : positions)
    {
      points.push_back(this->Tree.closestPoint(position).point);
    }
    return joinedCurve(this->Solver, points, "Test line");
  }
  std::vector<std::int8_t> sides(const std::vector<Positions>& lines, const Walls& walls = {})
  {
    std::vector<SurfacePath> paths;
    for (const Positions& positions : lines)
    {
      paths.push_back(this->line(positions));
    }
    return curveSides(this->Regions, paths, "Lines", walls);
  }
  int sideAt(const std::vector<Positions>& lines, const Vector3& position)
  {
    const SurfacePoint there = this->Tree.closestPoint(position).point;
    return this->sides(lines)[PathPoint::at(*this->Mesh, there).carriers()[0]];
  }
  std::string errorOf(const std::vector<Positions>& lines)
  {
    try
    {
      this->sides(lines);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  }

private:
  std::shared_ptr<const TriangleMesh> Mesh;
  std::shared_ptr<const RegionMesh> Regions;
  ClosestPointTree Tree;
  FastMarchingSolver Solver;
};

Positions circle(double x, double y, double radius, int corners, double turn = 0.1)
{
  Positions positions;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = turn + 2.0 * std::numbers::pi * (i % corners) / corners;
    positions.push_back({ x + radius * std::cos(angle), y + radius * std::sin(angle), 0.0 });
  }
  return positions;
}

/** The closed polygon round a pole of the unit sphere at a height. */
Positions parallel(double height, double turn = 0.1)
{
  Positions positions = circle(0.0, 0.0, std::sqrt(1.0 - height * height), 12, turn);
  for (Vector3& position : positions)
  {
    position.z = height;
  }
  return positions;
}

Positions reversed(Positions positions)
{
  return { positions.rbegin(), positions.rend() };
}

void expectContains(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

}

// The truth is a flood over vertices on which a function has one sign; see LevelSides.h.
TEST(CurveSides, AreThoseOfAFloodInFiveHundredRandomCases)
{
  std::mt19937 random(7);
  const std::vector<Surface> surfaces{ bunny(), spot(), torus(40, 20, 1.0, 0.4),
    jitteredGrid(25, 20, 1.2, 1.0, 0.3, 3), cylinder(30, 15, 0.5, 2.0), icosphere(3) };
  const std::vector<int> shares{ 40, 40, 110, 110, 100, 100 };
  int refused = 0;
  int curves = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const CurvedSurface subject(surfaces[s]);
    for (int told = 0; told < shares[s];)
    {
      const LevelSides truth =
        levelSides(subject.mesh(), randomLevels(subject.mesh(), random), random);
      if (truth.curves.empty())
      {
        continue;
      }
      curves += static_cast<int>(truth.curves.size());
      if (truth.signs)
      {
        ++told;
        // EXPECT_EQ of vectors would print all their entries.
        ASSERT_TRUE(curveSides(subject.regionMesh(), truth.curves, "Lines") == *truth.signs)
          << "surface " << s << ", case " << told << ", " << truth.curves.size() << " curves";
      }
      else
      {
        ++refused;
        EXPECT_THROW(
          curveSides(subject.regionMesh(), truth.curves, "Lines"), std::invalid_argument);
      }
    }
  }
  RecordProperty("refused", refused);
  RecordProperty("curves", curves);
  EXPECT_GT(refused, 10);
  EXPECT_GT(curves, 600);
}

TEST(CurveSides, OnAPlaneTheInsideOfAClosedCurveIsMinusHoweverLargeItIs)
{
  CurvedSurface plane(planeGrid(20, 20, 2.0, 2.0));
  for (const double radius : { 0.3, 0.97 })
  {
    for (const Positions& loop : { circle(1, 1, radius, 60), reversed(circle(1, 1, radius, 60)) })
    {
      const auto signs = plane.sides({ loop });
      for (Index v = 0; v < signs.size(); ++v)
      {
        const double r = norm(plane.mesh().position(v) - Vector3{ 1, 1, 0 });
        if (std::abs(r - radius) > 0.01)
        {
          EXPECT_EQ(signs[v], r < radius ? -1 : 1) << r;
        }
      }
    }
  }
}

TEST(CurveSides, OnAPlaneTheLeftOfAnOpenCurveIsPlus)
{
  CurvedSurface plane(planeGrid(20, 20, 2.0, 2.0));
  const Positions toTheRight{ { 0, 0.53, 0 }, { 1, 1.47, 0 }, { 2, 0.53, 0 } };
  EXPECT_EQ(plane.sideAt({ toTheRight }, { 1, 1.9, 0 }), 1);
  EXPECT_EQ(plane.sideAt({ toTheRight }, { 1, 0.2, 0 }), -1);
  EXPECT_EQ(plane.sideAt({ reversed(toTheRight) }, { 1, 1.9, 0 }), -1);
  EXPECT_EQ(plane.sideAt({ reversed(toTheRight) }, { 1, 0.2, 0 }), 1);
  // In two lines that follow on each other.
  const std::vector<Positions> parts{ { toTheRight[0], toTheRight[1] },
    { toTheRight[1], toTheRight[2] } };
  EXPECT_EQ(plane.sideAt(parts, { 1, 1.9, 0 }), 1);
}

TEST(CurveSides, TheSignChangesAtEachCurve)
{
  CurvedSurface plane(planeGrid(20, 20, 2.0, 2.0));
  const std::vector<Positions> nested{ circle(1, 1, 0.9, 40), circle(1, 1, 0.6, 40),
    circle(1, 1, 0.3, 40) };
  EXPECT_EQ(plane.sideAt(nested, { 0.1, 0.1, 0 }), 1);
  EXPECT_EQ(plane.sideAt(nested, { 1, 1.75, 0 }), -1);
  EXPECT_EQ(plane.sideAt(nested, { 1, 1.45, 0 }), 1);
  EXPECT_EQ(plane.sideAt(nested, { 1, 1, 0 }), -1);
  const std::vector<Positions> crossing{ circle(0.7, 1, 0.5, 40), circle(1.3, 1, 0.5, 40) };
  EXPECT_EQ(plane.sideAt(crossing, { 0.4, 1, 0 }), -1);
  EXPECT_EQ(plane.sideAt(crossing, { 1, 1, 0 }), 1);
  EXPECT_EQ(plane.sideAt(crossing, { 1.6, 1, 0 }), -1);
  EXPECT_EQ(plane.sideAt(crossing, { 1, 1.9, 0 }), 1);
}

TEST(CurveSides, OnASphereTheSmallerSideIsMinusAndOfEqualOnesTheLeft)
{
  CurvedSurface sphere(icosphere(3));
  EXPECT_EQ(sphere.sideAt({ parallel(0.4) }, { 0, 0, 1 }), -1);
  EXPECT_EQ(sphere.sideAt({ reversed(parallel(0.4)) }, { 0, 0, 1 }), -1);
  EXPECT_EQ(sphere.sideAt({ parallel(-0.4) }, { 0, 0, 1 }), 1);
  // A belt between two large caps lies inside of neither.
  EXPECT_EQ(sphere.sideAt({ parallel(0.1), parallel(-0.1) }, { 1, 0, 0 }), 1);
  EXPECT_EQ(sphere.sideAt({ parallel(0.1), parallel(-0.1) }, { 0, 0, -1 }), -1);
}

TEST(CurveSides, AreRefusedWhereNobodyCanTellThem)
{
  CurvedSurface plane(planeGrid(20, 20, 2.0, 2.0));
  const Positions whole{ { 0, 1.03, 0 }, { 2, 1.07, 0 } };
  const Positions ending{ { 0, 0.53, 0 }, { 1.5, 0.53, 0 } };
  expectContains(plane.errorOf({ whole, ending }), "Lines's line 1 has no two sides: it is open");
  expectContains(plane.errorOf({ { { 1, 1, 0 }, { 1, 1, 0 } } }), "line 0 has no side");
  expectContains(plane.errorOf({ { { 0.31, 1, 0 }, { 1, 1, 0 }, { 0.31, 1, 0 } } }), "no side");
  // The two lines run towards each other.
  expectContains(
    plane.errorOf({ { { 0, 1.03, 0 }, { 1, 1.04, 0 } }, { { 2, 1.07, 0 }, { 1, 1.04, 0 } } }),
    "lines 0 and 1 together have no constant left side");
  // A loop in an open line.
  expectContains(
    plane.errorOf({ { { 0, 0.53, 0 }, { 1.5, 0.57, 0 }, { 1, 1.5, 0 }, { 0.53, 0, 0 } } }),
    "line 0 has no constant left side");
  CurvedSurface sphere(icosphere(3));
  expectContains(sphere.errorOf({ { { 1, 0, 0 }, { 0, 1, 0.2 } } }), "line 0 has no two sides");
  CurvedSurface ring(torus(40, 20, 1.0, 0.4));
  expectContains(ring.errorOf({ { { 1.4, 0, 0 }, { 1, 0, 0.4 }, { 0.6, 0, 0 }, { 1, 0, -0.4 },
                   { 1.4, 0, 0 } } }),
    "line 0 has no inside");
}

// A tube with a line from end to end: without a wall, all round is one side.
TEST(CurveSides, AreToldBetweenWallsOfEachKind)
{
  CurvedSurface tube(cylinder(36, 12, 1.0, 2.0));
  const TriangleMesh& mesh = tube.mesh();
  const Positions seam{ { 1, 0.03, 0 }, { 1, 0.1, 1 }, { 1, 0.03, 2 } };
  expectContains(tube.errorOf({ seam }), "line 0 has no two sides");

  const std::vector<SurfacePath> lines{ tube.line({ { -1, 0.03, 0 }, { -1, 0.05, 2 } }) };
  std::vector<std::uint8_t> excluded(mesh.numberOfVertices(), 0);
  std::vector<std::uint8_t> closed(mesh.numberOfTriangles(), 0);
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    excluded[v] = mesh.position(v).x < -1.0 + 1e-9 ? 1 : 0;
  }
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh.triangle(t);
    const Vector3 middle =
      mesh.position(corners[0]) + mesh.position(corners[1]) + mesh.position(corners[2]);
    closed[t] = middle.x < -2.9 && middle.y > 0.0 ? 1 : 0;
  }
  for (const Walls& walls :
    { Walls{ lines, {}, {} }, Walls{ {}, excluded, {} }, Walls{ {}, {}, closed } })
  {
    const std::vector<std::int8_t> sides = tube.sides({ seam }, walls);
    int told = 0;
    for (Index v = 0; v < mesh.numberOfVertices(); ++v)
    {
      // The side that the line and the wall, which are not just at y = 0, leave no doubt about.
      if (std::abs(mesh.position(v).y) > 0.2)
      {
        ASSERT_EQ(sides[v], mesh.position(v).y > 0.0 ? -1 : 1) << v;
        ++told;
      }
    }
    EXPECT_GT(told, 350);
  }

  // One that ends half way is no wall.
  for (Index v = 0; v < mesh.numberOfVertices(); ++v)
  {
    excluded[v] = mesh.position(v).z < 1.0 ? excluded[v] : 0;
  }
  EXPECT_THROW(tube.sides({ seam }, { {}, excluded, {} }), std::invalid_argument);
}

// The truth is that without walls. They may make the other side of a closed curve the inside, but
// within what a flood over open vertices reaches, for all of it.
TEST(CurveSides, WallsKeepTheSidesUpToTheInside)
{
  std::mt19937 random(11);
  const std::vector<Surface> surfaces{ spot(), torus(40, 20, 1.0, 0.4),
    jitteredGrid(40, 40, 1.2, 1.0, 0.3, 3), icosphere(4) };
  int told = 0;
  int parts = 0;
  for (const Surface& surface : surfaces)
  {
    const CurvedSurface subject(surface);
    const TriangleMesh& mesh = subject.mesh();
    for (int round = 0; round < 60; ++round)
    {
      const LevelSides truth = levelSides(mesh, randomLevels(mesh, random), random);
      if (truth.curves.empty() || !truth.signs)
      {
        continue;
      }
      std::vector<bool> isBeside(mesh.numberOfVertices(), false);
      for (const SurfacePath& curve : truth.curves)
      {
        for (const PathPoint& point : curve)
        {
          for (const Index vertex : point.carriers())
          {
            isBeside[vertex] = true;
            for (const auto& slot : mesh.ring(vertex))
            {
              isBeside[slot.neighbour()] = true;
            }
          }
        }
      }
      std::vector<std::uint8_t> excluded(mesh.numberOfVertices(), 0);
      std::vector<std::uint8_t> closed(mesh.numberOfTriangles(), 0);
      for (Index v = 0; v < mesh.numberOfVertices(); ++v)
      {
        excluded[v] = !isBeside[v] && random() % 100 < 45u ? 1 : 0;
      }
      for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
      {
        const Triangle& corners = mesh.triangle(t);
        const bool isFree =
          std::ranges::none_of(corners, [&](Index corner) { return isBeside[corner]; });
        closed[t] = isFree && random() % 100 < 30u ? 1 : 0;
      }
      const auto sides =
        curveSides(subject.regionMesh(), truth.curves, "Lines", { {}, excluded, closed });
      DisjointSets reached(mesh.numberOfVertices());
      for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
      {
        const Triangle& corners = mesh.triangle(t);
        for (int c = 0; c < 3 && !closed[t]; ++c)
        {
          if (!excluded[corners[c]] && !excluded[corners[(c + 1) % 3]])
          {
            reached.connect(corners[c], corners[(c + 1) % 3]);
          }
        }
      }
      std::map<Index, int> flips;
      for (Index v = 0; v < mesh.numberOfVertices(); ++v)
      {
        if (!excluded[v])
        {
          const int flip = sides[v] * (*truth.signs)[v];
          const auto [known, isNew] = flips.emplace(reached.rootOf(v), flip);
          ASSERT_EQ(known->second, flip) << "round " << round << ", vertex " << v;
          told += flip != 0 ? 1 : 0;
          parts += isNew ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(told, 50000);
  EXPECT_GT(parts, 1000);
}

TEST(CurveSides, AWallIsLikeABorder)
{
  // Without it, the cap above the curve is the smaller side; with it, the belt is smaller.
  CurvedSurface sphere(icosphere(3));
  const std::vector<SurfacePath> walls{ sphere.line(parallel(0.1)) };
  const std::vector<std::int8_t> sides = sphere.sides({ parallel(0.2) }, { walls, {}, {} });
  for (Index v = 0; v < sphere.mesh().numberOfVertices(); ++v)
  {
    const double height = sphere.mesh().position(v).z;
    if (height > 0.25)
    {
      EXPECT_EQ(sides[v], -1) << height;
    }
    else if (height < 0.0)
    {
      EXPECT_EQ(sides[v], 0) << height;
    }
  }
}

TEST(CurveSides, FacesMustBeTurnedAlikeForOpenCurvesOnly)
{
  Surface surface = planeGrid(20, 20, 2.0, 2.0);
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3)
  {
    std::swap(surface.triangles[t][0], surface.triangles[t][1]);
  }
  CurvedSurface mixed(surface);
  EXPECT_EQ(mixed.sideAt({ circle(1, 1, 0.6, 40) }, { 1, 1, 0 }), -1);
  expectContains(mixed.errorOf({ { { 0, 1, 0 }, { 2, 1, 0 } } }), "turned alike");
}

TEST(CurveSides, AreToldThroughSinglePointsAndNotAlongEdgesOfThreeFaces)
{
  // Two squares of 2 x 2 cells that share a corner.
  Surface bow = planeGrid(4, 4, 1.0, 1.0);
  const Surface other = planeGrid(4, 4, 1.0, 1.0);
  const auto first = static_cast<Index>(bow.points.size());
  for (const Vector3& p : other.points)
  {
    bow.points.push_back(p + Vector3{ 1, 1, 0 });
  }
  for (Triangle t : other.triangles)
  {
    for (Index& corner : t)
    {
      corner = corner == 0 ? first - 1 : corner + first;
    }
    bow.triangles.push_back(t);
  }
  CurvedSurface bowTie(bow);
  EXPECT_EQ(bowTie.sideAt({ { { 0, 0.6, 0 }, { 0.6, 0, 0 } } }, { 1.9, 1.9, 0 }), 1);
  EXPECT_EQ(bowTie.sideAt({ { { 0.6, 0, 0 }, { 0, 0.6, 0 } } }, { 1.9, 1.9, 0 }), -1);

  const Surface book{ { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 1, 4 } } };
  CurvedSurface pages(book);
  expectContains(pages.errorOf({ { { 0, 0, 0 }, { 0, 1, 0 } } }), "3 faces meet");
}

// A chain on its own part says nothing of the others.
TEST(CurveSides, AreZeroWhereNoCurveIs)
{
  Surface two = planeGrid(6, 6, 1.0, 1.0);
  const Surface far = planeGrid(6, 6, 1.0, 1.0);
  Surface moved = far;
  for (Vector3& p : moved.points)
  {
    p.z = 5.0;
  }
  CurvedSurface parts(joined(two, moved));
  const auto signs = parts.sides({ { { 0, 0.55, 0 }, { 1, 0.55, 0 } } });
  for (Index v = 0; v < signs.size(); ++v)
  {
    EXPECT_EQ(signs[v] == 0, parts.mesh().position(v).z > 1.0);
  }
}

// Each of n x n loops in a cell of its own, in a time that grows as their number.
TEST(CurveSides, OfVeryManyLoopsTakeATimeInProportion)
{
  const auto secondsFor = [](Index n)
  {
    const auto mesh = meshOf(planeGrid(2 * n, 2 * n, 1.0, 1.0));
    std::vector<SurfacePath> loops;
    for (Index y = 0; y < n; ++y)
    {
      for (Index x = 0; x < n; ++x)
      {
        const Index middle = mesh->vertexOfPoint((2 * y + 1) * (2 * n + 1) + 2 * x + 1);
        SurfacePath loop;
        for (const RingEntry& entry : mesh->ring(middle))
        {
          loop.push_back(PathPoint::onEdge(middle, entry.neighbour(), 0.4));
        }
        loops.push_back(std::move(loop));
      }
    }
    const auto regions = std::make_shared<const RegionMesh>(mesh);
    const auto begin = std::chrono::steady_clock::now();
    const auto signs = curveSides(regions, loops, "Lines");
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(std::count(signs.begin(), signs.end(), -1), n * n);
    return time.count();
  };
  secondsFor(20);
  const double few = secondsFor(25);
  const double many = secondsFor(100);
  RecordProperty("seconds", std::to_string(many));
  EXPECT_LT(many, 16.0 * 8.0 * few + 1.0);
}
