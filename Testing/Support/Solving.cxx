// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solving.h"

#include "march/FastMarchingSolver.h"
#include "march/LabelDensity.h"
#include "march/UpdateBounds.h"
#include "search/ClosestPointTree.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <cmath>

namespace geodesic::testing
{

std::shared_ptr<const TriangleMesh> meshOf(const Surface& surface, CoincidentPoints coincident)
{
  return std::make_shared<const TriangleMesh>(
    surface.points, surface.triangles, coincident, ThreadTeam(), &updateMeasurer());
}

Seed seedAt(const TriangleMesh& mesh, Index point)
{
  return Seed::atPoint(mesh.pointAtVertex(mesh.vertexOfPoint(point)));
}

SurfacePoint pointNear(const std::shared_ptr<const TriangleMesh>& mesh, const Vector3& position)
{
  return ClosestPointTree(mesh).closestPoint(position).point;
}

Seed seedNear(const std::shared_ptr<const TriangleMesh>& mesh, const Vector3& position)
{
  return Seed::atPoint(pointNear(mesh, position));
}

std::vector<double> straightLines(const Surface& surface, const Vector3& source)
{
  std::vector<double> truth;
  for (const Vector3& p : surface.points)
  {
    truth.push_back(norm(p - source));
  }
  return truth;
}

bool areDense(const TriangleMesh& mesh, const std::vector<Seed>& seeds)
{
  Partition whole;
  SeedFront front;
  makeSeedFront(mesh, ClosedTriangles(mesh, {}), seeds, false, goesOn, whole, front);
  return labelsAreDense(mesh, front, false, whole);
}

double largestOf(const std::vector<double>& distances)
{
  double largest = 0.0;
  for (const double d : distances)
  {
    largest = std::isfinite(d) ? std::max(largest, d) : largest;
  }
  return largest;
}

Error relativeError(const std::vector<double>& distances, const std::vector<double>& truth)
{
  Error error;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    if (truth[i] > 0.0)
    {
      const double e = std::abs(distances[i] - truth[i]) / truth[i];
      error.mean += e;
      error.largest = std::max(error.largest, e);
      ++counted;
    }
  }
  error.mean /= static_cast<double>(counted);
  return error;
}

DifferenceToLeast differenceToLeast(const std::shared_ptr<const TriangleMesh>& mesh,
  const std::vector<Seed>& seeds, const SolveOptions& options)
{
  FastMarchingSolver solver(mesh);
  const auto found = solver.solve(seeds, options).distances();
  const std::vector<double> together(found.begin(), found.end());
  const double unit = mesh->meanLongestEdge() *
    (options.cost.empty() ? 1.0 : *std::max_element(options.cost.begin(), options.cost.end()));
  // What is farther from a seed is not the least.
  SolveOptions near = options;
  near.maximumDistance = std::min(options.maximumDistance, largestOf(together) + unit);
  std::vector<double> least(together.size(), DistanceField::Unreached);
  for (const Seed& seed : seeds)
  {
    const DistanceField& alone = solver.solve({ &seed, 1 }, near);
    for (const Index vertex : alone.reached())
    {
      least[vertex] = std::min(least[vertex], alone.distance(vertex));
    }
  }
  DifferenceToLeast difference;
  for (std::size_t i = 0; i < least.size(); ++i)
  {
    if (together[i] != least[i])
    {
      const double edges = std::abs(together[i] - least[i]) / unit;
      difference.mean += edges / static_cast<double>(least.size());
      difference.largest = std::max(difference.largest, edges);
    }
  }
  return difference;
}

}
