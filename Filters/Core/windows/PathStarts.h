// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathStarts_h
#define geodesic_PathStarts_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "mesh/SurfacePoint.h"
#include "solve/DistanceField.h"
#include "windows/Arrival.h"

#include <map>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace geodesic
{

class EdgeTable;
class TriangleMesh;

/**
 * Points inside faces and edges from which paths are wanted, with the least distance of each that a
 * front of windows has found so far. Those of a triangle are looked up by its number. Memory: some
 * 200 bytes for each of them.
 */
class PathStarts
{
public:
  /** A point, and the shortest path found so far. */
  struct Start
  {
    Vector3 position;
    double distance = DistanceField::Unreached;
    Index seed = NoIndex;
    Arrival arrival;
  };

  /** Forgets all points and takes others; those at vertices are left out. */
  void set(const TriangleMesh& mesh, const EdgeTable& edges, std::span<const SurfacePoint> points);

  bool isEmpty() const { return this->Starts.empty(); }

  /** The shortest path to a point that was given to set(), and is no vertex; null for any other. */
  const Start* find(const SurfacePoint& point) const;

  /** Calls @p visit with each point of a triangle. Of triangles with the same corners only the
   * first has points. */
  template <class Visit>
  void visitIn(Index triangle, const Visit& visit)
  {
    if (this->Starts.empty())
    {
      return;
    }
    if (const auto found = this->ByTriangle.find(triangle); found != this->ByTriangle.end())
    {
      for (const Index number : found->second)
      {
        visit(this->Starts[number]);
      }
    }
  }

  /** Notes a path to a point if it is shorter. */
  static void reach(Start& start, double distance, Index seed, const Arrival& arrival)
  {
    if (distance < start.distance)
    {
      start.distance = distance;
      start.seed = seed;
      start.arrival = arrival;
    }
  }

private:
  /** A triangle and the weights in it. */
  using Key = std::tuple<Index, double, double, double>;
  static Key keyOf(const SurfacePoint& point)
  {
    return { point.triangle, point.weights[0], point.weights[1], point.weights[2] };
  }

  std::vector<Start> Starts;
  std::map<Key, Index> ByPoint;
  std::unordered_map<Index, std::vector<Index>> ByTriangle;
};

}

#endif
