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

/** A path counts as shorter if it is so by more than this part of its length; less is rounding. */
constexpr double LeastSaving = 1e-12;

/** The shortest path found so far from the search's start to a vertex. */
struct Visit
{
  /** The length of the path. */
  double length;
  /** The vertex before; NoIndex if the path comes straight from the start. */
  Index previous;
};

/** A vertex that waits in the search's queue. */
struct Trial
{
  /** A lower bound of the length of a path through the vertex. */
  double bound;
  /** The length from the start. */
  double length;
  Index vertex;

  friend bool operator>(const Trial& a, const Trial& b) { return a.bound > b.bound; }
};

/** Calls @p visit with each vertex to which a path along edges can go from a point in one step: the
 * point's own vertex, or the corners of the open faces in which it lies, but no excluded ones. */
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
  // The search begins at `to`. Vertices next to `from`, with the length of the last step from
  // there.
  std::unordered_map<Index, double> lastSteps;
  visitEdgeEnds(
    weighted, from, [&](Index vertex) { lastSteps[vertex] = norm(mesh.position(vertex) - end); });

  double best = length * (1.0 - LeastSaving);
  Index last = NoIndex;
  std::unordered_map<Index, Visit> visits;
  std::priority_queue<Trial, std::vector<Trial>, std::greater<>> queue;
  const auto propose = [&](Index vertex, double lengthSoFar, Index previous)
  {
    // What a march towards `to` has left out is no nearer than this to `from`.
    const double leftOut = field.largestDistance() -
      (field.leavesOutElsewhere() ? norm(mesh.position(vertex) - start) : 0.0);
    const double left = std::min(field.distance(vertex), leftOut);
    const auto known = visits.find(vertex);
    if (lengthSoFar + left < best && (known == visits.end() || lengthSoFar < known->second.length))
    {
      visits[vertex] = { lengthSoFar, previous };
      queue.push({ lengthSoFar + left, lengthSoFar, vertex });
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
    weighted.countSteps(ring.size());
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
