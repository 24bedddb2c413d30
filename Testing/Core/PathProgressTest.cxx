// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The search for a path reports its progress, and can be cancelled, also between its marches.

#include "PathStyles.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr Index CellsOfStrip = 20000;

/** A path from end to end of a strip, whose trace has many bends to be straightened. */
class PathProgress : public ::testing::Test
{
protected:
  PathProgress()
    : Mesh(meshOf(planeGrid(CellsOfStrip, 1, CellsOfStrip, 1.0)))
    , Solver(this->Mesh)
    , From(this->Mesh->pointAtVertex(this->Mesh->vertexOfPoint(0)))
    , To(this->Mesh->pointAtVertex(this->Mesh->vertexOfPoint(2 * CellsOfStrip + 1)))
  {
  }

  const std::shared_ptr<const TriangleMesh> Mesh;
  FastMarchingSolver Solver;
  const SurfacePoint From;
  const SurfacePoint To;
};

}

TEST_F(PathProgress, GoesOnWhileThePathIsTracedAndStraightened)
{
  std::vector<std::size_t> counts;
  SolveOptions options;
  options.onProgress = [&](std::size_t count)
  {
    counts.push_back(count);
    return true;
  };
  PathFinder finder(this->Solver, { &this->From, 1 }, options, Straight);
  ASSERT_TRUE(finder.march({ &this->To, 1 }));
  const std::size_t ofMarch = counts.size();
  ASSERT_TRUE(finder.pathFrom(this->To).has_value());
  // A hundred thousand faces are laid flat at least.
  EXPECT_GT(counts.size(), ofMarch + 6);
  EXPECT_TRUE(std::is_sorted(counts.begin(), counts.end()));
}

TEST_F(PathProgress, NoneIsFoundOnceItIsCancelled)
{
  bool goesOn = true;
  std::size_t reports = 0;
  SolveOptions options;
  options.onProgress = [&](std::size_t)
  {
    ++reports;
    return goesOn;
  };
  PathFinder finder(this->Solver, { &this->From, 1 }, options, Straight);
  ASSERT_TRUE(finder.march({ &this->To, 1 }));
  goesOn = false;
  reports = 0;
  EXPECT_FALSE(finder.pathFrom(this->To).has_value());
  EXPECT_EQ(reports, 1);
  goesOn = true;
  EXPECT_TRUE(finder.pathFrom(this->To).has_value());
}
