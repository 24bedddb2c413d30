// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/WeightedMesh.h"

#include "solve/Partition.h"

#include <limits>

namespace geodesic
{
namespace
{

/** The least cost of the open faces in which both points lie. */
double leastCostBetween(const WeightedMesh& surface, const PathPoint& a, const PathPoint& b)
{
  // The point with more carriers lies in fewer faces.
  const bool isFirst = a.carriers().size() >= b.carriers().size();
  const PathPoint& inFewer = isFirst ? a : b;
  const PathPoint& other = isFirst ? b : a;
  double least = std::numeric_limits<double>::infinity();
  visitFaces(surface, inFewer,
    [&](const Triangle& face)
    {
      if (liesIn(other, face))
      {
        least = std::min(least, surface.costOf(face));
      }
    });
  return least;
}

}

const Detours& WeightedMesh::foundDetours() const
{
  if (!this->FoundDetours)
  {
    const std::span<const double> cost = this->Options.cost;
    double largestJump = 1.0;
    for (Index vertex = 0; vertex < this->Mesh.numberOfVertices(); ++vertex)
    {
      for (const RingEntry& entry : this->Mesh.ring(vertex))
      {
        largestJump = std::max(largestJump, cost[entry.neighbour()] / cost[vertex]);
      }
    }
    Partition onePiece;
    this->FoundDetours = Detours::mayBypass(largestJump)
      ? Detours(
          this->Mesh, this->Mesh.rings().longestSides(), this->Closed, this->Options, onePiece)
      : Detours();
  }
  return *this->FoundDetours;
}

double costOf(const WeightedMesh& surface, const SurfacePath& path)
{
  if (!surface.hasCosts())
  {
    return lengthOf(surface.mesh(), path);
  }
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const double length =
      norm(path[i].position(surface.mesh()) - path[i - 1].position(surface.mesh()));
    cost += length > 0.0 ? length * leastCostBetween(surface, path[i - 1], path[i]) : 0.0;
  }
  return cost;
}

}
