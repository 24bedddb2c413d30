// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The two tiers of fast marching give one field: the batched solver is held to the reference on
// random meshes of all kinds, and the reference to truths that are known.

#include "ExactDistances.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "march/ReferenceSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** Largest difference between two fields, in parts of the largest distance. */
double difference(const DistanceField& a, const DistanceField& b)
{
  double largest = 0.0;
  for (Index v = 0; v < a.distances().size(); ++v)
  {
    if (a.isReached(v) != b.isReached(v))
    {
      return DistanceField::Unreached;
    }
    if (a.isReached(v))
    {
      largest = std::max(largest, std::abs(a.distance(v) - b.distance(v)));
    }
  }
  return largest / b.largestDistance();
}

/** Of both tiers on random cases with these seeds. */
void expectOneField(unsigned first, unsigned last, const CaseLimits& limits, double tolerance)
{
  for (unsigned seed = first; seed < last; ++seed)
  {
    const RandomCase test = randomCase(seed, limits);
    SCOPED_TRACE("case " + std::to_string(seed) + ": " + test.description());
    FastMarchingSolver batched(test.mesh);
    ReferenceSolver reference(test.mesh);
    const DistanceField& field = batched.solve(test.seeds, test.options());
    const DistanceField& truth = reference.solve(test.seeds, test.options());
    EXPECT_LE(difference(field, truth), tolerance) << "case " << seed << ": " << test.description();
  }
}

}

// Values that count are 1e-12 lower each, so fields differ by no more than rounding grows to.
TEST(Reference, BatchedSolverGivesTheSameFieldFromOneSeed)
{
  expectOneField(0, 250, CaseLimits{}, 1e-9);
}

// Where fronts of several seeds meet, what the margin cuts off depends on the order; see
// LabelMargin.h.
TEST(Reference, BatchedSolverGivesTheSameFieldFromSeveralSeeds)
{
  expectOneField(250, 500, CaseLimits{ 50 }, 1e-7);
}

// A limit leaves all values below it as they are. On needles they depend on values far above it;
// see StopReach.h. Values nearer to the limit than rounding are left out.
TEST(Reference, LimitLeavesWhatIsBelowIt)
{
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    const RandomCase test = randomCase(seed, CaseLimits{});
    FastMarchingSolver unlimited(test.mesh);
    FastMarchingSolver limited(test.mesh);
    const DistanceField& whole = unlimited.solve(test.seeds, test.options());
    for (const double part : { 0.1, 0.4 })
    {
      SolveOptions options = test.options();
      options.maximumDistance = part * whole.largestDistance();
      const DistanceField& field = limited.solve(test.seeds, options);
      for (Index v = 0; v < test.mesh->numberOfVertices(); ++v)
      {
        if (whole.isReached(v) && whole.distance(v) < (1.0 - 1e-9) * options.maximumDistance)
        {
          ASSERT_NEAR(field.distance(v), whole.distance(v), 1e-9 * whole.largestDistance())
            << "case " << seed << ": " << test.description() << ", vertex " << v << ", part "
            << part;
        }
      }
    }
  }
}

// Costs that differ by orders of magnitude have queues in the order of the values. By buckets the
// two tiers took 48 and 19 updates a vertex on this grid.
TEST(Reference, BatchedSolverGivesTheSameFieldWhereCostsDifferWidely)
{
  const auto mesh = meshOf(jitteredGrid(60, 60, 60.0, 60.0, 0.3, 1));
  std::mt19937 random(3);
  std::normal_distribution<double> logarithm(0.0, 4.0);
  std::vector<double> cost(mesh->numberOfVertices());
  std::generate(cost.begin(), cost.end(), [&] { return std::exp(logarithm(random)); });
  std::size_t steps = 0;
  SolveOptions options;
  options.cost = cost;
  options.progressInterval = 1;
  options.onProgress = [&](std::size_t count) { return (steps = count) > 0; };
  FastMarchingSolver batched(mesh);
  ReferenceSolver reference(mesh);
  for (const std::vector<Seed>& seeds :
    { std::vector{ seedAt(*mesh, 1800) }, std::vector{ seedAt(*mesh, 1800), seedAt(*mesh, 7) } })
  {
    const double most = 14.0 * static_cast<double>(seeds.size() * mesh->numberOfVertices());
    const DistanceField& field = batched.solve(seeds, options);
    EXPECT_LT(static_cast<double>(steps), most);
    const DistanceField& truth = reference.solve(seeds, options);
    EXPECT_LT(static_cast<double>(steps), most);
    EXPECT_LE(difference(field, truth), 1e-9);
  }
}

// From the apex, a ring of vertices lies three edges off, just where the disc ends in which values
// are final (see CostedStart.h). Rounding decided which of them were inside.
TEST(Reference, BatchedSolverGivesTheSameFieldFromAnApex)
{
  for (const Index around : { 20u, 31u, 58u })
  {
    const auto mesh = meshOf(cone(around, 9, 1.0, 3.0));
    std::mt19937 random(around);
    std::lognormal_distribution<double> spread(0.0, 2.0);
    std::vector<double> cost(mesh->numberOfVertices());
    std::generate(cost.begin(), cost.end(), [&] { return spread(random); });
    SolveOptions options;
    options.cost = cost;
    const Seed apex = seedAt(*mesh, 0);
    EXPECT_LE(difference(FastMarchingSolver(mesh).solve({ &apex, 1 }, options),
                ReferenceSolver(mesh).solve({ &apex, 1 }, options)),
      1e-9)
      << around;
  }
}

// There the front is a vertex or two all the way. One strip is open, and the other one a tube.
TEST(Reference, BatchedSolverGivesTheSameFieldOnStrips)
{
  for (const Surface& strip : { jitteredGrid(400, 1, 400.0, 1.0, 0.3, 2), cone(3, 300, 2.0, 3.0) })
  {
    const auto mesh = meshOf(strip);
    std::mt19937 random(5);
    std::bernoulli_distribution isClosed(0.2);
    std::vector<std::uint8_t> closed(mesh->numberOfTriangles());
    std::generate(closed.begin(), closed.end(), [&] { return isClosed(random) ? 1 : 0; });
    SolveOptions barriers;
    barriers.closedTriangles = closed;
    const Seed point = seedAt(*mesh, 1);
    const Seed region = Seed::onRegion({ 0, 1, 2 });
    for (const SolveOptions& options : { SolveOptions(), barriers })
    {
      for (const Seed& seed : { point, region })
      {
        EXPECT_LE(difference(FastMarchingSolver(mesh).solve({ &seed, 1 }, options),
                    ReferenceSolver(mesh).solve({ &seed, 1 }, options)),
          1e-10);
      }
    }
  }
}

// The flat source is exact on a plane: straight lines.
TEST(Reference, PlaneIsExact)
{
  const Surface plane = delaunayPlane(2000, 1);
  const auto mesh = meshOf(plane);
  const auto d = distances<ReferenceSolver>(mesh, { seedAt(*mesh, 7) });
  for (Index i = 0; i < plane.points.size(); ++i)
  {
    ASSERT_NEAR(d[i], norm(plane.points[i] - plane.points[7]), 1e-12);
  }
}

// Great circle: d = R acos(p.q), first order in the edge length.
TEST(Reference, SphereIsFirstOrder)
{
  double before = 0.0;
  for (const int level : { 4, 5 })
  {
    const Surface sphere = icosphere(level);
    const auto mesh = meshOf(sphere);
    const auto d = distances<ReferenceSolver>(mesh, { seedAt(*mesh, 0) });
    double sum = 0.0;
    for (Index i = 0; i < sphere.points.size(); ++i)
    {
      const double cosine = std::clamp(dot(sphere.points[i], sphere.points[0]), -1.0, 1.0);
      sum += std::abs(d[i] - std::acos(cosine));
    }
    const double mean = sum / static_cast<double>(sphere.points.size());
    if (before > 0.0)
    {
      EXPECT_NEAR(std::log2(before / mean), 1.0, 0.3);
    }
    before = mean;
  }
}
