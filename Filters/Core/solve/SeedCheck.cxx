// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/SeedCheck.h"

#include "base/NumberText.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic
{
namespace
{

/** How messages call a seed. */
std::string nameOf(std::size_t number)
{
  return "Seed " + std::to_string(number);
}

/** @param seed  its number */
void checkPoint(const TriangleMesh& mesh, const SurfacePoint& point, std::size_t seed)
{
  const auto& weights = point.weights;
  const double sum = weights[0] + weights[1] + weights[2];
  const bool inside =
    std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0.0; });
  if (point.triangle >= mesh.numberOfTriangles())
  {
    throw std::invalid_argument(nameOf(seed) + " lies in triangle " +
      std::to_string(point.triangle) + ", but the mesh has " +
      std::to_string(mesh.numberOfTriangles()) + " triangles.");
  }
  if (!inside || !(std::abs(sum - 1.0) < 1e-6))
  {
    throw std::invalid_argument(nameOf(seed) + " has barycentric weights " + textOf(weights[0]) +
      ", " + textOf(weights[1]) + ", " + textOf(weights[2]) +
      "; each must be at least 0 and their sum 1.");
  }
}

void checkCurve(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points, std::size_t seed)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Carriers carriers = carriersOf(mesh, points[i], points[i + 1]);
    if (carriers.size() > 3 || !mesh.hasTriangleWith({ carriers.begin(), carriers.end() }))
    {
      throw std::invalid_argument(nameOf(seed) + " is a curve whose segment " + std::to_string(i) +
        " lies neither in one face nor along one edge of the surface. Give it a point on each edge "
        "that it crosses.");
    }
  }
}

void checkSeed(const TriangleMesh& mesh, const Seed& seed, std::size_t number, bool mayBeElsewhere)
{
  if (seed.points.empty() && seed.vertices.empty() && !mayBeElsewhere)
  {
    throw std::invalid_argument(nameOf(number) + " has no point.");
  }
  if (!(seed.value >= 0.0 && std::isfinite(seed.value)))
  {
    throw std::invalid_argument(nameOf(number) + " has the value " + textOf(seed.value) +
      "; it must be finite and at least 0.");
  }
  for (const SurfacePoint& point : seed.points)
  {
    checkPoint(mesh, point, number);
  }
  for (Index vertex : seed.vertices)
  {
    if (vertex >= mesh.numberOfVertices())
    {
      throw std::invalid_argument(nameOf(number) + " has vertex " + std::to_string(vertex) +
        ", but the mesh has " + std::to_string(mesh.numberOfVertices()) + " vertices.");
    }
  }
  if (seed.kind == Seed::Kind::Curve)
  {
    checkCurve(mesh, seed.points, number);
  }
}

}

void checkSeeds(const TriangleMesh& mesh, std::span<const Seed> seeds, const Partition& partition)
{
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    checkSeed(mesh, seeds[s], s, partition.isDivided());
  }
}

}
