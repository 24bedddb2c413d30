// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/EdgePathSearch.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

namespace geodesic
{
namespace
{

/** Being shorter by less than this part is rounding. */
constexpr double LeastGain = 1e-12;

/** A vertex on its way back to the search's start. */
struct Visit
{
  /** Length from the start. */
  double length;
  /** The vertex before, NoIndex for the start. */
  Index previous;
};

struct Trial
{
  /** Least length of a path through the vertex. */
  double bound;
  double length;
  Index vertex;

  friend bool operator>(const Trial& a, const Trial& b) { return a.bound > b.bound; }
};

/** Calls @p visit with each open vertex that a path along edges goes to from a point, or comes
 * from. */
template <class Visitor>
void visitEdgeEnds(const WeightedMesh& weighted, const PathPoint& point, Visitor&& visit)
{
  if (isVertex(point))
  {
    visit(point.carriers()[0]);
    return;
  }
  visitFaces(weighted, point,
    [&](const Triangle& face)
    {
      for (Index corner : face)
      {
        if (!weighted.isExcluded(corner))
        {
          visit(corner);
        }
      }
    });
}

}

std::optional<SurfacePath> shorterEdgePath(const WeightedMesh& weighted, const DistanceField& field,
  const PathPoint& from, const PathPoint& to, double length)
{
  const TriangleMesh& mesh = weighted.mesh();
  const Vector3 start = to.position(mesh);
  const Vector3 end = from.position(mesh);
  // Where the path along edges leaves the mesh's vertices for `from`.
  std::unordered_map<Index, double> lastSteps;
  visitEdgeEnds(
    weighted, from, [&](Index vertex) { lastSteps[vertex] = norm(mesh.position(vertex) - end); });

  double best = length * (1.0 - LeastGain);
  Index last = NoIndex;
  std::unordered_map<Index, Visit> visits;
  std::priority_queue<Trial, std::vector<Trial>, std::greater<>> queue;
  const auto propose = [&](Index vertex, double way, Index previous)
  {
    const double left = std::min(field.distance(vertex), field.largestDistance());
    const auto known = visits.find(vertex);
    if (way + left < best && (known == visits.end() || way < known->second.length))
    {
      visits[vertex] = { way, previous };
      queue.push({ way + left, way, vertex });
    }
  };
  visitEdgeEnds(weighted, to,
    [&](Index vertex) { propose(vertex, norm(mesh.position(vertex) - start), NoIndex); });
  while (!queue.empty() && queue.top().bound < best)
  {
    const Trial trial = queue.top();
    queue.pop();
    if (trial.length > visits.at(trial.vertex).length)
    {
      continue;
    }
    const auto lastStep = lastSteps.find(trial.vertex);
    if (lastStep != lastSteps.end() && trial.length + lastStep->second < best)
    {
      best = trial.length + lastStep->second;
      last = trial.vertex;
    }
    const std::span<const RingEntry> ring = weighted.ring(trial.vertex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Index neighbour = ring[i].neighbour();
      if (weighted.isOpenEdge(trial.vertex, i) && !weighted.isExcluded(neighbour))
      {
        propose(neighbour,
          trial.length + norm(mesh.position(neighbour) - mesh.position(trial.vertex)),
          trial.vertex);
      }
    }
  }
  if (last == NoIndex)
  {
    return std::nullopt;
  }
  SurfacePath path{ from };
  for (Index vertex = last; vertex != NoIndex; vertex = visits.at(vertex).previous)
  {
    path.push_back(PathPoint::atVertex(vertex));
  }
  path.push_back(to);
  return path;
}

}
