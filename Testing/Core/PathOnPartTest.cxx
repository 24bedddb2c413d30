// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths on a part of a surface tell where they depend on the rest.

#include "PathStyles.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

class PathOnPart : public ::testing::TestWithParam<PathStyle>
{
protected:
  /** One flag a vertex. */
  std::vector<std::uint8_t> fartherThan(double distance, const SurfacePath& path) const
  {
    std::vector<std::uint8_t> far(this->Mesh->numberOfVertices(), 1);
    for (Index v = 0; v < this->Mesh->numberOfVertices(); ++v)
    {
      for (const PathPoint& point : path)
      {
        if (norm(point.position(*this->Mesh) - this->Mesh->position(v)) <= distance)
        {
          far[v] = 0;
        }
      }
    }
    return far;
  }

  std::shared_ptr<const TriangleMesh> Mesh = meshOf(torus(120, 60, 1.0, 0.4));
  SurfacePoint From = seedNear(this->Mesh, { 1.3, 0.2, 0.3 }).points[0];
  SurfacePoint To = seedNear(this->Mesh, { -1.35, 0.1, 0.1 }).points[0];
  FastMarchingSolver Solver{ this->Mesh };
};

}

TEST_P(PathOnPart, IsThatOnTheWholeWhereAllItNeedsIsThere)
{
  const auto whole = shortestPath(this->Solver, this->From, this->To, {}, GetParam());
  ASSERT_TRUE(whole);
  SolveOptions options;
  // Ways along edges that may be shorter are sought in a wide strip.
  const auto far = this->fartherThan(0.6, *whole);
  options.incomplete = far;
  const auto path = shortestPath(this->Solver, this->From, this->To, options, GetParam());
  ASSERT_TRUE(path);
  EXPECT_EQ(*path, *whole);
}

TEST_P(PathOnPart, NamesAVertexBesideItWhoseTrianglesAreNotAllThere)
{
  const auto whole = shortestPath(this->Solver, this->From, this->To, {}, GetParam());
  ASSERT_TRUE(whole);
  // The part ends round the middle of the path.
  const SurfacePath middle{ (*whole)[whole->size() / 2] };
  std::vector<std::uint8_t> near = this->fartherThan(0.15, middle);
  for (std::uint8_t& flag : near)
  {
    flag = flag ? 0 : 1;
  }
  SolveOptions options;
  options.incomplete = near;
  try
  {
    shortestPath(this->Solver, this->From, this->To, options, GetParam());
    FAIL() << "Went where triangles are missing.";
  }
  catch (const IncompleteRing& end)
  {
    EXPECT_TRUE(near[end.vertex()]);
  }
}

INSTANTIATE_TEST_SUITE_P(Path, PathOnPart, ::testing::Values(Straight, Traced, AlongEdges),
  [](const auto& info) {
    return info.param == AlongEdges ? "AlongEdges" : info.param == Traced ? "Traced" : "Straight";
  });
