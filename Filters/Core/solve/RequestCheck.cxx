// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/RequestCheck.h"

#include "base/NumberText.h"
#include "base/SortUnique.h"
#include "base/WorkCount.h"
#include "mesh/Carriers.h"
#include "mesh/TriangleMesh.h"
#include "solve/ClosedTriangles.h"
#include "solve/Partition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

void checkSize(const char* what, std::size_t size, std::size_t expected, const char* of)
{
  if (size != 0 && size != expected)
  {
    throw std::invalid_argument(std::string(what) + " has " + std::to_string(size) +
      " entries, but the mesh has " + std::to_string(expected) + " " + of + ".");
  }
}

/** Beyond these, squares of distances overflow on the largest and smallest surfaces. */
constexpr double LeastCost = 1e-30;
constexpr double MostCost = 1e30;

void checkCost(const TriangleMesh& mesh, std::span<const double> cost)
{
  Index firstBad = NoIndex;
  Index vertex = 0;
  for (Index v = 0; v < cost.size(); ++v)
  {
    if (!(cost[v] >= LeastCost && cost[v] <= MostCost) && mesh.pointOfVertex(v) < firstBad)
    {
      firstBad = mesh.pointOfVertex(v);
      vertex = v;
    }
  }
  if (firstBad != NoIndex)
  {
    throw std::invalid_argument("The cost of point " + std::to_string(firstBad) + " is " +
      textOf(cost[vertex]) + "; every cost must be positive and finite, between " +
      textOf(LeastCost) + " and " + textOf(MostCost) + ".");
  }
}

/** Calls @p visit with each point of the seeds on this piece, and the number of its seed. */
template <class Visit>
void visitPoints(const TriangleMesh& mesh, std::span<const Seed> seeds, Visit&& visit)
{
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    for (const SurfacePoint& point : seeds[s].points)
    {
      visit(point, s);
    }
    for (Index vertex : seeds[s].vertices)
    {
      // The triangles of a vertex can all be on other pieces.
      if (!mesh.ring(vertex).empty())
      {
        visit(mesh.pointAtVertex(vertex), s);
      }
    }
  }
}

/** The vertices that carry seeds and have an open triangle on at least one piece, in ascending
 * order. Collective. */
std::vector<Index> openCarriers(const TriangleMesh& mesh, std::span<const Seed> seeds,
  const ClosedTriangles& closed, Partition& partition)
{
  std::vector<Index> open;
  visitPoints(mesh, seeds,
    [&](const SurfacePoint& point, std::size_t)
    {
      const Carriers ofPoint = carriersOf(mesh, point);
      open.insert(open.end(), ofPoint.begin(), ofPoint.end());
    });
  sortUnique(open);
  std::erase_if(open, [&](Index vertex) { return !closed.hasOpenTriangle(vertex); });
  std::vector<StartValue> own;
  own.reserve(open.size());
  for (Index vertex : open)
  {
    own.push_back({ vertex, 0, 0.0, false });
  }
  for (const StartValue& other : partition.exchange(own))
  {
    open.push_back(other.vertex);
  }
  sortUnique(open);
  return open;
}

/** Whether the triangle of three corners is closed, or another one with the same corners. */
bool isClosed(const TriangleMesh& mesh, const ClosedTriangles& closed, Triangle corners)
{
  // Round the vertex of the fewest triangles: fans can be large, and seeds many.
  const auto fewest = std::min_element(corners.begin(), corners.end(),
    [&](Index a, Index b) { return mesh.ring(a).size() < mesh.ring(b).size(); });
  std::swap(corners[0], *fewest);
  const std::span<const RingEntry> ring = mesh.ring(corners[0]);
  WorkCount::add(ring.size());
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    const Index a = ring[i].neighbour();
    const Index b = ring[i + 1].neighbour();
    if (ring[i].opensTriangle() && !closed.isOpen(corners[0], i) &&
      ((a == corners[1] && b == corners[2]) || (a == corners[2] && b == corners[1])))
    {
      return true;
    }
  }
  return false;
}

/** Throws where a front can't leave the point. @param seed  its number @param open  see
 * openCarriers() */
void checkPointIsOpen(const TriangleMesh& mesh, const SurfacePoint& point, std::size_t seed,
  const SolveOptions& options, const ClosedTriangles& closed, std::span<const Index> open)
{
  const Carriers carriers = carriersOf(mesh, point);
  const auto excluded = std::find_if(
    carriers.begin(), carriers.end(), [&](Index vertex) { return options.isExcluded(vertex); });
  const bool allExcluded = std::all_of(
    carriers.begin(), carriers.end(), [&](Index vertex) { return options.isExcluded(vertex); });
  if (allExcluded)
  {
    throw std::invalid_argument("Seed " + std::to_string(seed) + " is at point " +
      std::to_string(mesh.pointOfVertex(*excluded)) +
      ", which is on a barrier. Move it off the barrier.");
  }
  const bool isInside =
    carriers.size() == 3 && isClosed(mesh, closed, mesh.triangle(point.triangle));
  const bool isSurrounded = std::none_of(carriers.begin(), carriers.end(),
    [&](Index vertex) { return std::binary_search(open.begin(), open.end(), vertex); });
  if (isInside || isSurrounded)
  {
    throw std::invalid_argument("Seed " + std::to_string(seed) +
      " lies inside a barrier cell, beside point " +
      std::to_string(mesh.pointOfVertex(carriers[0])) + "; move it off the barrier.");
  }
}

}

void checkSurface(const TriangleMesh& mesh, const SolveOptions& options)
{
  checkSize("The cost", options.cost.size(), mesh.numberOfVertices(), "vertices");
  checkSize(
    "The mask of excluded vertices", options.excluded.size(), mesh.numberOfVertices(), "vertices");
  checkSize("The mask of closed triangles", options.closedTriangles.size(),
    mesh.numberOfTriangles(), "triangles");
  checkCost(mesh, options.cost);
}

void checkOptions(const TriangleMesh& mesh, const SolveOptions& options)
{
  checkSize(
    "The useful distances", options.usefulBelow.size(), mesh.numberOfVertices(), "vertices");
  if (!(options.maximumDistance >= 0.0))
  {
    throw std::invalid_argument(
      "The maximum distance is " + textOf(options.maximumDistance) + "; it must be at least 0.");
  }
  if (!(options.tolerance > 0.0))
  {
    throw std::invalid_argument(
      "The tolerance is " + textOf(options.tolerance) + "; it must be above 0.");
  }
  for (const Triangle& target : options.targets)
  {
    for (Index vertex : target)
    {
      const bool isElsewhere = options.partition && vertex == NoIndex;
      if (vertex >= mesh.numberOfVertices() && !isElsewhere)
      {
        throw std::invalid_argument("Target vertex " + std::to_string(vertex) +
          " does not exist; the mesh has " + std::to_string(mesh.numberOfVertices()) +
          " vertices.");
      }
    }
  }
}

void checkSeedsAreOpen(const TriangleMesh& mesh, std::span<const Seed> seeds,
  const SolveOptions& options, const ClosedTriangles& closed, Partition& partition)
{
  if (!partition.isDivided() && options.excluded.empty() && options.closedTriangles.empty())
  {
    return;
  }
  const std::vector<Index> open = openCarriers(mesh, seeds, closed, partition);
  partition.together(
    [&]
    {
      visitPoints(mesh, seeds,
        [&](const SurfacePoint& point, std::size_t s)
        { checkPointIsOpen(mesh, point, s, options, closed, open); });
    });
}

}
