// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Several labels give one field, whichever of them comes first. Ranks march in other orders than
// one rank, so what a vertex keeps of several labels must not depend on what it has so far.

#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/LabelBounds.h"
#include "march/ReferenceSolver.h"
#include "solve/Partition.h"
#include "solve/SeedFront.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/**
 * One piece on which the front of a label goes along edges all over the surface, before anything
 * else is done: an order that is allowed, and as far from that of the distances as can be. It goes
 * on from what vertices keep only.
 */
class OneLabelFirst : public Partition
{
public:
  OneLabelFirst(const TriangleMesh& mesh, std::span<const double> cost, Index label)
    : Mesh(mesh)
    , Cost(cost)
    , Label(label)
  {
  }

  bool march(MarchingFront& front, StopLimit& limit) override
  {
    std::set<std::pair<double, Index>> waiting;
    for (Index vertex = 0; vertex < this->Mesh.numberOfVertices(); ++vertex)
    {
      // Each vertex of the disc round the seed has a start value.
      if (const double value = this->valueAt(vertex, front); value < DistanceField::Unreached)
      {
        waiting.insert({ value, vertex });
      }
    }
    while (!waiting.empty())
    {
      const auto [value, vertex] = *waiting.begin();
      waiting.erase(waiting.begin());
      this->goOn(vertex, value, front, waiting);
      ++this->Steps;
    }
    return this->Partition::march(front, limit);
  }

  std::size_t steps() const { return this->Steps; }

private:
  double valueAt(Index vertex, const MarchingFront& front) const
  {
    double value = DistanceField::Unreached;
    front.visitValues(
      vertex, [&](Index label, double kept) { value = label == this->Label ? kept : value; });
    return value;
  }

  void goOn(
    Index vertex, double value, MarchingFront& front, std::set<std::pair<double, Index>>& waiting)
  {
    const auto ring = this->Mesh.ring(vertex);
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
      const std::array ends{ ring[i].neighbour(), ring[i + 1].neighbour() };
      if (!ring[i].opensTriangle())
      {
        continue;
      }
      const double cost = (this->Cost[vertex] + this->Cost[ends[0]] + this->Cost[ends[1]]) / 3.0;
      for (const Index end : ends)
      {
        const double length = norm(this->Mesh.position(end) - this->Mesh.position(vertex));
        const double before = this->valueAt(end, front);
        front.lower(end, this->Label, value + cost * length);
        if (const double after = this->valueAt(end, front); after < before)
        {
          waiting.erase({ before, end });
          waiting.insert({ after, end });
        }
      }
    }
  }

  const TriangleMesh& Mesh;
  std::span<const double> Cost;
  Index Label;
  std::size_t Steps = 0;
};

/** Costs of 1, and of up to 500 at one vertex in so many. */
std::vector<double> jumpingCosts(Index count, unsigned rarity, std::mt19937& random)
{
  std::uniform_real_distribution<double> exponent(0.0, 1.0);
  std::vector<double> costs(count, 1.0);
  for (double& cost : costs)
  {
    cost = random() % rarity == 0 ? std::pow(500.0, exponent(random)) : 1.0;
  }
  return costs;
}

template <class Solver>
void expectNoOrder(unsigned number)
{
  std::mt19937 random(number);
  const auto mesh = meshOf(jitteredGrid(30, 30, 1.0, 1.0, 0.3, number));
  const auto costs = jumpingCosts(mesh->numberOfVertices(), 2 + number % 9, random);
  std::vector<Seed> seeds;
  for (int i = 0; i < 5; ++i)
  {
    seeds.push_back(Seed::atPoint(mesh->pointAtVertex(random() % mesh->numberOfVertices())));
  }
  const Triangle& triangle = mesh->triangles()[random() % mesh->numberOfTriangles()];
  seeds.push_back(
    Seed::alongCurve({ mesh->pointAtVertex(triangle[0]), mesh->pointAtVertex(triangle[1]) }));
  SolveOptions options;
  options.cost = costs;
  Solver solver(mesh);
  const auto solve = [&](Partition* partition)
  {
    options.partition = partition;
    const auto distances = solver.solve(seeds, options).distances();
    return std::vector<double>(distances.begin(), distances.end());
  };
  const auto expected = solve(nullptr);
  const double farthest = *std::max_element(expected.begin(), expected.end());
  for (Index label = 0; label < seeds.size(); ++label)
  {
    OneLabelFirst partition(*mesh, costs, label);
    const auto found = solve(&partition);
    ASSERT_GT(partition.steps(), 20u);
    for (Index v = 0; v < found.size(); ++v)
    {
      EXPECT_NEAR(found[v], expected[v], 1e-9 * farthest) << number << " " << label << " " << v;
    }
  }
}

}

TEST(LabelOrder, JumpingCostsKeepTheField)
{
  for (unsigned number = 0; number < 30; ++number)
  {
    expectNoOrder<FastMarchingSolver>(number);
  }
}

TEST(LabelOrder, JumpingCostsKeepTheFieldOfTheReference)
{
  for (unsigned number = 0; number < 5; ++number)
  {
    expectNoOrder<ReferenceSolver>(number);
  }
}

// Of equal starts at a vertex a final one counts, of others the least, whichever comes first.
TEST(LabelOrder, OfEqualStartsAFinalOneCounts)
{
  const auto mesh = meshOf(planeGrid(4, 4, 1.0, 1.0));
  std::vector<Label> labels(3);
  for (Index i = 0; i < labels.size(); ++i)
  {
    labels[i].seed = i;
    labels[i].value = i < 2 ? 0.0 : 1.0;
  }
  const StartValue open{ 7, 0, 0.5, false };
  const StartValue final{ 7, 1, 0.5, true };
  const StartValue farther{ 7, 2, 0.5, true };
  Partition whole;
  const auto isFinal = [&](const std::vector<StartValue>& starts)
  {
    LabelBounds bounds;
    bounds.begin(*mesh, labels, starts, whole);
    EXPECT_EQ(bounds.starts().size(), 1u);
    EXPECT_EQ(bounds.starts()[0].value, 0.5);
    return bounds.starts()[0].isFinal;
  };
  EXPECT_TRUE(isFinal({ open, final }));
  EXPECT_TRUE(isFinal({ final, open }));
  EXPECT_FALSE(isFinal({ open, farther }));
  EXPECT_FALSE(isFinal({ farther, open }));
}
