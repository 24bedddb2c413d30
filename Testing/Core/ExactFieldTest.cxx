// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Real meshes against exact polyhedral distances.

#include "ExactDistances.h"
#include "RoundedTube.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "solve/DijkstraSolver.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

class Spot : public ::testing::Test
{
protected:
  const Surface surface = spot();
  const std::shared_ptr<const TriangleMesh> mesh = meshOf(surface);
};

}

// The oracle itself, from inside faces of all shapes, where two truths are at hand.
TEST(ExactOracle, AgreesWithTheUnrolledTube)
{
  const RoundedTube tube(1, 4, 10.0, 1);
  for (Index source : { 0u, 333u, 700u })
  {
    const SurfacePoint point{ source, { 0.5, 0.3, 0.2 } };
    const auto exact = exactDistancesFrom(tube.surface(), point);
    EXPECT_LT(relativeError(exact, tube.distancesFrom(point)).largest, 1e-9);
  }
}

// First order accurate: half a per cent on Spot's 3,000 points.
TEST_F(Spot, FastMarchingIsNearTheExactDistance)
{
  for (Index source : { 0u, 700u, 2500u })
  {
    const auto exact = exactDistances(this->surface, { source });
    const auto d = distances<FastMarchingSolver>(this->mesh, { seedAt(*this->mesh, source) });
    EXPECT_LT(relativeError(d, exact).mean, 6e-3);
  }
}

// Edges are ways over the surface, so Dijkstra is never shorter than the exact distance, nor than
// fast marching, whose update includes the edges.
TEST_F(Spot, DijkstraIsAnUpperBound)
{
  const auto exact = exactDistances(this->surface, { 100 });
  const auto march = distances<FastMarchingSolver>(this->mesh, { seedAt(*this->mesh, 100) });
  const auto edges = distances<DijkstraSolver>(this->mesh, { seedAt(*this->mesh, 100) });
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    EXPECT_GE(edges[i], exact[i] * (1.0 - 1e-12));
    EXPECT_GE(edges[i], march[i] * (1.0 - 1e-12));
  }
}

TEST_F(Spot, DistancesDifferByAtMostTheEdge)
{
  const auto d = distances<FastMarchingSolver>(this->mesh, { seedAt(*this->mesh, 5) });
  for (const Triangle& t : this->surface.triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index a = t[c];
      const Index b = t[(c + 1) % 3];
      const double edge = norm(this->surface.points[a] - this->surface.points[b]);
      EXPECT_LE(std::abs(d[a] - d[b]), edge * (1.0 + 1e-9));
    }
  }
}

TEST_F(Spot, SeveralSourcesAreTheMinimum)
{
  const std::vector<Index> sources{ 0, 700, 1400, 2500 };
  const auto exact = exactDistances(this->surface, sources);
  std::vector<Seed> seeds;
  for (Index source : sources)
  {
    seeds.push_back(seedAt(*this->mesh, source));
  }
  EXPECT_LT(relativeError(distances<FastMarchingSolver>(this->mesh, seeds), exact).mean, 6e-3);
}
