// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Farthest point sampling, against fields of whole solves from each sample.

#include "ExactDistances.h"
#include "RandomMeshes.h"
#include "Solving.h"
#include "march/FastMarchingSolver.h"
#include "methods/SolverTable.h"
#include "methods/SolverTeam.h"
#include "solve/ClosedTriangles.h"
#include "survey/FarthestPointSampling.h"
#include "survey/FarthestVertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr double Unreached = DistanceField::Unreached;

Sampling samplingOf(DistanceSolver& solver, std::size_t count, double spacing = 0.0,
  const SolveOptions& options = {}, std::span<const Seed> first = {})
{
  SamplingRequest request;
  request.count = count;
  request.spacing = spacing;
  request.options = options;
  request.firstPoints = first;
  return sampleFarthest(solver, request);
}

/** What whole solves from the samples give: the field of all, and the distance of each sample from
 * those before. */
struct Truth
{
  std::vector<double> distances;
  std::vector<double> ofSamples;
  /** The largest distance when each sample was taken. */
  std::vector<double> farthest;
};

Truth truthOf(DistanceSolver& solver, const Sampling& sampling, const SolveOptions& options,
  std::size_t firstPoints = 0, std::span<const Seed> first = {})
{
  const TriangleMesh& mesh = solver.mesh();
  const ClosedTriangles closed(mesh, options.closedTriangles);
  Truth truth;
  truth.distances.assign(mesh.numberOfVertices(), Unreached);
  for (std::size_t i = 0; i < sampling.samples.size(); ++i)
  {
    const Index vertex = sampling.samples[i].vertex;
    truth.ofSamples.push_back(i < firstPoints ? Unreached : truth.distances[vertex]);
    double farthest = 0.0;
    for (Index v = 0; v < mesh.numberOfVertices(); ++v)
    {
      if (closed.hasOpenTriangle(v) && !options.isExcluded(v))
      {
        farthest = std::max(farthest, truth.distances[v]);
      }
    }
    truth.farthest.push_back(farthest);
    const Seed seed = i < firstPoints ? first[i] : Seed::atPoint(mesh.pointAtVertex(vertex));
    const DistanceField& field = solver.solve({ &seed, 1 }, options);
    for (Index v = 0; v < mesh.numberOfVertices(); ++v)
    {
      truth.distances[v] = std::min(truth.distances[v], field.distance(v));
    }
  }
  return truth;
}

/** Expects that two samplings took the same samples, and have the same field. */
void expectSame(const Sampling& a, const Sampling& b, double tolerance)
{
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i)
  {
    ASSERT_EQ(a.samples[i].vertex, b.samples[i].vertex) << "sample " << i;
    ASSERT_EQ(a.samples[i].position, b.samples[i].position) << "sample " << i;
  }
  ASSERT_NEAR(a.coveringRadius, b.coveringRadius, tolerance * a.coveringRadius);
  ASSERT_EQ(a.numberOfUnreached, b.numberOfUnreached);
  for (std::size_t v = 0; v < a.field.distances().size(); ++v)
  {
    const auto vertex = static_cast<Index>(v);
    ASSERT_EQ(a.field.isReached(vertex), b.field.isReached(vertex)) << "vertex " << v;
    if (a.field.isReached(vertex))
    {
      ASSERT_NEAR(a.field.distance(vertex), b.field.distance(vertex),
        tolerance * std::max(a.coveringRadius, a.field.distance(vertex)))
        << "vertex " << v;
    }
  }
}

/** Checks a sampling by the fields of whole solves. @param tolerance  in parts of the distance */
void expectTrue(DistanceSolver& solver, const Sampling& sampling, const SolveOptions& options,
  double tolerance, std::span<const Seed> first = {})
{
  const Truth truth = truthOf(solver, sampling, options, first.size(), first);
  for (std::size_t v = 0; v < truth.distances.size(); ++v)
  {
    const double found = sampling.field.distance(static_cast<Index>(v));
    if (std::isfinite(truth.distances[v]))
    {
      ASSERT_NEAR(found, truth.distances[v], tolerance * truth.distances[v]) << "vertex " << v;
    }
    else
    {
      ASSERT_FALSE(std::isfinite(found)) << "vertex " << v;
    }
  }
  for (std::size_t i = first.size(); i < sampling.samples.size(); ++i)
  {
    const double distance = sampling.samples[i].distance;
    if (!std::isfinite(truth.farthest[i]))
    {
      ASSERT_FALSE(std::isfinite(distance)) << "sample " << i;
      continue;
    }
    ASSERT_NEAR(truth.ofSamples[i], distance, (tolerance + 2e-9) * distance) << "sample " << i;
    ASSERT_NEAR(truth.farthest[i], distance, (tolerance + 2e-9) * distance) << "sample " << i;
    ASSERT_LE(distance, sampling.samples[i - 1].distance * (1.0 + 2e-9)) << "sample " << i;
  }
}

/** Counts the vertices that a solver's fronts reach. */
class CountingSolver final : public DistanceSolver
{
public:
  explicit CountingSolver(DistanceSolver& solver)
    : Solver(solver)
  {
  }
  const TriangleMesh& mesh() const override { return this->Solver.mesh(); }
  const DistanceField& solve(std::span<const Seed> seeds, const SolveOptions& options) override
  {
    const DistanceField& field = this->Solver.solve(seeds, options);
    this->Reached += field.reached().size();
    return field;
  }
  std::size_t reached() const { return this->Reached; }

private:
  DistanceSolver& Solver;
  std::size_t Reached = 0;
};

/** Adds a copy of a surface, moved. */
void append(Surface& surface, const Surface& part, const Vector3& by)
{
  const auto before = static_cast<Index>(surface.points.size());
  for (const Vector3& point : part.points)
  {
    surface.points.push_back(point + by);
  }
  for (const Triangle& t : part.triangles)
  {
    surface.triangles.push_back({ t[0] + before, t[1] + before, t[2] + before });
  }
}

void expectError(const std::function<void()>& call, const std::string& text)
{
  const std::string error = errorOf(call);
  EXPECT_NE(error.find(text), std::string::npos) << error;
}

/** How much a field may differ from that of whole solves, in parts of the distance. A bounded one
 * has that tolerance itself; fast marching misses, where fronts meet at a small angle, what lies
 * beyond its margin. */
double toleranceOf(const SolverTraits& traits)
{
  const std::string name = traits.name;
  return name == "Bounded" ? 1e-3 : name == "FastMarching" ? 1e-6 : 1e-9;
}

}

TEST(Sampling, IsThatOfWholeSolvesOnAPlane)
{
  const auto mesh = meshOf(delaunayPlane(3000, 7));
  FastMarchingSolver solver(mesh);
  const Sampling sampling = samplingOf(solver, 60);
  ASSERT_EQ(sampling.samples.size(), 60u);
  expectTrue(solver, sampling, {}, 1e-9);
  // On a convex plane distances are straight lines.
  for (Index v = 0; v < mesh->numberOfVertices(); ++v)
  {
    double least = Unreached;
    for (const Sample& sample : sampling.samples)
    {
      least = std::min(least, norm(sample.position - mesh->position(v)));
    }
    ASSERT_NEAR(sampling.field.distance(v), least, 1e-9);
    ASSERT_LE(least, sampling.coveringRadius * (1.0 + 1e-9));
    const Vector3& nearest = sampling.samples[sampling.field.nearestSeed(v)].position;
    ASSERT_NEAR(norm(nearest - mesh->position(v)), least, 1e-9);
  }
  // No two samples are closer than the last one was to the others.
  for (std::size_t i = 0; i < sampling.samples.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      ASSERT_GE(norm(sampling.samples[i].position - sampling.samples[j].position),
        sampling.samples.back().distance * (1.0 - 1e-8));
    }
  }
}

TEST(Sampling, IsThatOfWholeSolvesOnASphere)
{
  const auto mesh = meshOf(icosphere(4));
  FastMarchingSolver solver(mesh);
  expectTrue(solver, samplingOf(solver, 100), {}, 1e-9);
}

// Each method, on all kinds of random surfaces, with costs and barriers where it takes them.
TEST(Sampling, IsThatOfWholeSolvesOnRandomSurfaces)
{
  for (const SolverTraits& traits : solverTable())
  {
    if (!traits.isOffered)
    {
      continue;
    }
    for (unsigned number = 0; number < 24; ++number)
    {
      const RandomCase random = randomCase(number, { 1, traits.takesCosts, traits.takesBarriers });
      const auto solver = traits.make(random.mesh);
      SCOPED_TRACE(std::string(traits.name) + ", " + random.description());
      const Sampling sampling = samplingOf(*solver, 20, 0.0, random.options());
      ASSERT_EQ(sampling.samples.size(), 20u);
      expectTrue(*solver, sampling, random.options(), toleranceOf(traits));
    }
  }
}

TEST(Sampling, TakesFirstPointsFirst)
{
  const auto mesh = meshOf(delaunayPlane(2000, 3));
  FastMarchingSolver solver(mesh);
  std::vector<Seed> first;
  for (int i = 0; i < 8; ++i)
  {
    first.push_back(seedNear(mesh, { 0.01 + 0.12 * i, 0.3, 0.0 }));
  }
  const Sampling sampling = samplingOf(solver, 50, 0.0, {}, first);
  ASSERT_EQ(sampling.samples.size(), 50u);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(sampling.samples[i].position, mesh->positionOf(first[i].points[0]));
    EXPECT_EQ(sampling.samples[i].distance, Unreached);
    EXPECT_EQ(sampling.samples[i].vertex, NoIndex);
  }
  expectTrue(solver, sampling, {}, 1e-9, first);
}

TEST(Sampling, EndsAtTheSpacing)
{
  const auto mesh = meshOf(planeGrid(40, 30, 4.0, 3.0));
  FastMarchingSolver solver(mesh);
  const Sampling sampling = samplingOf(solver, 0, 0.35);
  EXPECT_LE(sampling.coveringRadius, 0.35);
  EXPECT_GT(sampling.samples.back().distance, 0.35);
  expectTrue(solver, sampling, {}, 1e-6);
  // Farther than the surface is large: one sample. Less than its edges: every point.
  EXPECT_EQ(samplingOf(solver, 0, 6.0).samples.size(), 1u);
  EXPECT_EQ(samplingOf(solver, 0, 1e-3).samples.size(), 41u * 31u);
  EXPECT_EQ(samplingOf(solver, 0, 1e-3).coveringRadius, 0.0);
}

TEST(Sampling, TakesAllPointsAndNoMore)
{
  const auto mesh = meshOf(planeGrid(8, 6, 4.0, 3.0));
  FastMarchingSolver solver(mesh);
  EXPECT_EQ(samplingOf(solver, 63).coveringRadius, 0.0);
  expectError([&] { samplingOf(solver, 64); }, "only 63 points");
}

TEST(Sampling, RefusesWhatItCannotTake)
{
  const auto mesh = meshOf(planeGrid(8, 6, 4.0, 3.0));
  FastMarchingSolver solver(mesh);
  expectError([&] { samplingOf(solver, 0); }, "Neither");
  expectError([&] { samplingOf(solver, 0, -1.0); }, "-1");
  expectError([&] { samplingOf(solver, 0, std::nan("")); }, "nan");
  const std::vector<Seed> first{ seedAt(*mesh, 0), seedAt(*mesh, 5) };
  expectError([&] { samplingOf(solver, 1, 0.0, {}, first); }, "2 first points");
}

TEST(Sampling, GivesEachPartASampleFirst)
{
  Surface parts;
  for (Index p = 0; p < 5; ++p)
  {
    append(parts, planeGrid(4, 4, 1.0, 1.0), { 2.0 * (4 - p), 0.0, 0.0 });
  }
  // Points without triangles are no part.
  parts.points.push_back({ -100.0, 0.0, 0.0 });
  const auto mesh = meshOf(parts);
  FastMarchingSolver solver(mesh);
  const Sampling sampling = samplingOf(solver, 8);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(std::isfinite(sampling.samples[i].distance), i >= 5) << i;
    if (i < 5)
    {
      EXPECT_EQ(sampling.samples[i].position, (Vector3{ 2.0 * i, 0.0, 0.0 }));
    }
  }
  EXPECT_EQ(samplingOf(solver, 3).numberOfUnreached, 50u);
  EXPECT_EQ(sampling.numberOfUnreached, 0u);
}

// 100,000 parts, and as many samples of one: neither may take quadratic time.
TEST(Sampling, TakesManyPartsAndSamples)
{
  Surface parts;
  for (Index p = 0; p < 100000; ++p)
  {
    append(parts, planeGrid(1, 1, 1.0, 1.0), { 2.0 * p, 0.0, 0.0 });
  }
  const auto ofParts = meshOf(parts);
  FastMarchingSolver solverOfParts(ofParts);
  EXPECT_EQ(samplingOf(solverOfParts, 100000).coveringRadius, std::sqrt(2.0));
  const auto ofGrid = meshOf(planeGrid(400, 400, 4.0, 4.0));
  FastMarchingSolver solverOfGrid(ofGrid);
  EXPECT_EQ(samplingOf(solverOfGrid, 100000).samples.size(), 100000u);
}

TEST(Sampling, CostsFewSolves)
{
  const auto mesh = meshOf(delaunayPlane(40000, 1));
  FastMarchingSolver solver(mesh);
  CountingSolver counting(solver);
  EXPECT_EQ(samplingOf(counting, 1000).samples.size(), 1000u);
  EXPECT_LT(static_cast<double>(counting.reached()), 12.0 * mesh->numberOfVertices());
  // First points do not cost more, however dense they are.
  std::vector<Seed> dense;
  for (Index triangle = 0; triangle < 20000; ++triangle)
  {
    dense.push_back(Seed::atPoint({ triangle, { 0.5, 0.25, 0.25 } }));
  }
  CountingSolver countingDense(solver);
  samplingOf(countingDense, 20000, 0.0, {}, dense);
  EXPECT_EQ(countingDense.reached(), mesh->numberOfVertices());
}

// On random surfaces of all kinds, with costs and barriers; also where points lie in rows, so that
// many are equally far.
TEST(Sampling, IsTheSameForAnyNumberOfThreads)
{
  const auto expectSameOnThreads = [](const SolverTraits& traits,
                                     const std::shared_ptr<const TriangleMesh>& mesh,
                                     const auto& request)
  {
    const auto onThreads = [&](std::size_t threads)
    {
      SolverTeam team;
      team.prepare(traits, mesh, threads);
      return sampleFarthest(team, request);
    };
    const Sampling ofOne = onThreads(1);
    for (const std::size_t threads : { 2, 8 })
    {
      expectSame(ofOne, onThreads(threads), 0.0);
    }
    // Bounded distances may differ by more, and then the samples do.
    if (std::string(traits.name) != "Bounded")
    {
      const auto solver = traits.make(mesh);
      expectSame(ofOne, sampleFarthest(*solver, request), toleranceOf(traits));
    }
  };
  for (const SolverTraits& traits : solverTable())
  {
    for (unsigned number = 0; number < 6 && traits.isOffered; ++number)
    {
      const RandomCase random = randomCase(number, { 1, traits.takesCosts, traits.takesBarriers });
      SCOPED_TRACE(std::string(traits.name) + ", " + random.description());
      SamplingRequest request;
      request.count = 40;
      request.options = random.options();
      expectSameOnThreads(traits, random.mesh, request);
    }
  }
  for (const Surface& surface :
    { planeGrid(60, 60, 6.0, 6.0), icosphere(4), delaunayPlane(5000, 2) })
  {
    SamplingRequest request;
    request.count = 700;
    expectSameOnThreads(solverOfName("FastMarching"), meshOf(surface), request);
  }
}

// However dear an edge is.
TEST(Sampling, LooksAsFarAheadWithCosts)
{
  const auto mesh = meshOf(delaunayPlane(5000, 1));
  FastMarchingSolver solver(mesh);
  const Sampling sampling = samplingOf(solver, 200);
  const std::vector<std::uint8_t> isOpen(mesh->numberOfVertices(), 1);
  std::vector<Index> atCostOne;
  for (const double factor : { 1.0, 1e-3, 1e3 })
  {
    std::vector<double> distances(
      sampling.field.distances().begin(), sampling.field.distances().end());
    std::for_each(distances.begin(), distances.end(), [&](double& d) { d *= factor; });
    const std::vector<double> cost(mesh->numberOfVertices(), factor);
    FarthestVertices farthest(*mesh, distances, isOpen);
    farthest.setLevel(farthest.farthest() * (1.0 - FarthestVertices::TiePart));
    const std::vector<Index> apart = farthest.apartFrom(farthest.firstAtLevel(), 50, cost);
    atCostOne = factor == 1.0 ? apart : atCostOne;
    EXPECT_EQ(apart, atCostOne);
    EXPECT_GT(apart.size(), 10u);
    EXPECT_LE(apart.size(), 50u);
  }
}

// Marches of vertices that become no samples would be work for nothing.
TEST(Sampling, MarchesAheadFromFewVerticesForNothing)
{
  const auto mesh = meshOf(delaunayPlane(20000, 1));
  FastMarchingSolver solver(mesh);
  const Sampling sampling = samplingOf(solver, 500);
  const std::vector<std::uint8_t> isOpen(mesh->numberOfVertices(), 1);
  FarthestVertices farthest(*mesh, sampling.field.distances(), isOpen);
  farthest.setLevel(farthest.farthest() * (1.0 - 1e-9));
  const std::vector<Index> apart = farthest.apartFrom(farthest.firstAtLevel(), 64);
  ASSERT_GT(apart.size(), 32u);
  std::set<Index> taken;
  for (const Sample& sample : samplingOf(solver, 700).samples)
  {
    taken.insert(sample.vertex);
  }
  const auto used =
    std::count_if(apart.begin(), apart.end(), [&](Index vertex) { return taken.contains(vertex); });
  EXPECT_GT(used, static_cast<std::ptrdiff_t>(apart.size() * 9 / 10));
}

TEST(Sampling, IsCancelledOnThreads)
{
  const auto mesh = meshOf(icosphere(5));
  SolverTeam team;
  team.prepare(solverOfName("FastMarching"), mesh, 2);
  SamplingRequest request;
  request.count = 500;
  int reports = 0;
  request.onProgress = [&](double part)
  {
    EXPECT_LE(part, 1.0);
    return ++reports < 60;
  };
  EXPECT_TRUE(sampleFarthest(team, request).isCancelled);
  EXPECT_LT(reports, 70);
  // The next run is whole.
  request.onProgress = {};
  FastMarchingSolver solver(mesh);
  expectSame(samplingOf(solver, 500), sampleFarthest(team, request), 1e-9);
}

// Each thread has its part of the memory; what needs more is marched again alone, with all of it.
TEST(Sampling, NeedsNoMoreMemoryOnThreads)
{
  const auto mesh = meshOf(icosphere(4));
  const SolverTraits& exact = solverOfName("Exact");
  SamplingRequest request;
  // With so many the last marches are short, and made one by one again.
  request.count = 600;
  const auto solver = exact.make(mesh);
  const auto isEnough = [&](std::size_t limit)
  {
    request.options.memoryLimit = limit;
    try
    {
      sampleFarthest(*solver, request);
      return true;
    }
    catch (const std::exception&)
    {
      return false;
    }
  };
  std::size_t limit = 1 << 16;
  while (!isEnough(limit))
  {
    limit += limit / 4;
  }
  // A third of it is too little, and what is marched ahead needs a little more.
  limit += limit / 4;
  request.options.memoryLimit = limit;
  SolverTeam team;
  team.prepare(exact, mesh, 3);
  const Sampling alone = sampleFarthest(*solver, request);
  expectSame(alone, sampleFarthest(team, request), 1e-9);
}
