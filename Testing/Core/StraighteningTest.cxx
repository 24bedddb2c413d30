// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths that are far from straight, with much to do at one bend or at many.

#include "Surfaces.h"
#include "path/PathStraightener.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Straightens a path through points of a surface, each of them in a face with the next. */
class Straightening
{
public:
  Straightening(const Surface& surface, const std::vector<Index>& points)
    : Mesh(surface.points, surface.triangles)
    , Progress(this->Options)
    , Weighted(this->Mesh, this->Options, this->Progress)
  {
    SurfacePath path;
    for (const Index point : points)
    {
      path.push_back(PathPoint::atVertex(this->Mesh.vertexOfPoint(point)));
    }
    this->Path = PathStraightener(this->Weighted).straightened(path);
  }

  double length() const { return lengthOf(this->Mesh, this->Path); }
  const SurfacePath& path() const { return this->Path; }

private:
  TriangleMesh Mesh;
  SolveOptions Options;
  SearchProgress Progress;
  WeightedMesh Weighted;
  SurfacePath Path;
};

}

// Between a point and a branch of a hyperbola that bulges towards it, the shortest path from end to
// end of the branch is the branch. It bends at each of its points; a search that begins anew at
// each bend would take hours.
TEST(Straightening, FollowsABorderOf100000TrianglesRoundOnePoint)
{
  constexpr Index triangles = 100'000;
  Surface surface;
  surface.points.push_back({ 0.0, 0.0, 0.0 });
  double exact = 0.0;
  for (Index i = 0; i <= triangles; ++i)
  {
    const double t = 6.0 * i / triangles - 3.0;
    surface.points.push_back({ std::cosh(t), std::sinh(t), 0.0 });
    if (i > 0)
    {
      surface.triangles.push_back({ 0, i, i + 1 });
      exact += norm(surface.points[i + 1] - surface.points[i]);
    }
  }
  const Straightening made(surface, { 1, 0, triangles + 1 });
  EXPECT_NEAR(made.length(), exact, 1e-9 * exact);
  EXPECT_EQ(made.path().size(), triangles + 1);
}

// Along two borders of a square, across which the shortest path is its diagonal, against all
// diagonals of the cells.
TEST(Straightening, LeadsAPathAlongBordersAcrossTheSquare)
{
  constexpr Index cells = 60;
  const Surface surface = planeGrid(cells, cells, 1.0, 1.0);
  constexpr Index columns = cells + 1;
  for (const bool byRight : { false, true })
  {
    std::vector<Index> border;
    for (Index i = 0; i < cells; ++i)
    {
      border.push_back(byRight ? i : i * columns);
    }
    for (Index i = 0; i <= cells; ++i)
    {
      border.push_back(byRight ? cells + i * columns : cells * columns + i);
    }
    EXPECT_NEAR(Straightening(surface, border).length(), std::sqrt(2.0), 1e-12);
  }
}

// A row of vertices on a border that a path follows stays, as none of them has another side.
TEST(Straightening, KeepsAPathAlongABorder)
{
  constexpr Index cells = 100'000;
  const Surface surface = planeGrid(cells, 1, cells, 1.0);
  std::vector<Index> border(cells + 1);
  for (Index i = 0; i <= cells; ++i)
  {
    border[i] = i;
  }
  const Straightening made(surface, border);
  EXPECT_NEAR(made.length(), cells, 1e-9 * cells);
}
