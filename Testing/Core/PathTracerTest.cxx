// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Which seeds a trace aims at.

#include "path/PathTracer.h"
#include "Solving.h"
#include "Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

// Two corners of a face lead to one seed, one of them the best of all and the other the worst: what
// counts is the better one, in whatever order they come.
TEST(PathTracer, TheLeastTotalOfASeedCounts)
{
  const auto mesh = meshOf({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.8, 0 } }, { { 0, 1, 2 } } });
  const SolveOptions options;
  SearchProgress progress(options);
  const WeightedMesh weighted(*mesh, options, progress);
  const PathEnds noEnds(*mesh, {});
  const PathPoint middle = PathPoint::at(*mesh, { 0, { 0.34, 0.33, 0.33 } });
  struct Corner
  {
    double distance;
    Index seed;
  };
  constexpr std::array corners{ Corner{ 9.0, 1 }, Corner{ 5.0, 0 }, Corner{ 1.0, 1 } };
  std::array<Index, 3> order{ 0, 1, 2 };
  do
  {
    DistanceField field(3);
    for (Index v = 0; v < 3; ++v)
    {
      field.setDistance(v, corners[order[v]].distance);
      field.setNearestSeed(v, corners[order[v]].seed);
    }
    EXPECT_EQ(PathTracer(weighted, field, noEnds).seedsNear(middle), (std::vector<Index>{ 1, 0 }));
  } while (std::next_permutation(order.begin(), order.end()));
}

// So are paths followed on parts of a surface before it is known where they run.
TEST(PathTracer, WithoutItsEndItGoesToTheBorderOfTheMesh)
{
  const auto mesh = meshOf(planeGrid(20, 20, 20.0, 20.0));
  SolveOptions options;
  std::vector<std::uint8_t> incomplete(mesh->numberOfVertices());
  DistanceField field(mesh->numberOfVertices());
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    const Vector3& p = mesh->position(v);
    incomplete[v] = p.x < 5.0 || p.y < 5.0 ? 1 : 0;
    field.setDistance(v, norm(p));
    field.setNearestSeed(v, 7);
  }
  options.incomplete = incomplete;
  SearchProgress progress(options);
  const WeightedMesh weighted(*mesh, options, progress);
  const PathEnds noEnds(*mesh, {});
  PathTracer tracer(weighted, field, noEnds);
  const Index start = std::max_element(field.distances().begin(), field.distances().end()) -
    field.distances().begin();
  try
  {
    tracer.trace(PathPoint::atVertex(start), 7, PathOrder::Edges);
    ADD_FAILURE() << "It has come to an end.";
  }
  catch (const IncompleteRing& border)
  {
    const Vector3& p = mesh->position(border.vertex());
    EXPECT_LT(norm(p - Vector3{ 5.0, 5.0, 0.0 }), 2.0);
  }
  const auto path = tracer.trace(PathPoint::atVertex(start), 7, PathOrder::Edges,
    [&](const SurfacePath& soFar) { return soFar.back().position(*mesh).x < 10.0; });
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->back().position(*mesh).x, 10.0, 1.0);
}
