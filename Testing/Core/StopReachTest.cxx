// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// How far above a limit values still matter: by the definition, without its order of work.

#include "march/StopReach.h"
#include "RandomMeshes.h"
#include "solve/Partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Twice the longest side times the largest cost there, and what neighbours have less half the
 * edge, until nothing changes. */
std::vector<double> reachesByDefinition(const TriangleMesh& mesh, const std::vector<double>& cost)
{
  const auto costAt = [&](Index v) { return cost.empty() ? 1.0 : cost[v]; };
  std::vector<double> reaches(mesh.numberOfVertices());
  for (Index v = 0; v < reaches.size(); ++v)
  {
    double dearest = costAt(v);
    for (const RingEntry& entry : mesh.ring(v))
    {
      dearest = std::max(dearest, costAt(entry.neighbour()));
    }
    reaches[v] = 2.0 * mesh.longestEdgeAround(v) * dearest;
  }
  bool changes = true;
  while (changes)
  {
    changes = false;
    for (Index v = 0; v < reaches.size(); ++v)
    {
      for (const RingEntry& entry : mesh.ring(v))
      {
        const Index w = entry.neighbour();
        const double fall =
          0.5 * std::min(costAt(v), costAt(w)) * norm(mesh.position(v) - mesh.position(w));
        if (reaches[w] - fall > reaches[v])
        {
          reaches[v] = reaches[w] - fall;
          changes = true;
        }
      }
    }
  }
  return reaches;
}

}

TEST(StopReach, IsThatOfTheDefinition)
{
  unsigned withCosts = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const RandomCase test = randomCase(seed, CaseLimits{});
    SCOPED_TRACE(test.description());
    withCosts += test.cost.empty() ? 0 : 1;
    Partition onePiece;
    const std::vector<float> found = stopReaches(*test.mesh, test.cost, onePiece);
    const std::vector<double> expected = reachesByDefinition(*test.mesh, test.cost);
    const double largest = *std::max_element(expected.begin(), expected.end());
    for (Index v = 0; v < found.size(); ++v)
    {
      ASSERT_NEAR(found[v], expected[v], 1e-5 * largest);
    }
  }
  EXPECT_GT(withCosts, 10u);
}
