// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Every option of vtkFastMarchingGeodesicDistance alone and with every other, on a square whose
// truth is a formula and on the Bunny against exact polyhedral distances.

#include "ExactDistances.h"
#include "Inputs.h"

#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace geodesic::testing;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/** A surface, seeds and destinations on it, and the true distances at cost 1. */
struct Scene
{
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<vtkIdType> seeds;
  std::vector<vtkIdType> destinations;
  /** One row of distances a seed, -1 where there is none. */
  std::vector<std::vector<double>> truths;
  double distanceStop;
  /** What a distance may differ by, relative to the largest. */
  double tolerance;
};

Scene squareScene()
{
  Scene scene{ square(24), { 310, 4, 600 }, { 312, 20 }, {}, 7.3, 1e-9 };
  for (vtkIdType seed : scene.seeds)
  {
    auto& row = scene.truths.emplace_back();
    for (vtkIdType i = 0; i < scene.surface->GetNumberOfPoints(); ++i)
    {
      row.push_back(distanceBetween(scene.surface, i, seed));
    }
  }
  return scene;
}

Scene bunnyScene()
{
  Scene scene{ readData("Bunny.vtp"), { 1000, 20000 }, { 1500, 30000 }, {}, 0.05, 1.5e-2 };
  Surface surface;
  for (vtkIdType i = 0; i < scene.surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    scene.surface->GetPoint(i, p);
    surface.points.push_back({ p[0], p[1], p[2] });
  }
  for (vtkIdType cell = 0; cell < scene.surface->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    scene.surface->GetCellPoints(cell, corners);
    surface.triangles.push_back({ static_cast<geodesic::Index>(corners->GetId(0)),
      static_cast<geodesic::Index>(corners->GetId(1)),
      static_cast<geodesic::Index>(corners->GetId(2)) });
  }
  for (vtkIdType seed : scene.seeds)
  {
    scene.truths.push_back(exactDistances(surface, { static_cast<geodesic::Index>(seed) }));
  }
  return scene;
}

struct Options
{
  std::size_t seeds;
  double cost;
  bool stopsAtDistance;
  enum
  {
    None,
    Any,
    All
  } destinations;
  bool excludes;
};

std::vector<Options> allOptions(const Scene& scene)
{
  std::vector<Options> all;
  for (std::size_t seeds = 1; seeds <= scene.seeds.size(); ++seeds)
  {
    for (double cost : { 1.0, 2.5 })
    {
      for (bool stops : { false, true })
      {
        for (auto destinations : { Options::None, Options::Any, Options::All })
        {
          for (bool excludes : { false, true })
          {
            all.push_back({ seeds, cost, stops, destinations, excludes });
          }
        }
      }
    }
  }
  return all;
}

void check(const Scene& scene, const Options& options)
{
  const vtkIdType count = scene.surface->GetNumberOfPoints();
  // Where nothing is excluded the truth is known; the one excluded point is the farthest from the
  // seeds, which is on nobody's way.
  std::vector<double> truth(count, Infinity);
  for (std::size_t s = 0; s < options.seeds; ++s)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double d = scene.truths[s][i];
      truth[i] = d < 0.0 ? truth[i] : std::min(truth[i], d * options.cost);
    }
  }
  vtkIdType farthest = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    farthest = truth[i] < Infinity && truth[i] > truth[farthest] ? i : farthest;
  }
  const double largest = truth[farthest];

  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(scene.surface);
  filter->SetFieldDataName("d");
  filter->SetNearestSeedArrayName("seed");
  vtkNew<vtkIdList> seeds;
  for (std::size_t s = 0; s < options.seeds; ++s)
  {
    seeds->InsertNextId(scene.seeds[s]);
  }
  filter->SetSeeds(seeds);
  double limit = Infinity;
  if (options.cost != 1.0)
  {
    vtkNew<vtkDoubleArray> weights;
    weights->SetNumberOfTuples(count);
    weights->Fill(options.cost);
    filter->SetPropagationWeights(weights);
  }
  if (options.stopsAtDistance)
  {
    filter->SetDistanceStopCriterion(scene.distanceStop);
    limit = scene.distanceStop;
  }
  if (options.destinations != Options::None)
  {
    vtkNew<vtkIdList> destinations;
    const bool isAny = options.destinations == Options::Any;
    double reached = isAny ? Infinity : 0.0;
    for (vtkIdType id : scene.destinations)
    {
      destinations->InsertNextId(id);
      reached = isAny ? std::min(reached, truth[id]) : std::max(reached, truth[id]);
    }
    filter->SetDestinationVertexStopCriterion(destinations);
    filter->SetDestinationStopMode(isAny ? vtkFastMarchingGeodesicDistance::ANY_DESTINATION
                                         : vtkFastMarchingGeodesicDistance::ALL_DESTINATIONS);
    limit = std::min(limit, reached);
  }
  if (options.excludes)
  {
    filter->SetExclusionPointIds(idList({ farthest }));
  }

  ASSERT_EQ(errorsOf(filter.Get()), "");
  vtkDataArray* d = filter->GetOutput()->GetPointData()->GetArray("d");
  vtkDataArray* seed = filter->GetOutput()->GetPointData()->GetArray("seed");
  const double tolerance = scene.tolerance * largest;
  vtkIdType visited = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = d->GetComponent(i, 0);
    const bool isReached = value != -1.0;
    visited += isReached;
    ASSERT_EQ(seed->GetComponent(i, 0) >= 0.0, isReached);
    if (options.excludes && i == farthest)
    {
      ASSERT_FALSE(isReached);
    }
    else if (truth[i] > limit + tolerance || truth[i] == Infinity)
    {
      ASSERT_FALSE(isReached) << "point " << i << " at " << truth[i] << ", limit " << limit;
    }
    else if (truth[i] < limit - tolerance)
    {
      ASSERT_NEAR(value, truth[i], tolerance) << "point " << i;
      const double toSeed =
        scene.truths[static_cast<std::size_t>(seed->GetComponent(i, 0))][i] * options.cost;
      ASSERT_NEAR(toSeed, truth[i], 2.0 * tolerance) << "point " << i;
    }
  }
  EXPECT_EQ(filter->GetNumberOfVisitedPoints(), visited);
  EXPECT_LE(filter->GetMaximumDistance(), std::min(limit, largest) + tolerance);
}

void checkAll(const Scene& scene)
{
  for (const Options& options : allOptions(scene))
  {
    SCOPED_TRACE("seeds " + std::to_string(options.seeds) + ", cost " +
      std::to_string(options.cost) + ", distance stop " + std::to_string(options.stopsAtDistance) +
      ", destinations " + std::to_string(options.destinations) + ", exclusion " +
      std::to_string(options.excludes));
    check(scene, options);
  }
}

}

TEST(Options, AloneAndCombinedOnASquare)
{
  checkAll(squareScene());
}

// First order: 1.5 % of the largest distance at the worst point, 0.25 % on average.
TEST(Options, AloneAndCombinedOnTheBunny)
{
  checkAll(bunnyScene());
}
