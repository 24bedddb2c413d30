// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Closed triangles: the front goes round them, their border points are open.

#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"
#include "windows/ExactSolver.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

template <class Solver>
class Barrier : public ::testing::Test
{
protected:
  /** Closes the triangles whose centre lies in the box. */
  std::vector<std::uint8_t> closedIn(double x0, double x1, double y0, double y1)
  {
    std::vector<std::uint8_t> closed(this->mesh->numberOfTriangles(), 0);
    for (Index t = 0; t < closed.size(); ++t)
    {
      const Vector3 c = this->mesh->positionOf({ t, { 1.0 / 3, 1.0 / 3, 1.0 / 3 } });
      closed[t] = c.x > x0 && c.x < x1 && c.y > y0 && c.y < y1;
    }
    return closed;
  }

  std::string messageOf(const Seed& seed, const SolveOptions& options)
  {
    try
    {
      distances<Solver>(this->mesh, { seed }, options);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  }

  const Surface surface = planeGrid(20, 20, 20.0, 20.0);
  const std::shared_ptr<const TriangleMesh> mesh = meshOf(surface);
};

}

using Solvers = ::testing::Types<FastMarchingSolver, DijkstraSolver, ExactSolver>;
TYPED_TEST_SUITE(Barrier, Solvers);

TYPED_TEST(Barrier, AClosedStripSeparates)
{
  const auto closed = this->closedIn(8.0, 10.0, -1.0, 21.0);
  SolveOptions options;
  options.closedTriangles = closed;
  const auto d = distances<TypeParam>(this->mesh, { seedAt(*this->mesh, 0) }, options);
  for (Index i = 0; i < d.size(); ++i)
  {
    EXPECT_EQ(std::isfinite(d[i]), this->surface.points[i].x <= 8.0) << i;
  }
}

TYPED_TEST(Barrier, TheWayLeadsRoundIt)
{
  const auto closed = this->closedIn(8.0, 10.0, 5.0, 21.0);
  SolveOptions options;
  options.closedTriangles = closed;
  const auto d = distances<TypeParam>(this->mesh, { seedAt(*this->mesh, 10 * 21 + 8) }, options);
  // From (8, 10) down to (8, 5), along to (10, 5), up to (10, 10): its border is open.
  EXPECT_NEAR(d[10 * 21 + 10], 12.0, 1e-9);
  EXPECT_FALSE(std::isfinite(d[15 * 21 + 9]));
}

TYPED_TEST(Barrier, ASeedInsideIsAnError)
{
  const auto closed = this->closedIn(5.0, 10.0, 5.0, 10.0);
  SolveOptions options;
  options.closedTriangles = closed;
  EXPECT_NE(this->messageOf(seedNear(this->mesh, { 7.3, 7.2, 0 }), options).find("barrier"),
    std::string::npos);
  EXPECT_NE(
    this->messageOf(seedAt(*this->mesh, 7 * 21 + 7), options).find("barrier"), std::string::npos);
  EXPECT_EQ(this->messageOf(seedAt(*this->mesh, 5 * 21 + 7), options), "");
}

TYPED_TEST(Barrier, TheMaskMustFit)
{
  const std::vector<std::uint8_t> closed(3, 1);
  SolveOptions options;
  options.closedTriangles = closed;
  EXPECT_NE(
    this->messageOf(seedAt(*this->mesh, 0), options).find("800 triangles"), std::string::npos);
}
