// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// What keeps no part of its work can be ended early, and asks often enough whether it must.

#include "base/Interruption.h"
#include "Solving.h"
#include "Surfaces.h"
#include "mesh/EdgeTable.h"
#include "mesh/TriangleMesh.h"
#include "path/PathPoint.h"
#include "search/ClosestPointTree.h"
#include "split/SplitMesh.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr Index Side = 200;

/** Long work on a surface, by name. */
std::map<std::string, std::function<void()>> longWork()
{
  const Surface surface = planeGrid(Side, Side, 1.0, 1.0);
  const auto mesh = meshOf(surface);
  const SurfacePath cut{ PathPoint::atVertex(0), PathPoint::atVertex(1) };
  return { { "mesh", [=] { meshOf(surface); } }, { "tree", [=] { ClosestPointTree tree(mesh); } },
    { "table of edges", [=] { EdgeTable edges(*mesh); } },
    { "split mesh", [=] { SplitMesh split(mesh, {}, std::vector<SurfacePath>{ cut }); } } };
}

}

TEST(Interruption, EndsLongWorkAtEachPlaceThatAsks)
{
  for (const auto& [name, work] : longWork())
  {
    int asked = 0;
    {
      const Interruption interruption(
        [&]
        {
          ++asked;
          return true;
        });
      work();
    }
    // Of 40,401 points, and 80,000 triangles.
    EXPECT_GE(asked, 5) << name;
    for (const int last : { 1, asked / 2, asked })
    {
      int left = last;
      const Interruption interruption([&] { return --left > 0; });
      EXPECT_THROW(work(), Interrupted) << name << ", asked " << last << " times";
    }
    EXPECT_NO_THROW(work()) << name;
  }
}

TEST(Interruption, IsThatOfTheInnermostObjectOfItsThread)
{
  const Interruption outer([] { return false; });
  EXPECT_THROW(Interruption::check(), Interrupted);
  {
    const Interruption inner([] { return true; });
    EXPECT_NO_THROW(Interruption::check());
  }
  EXPECT_THROW(Interruption::check(), Interrupted);
  EXPECT_THROW(Interruption::checkAt(2048), Interrupted);
  EXPECT_NO_THROW(Interruption::checkAt(2049));
}
