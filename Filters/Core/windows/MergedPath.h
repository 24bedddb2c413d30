// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MergedPath_h
#define geodesic_MergedPath_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "mesh/SurfacePoint.h"
#include "windows/Arrival.h"

#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

namespace geodesic
{

class DistanceField;
class EdgeTable;
class KeptWindows;
class PassableTriangles;
class TriangleMesh;

/**
 * Follows a path back from a point to its seed through windows that were merged.
 *
 * The source of a merged window is not where the paths come from, so a path can't be a straight
 * line to it. But each window carries a bound of the length of paths to its points, its distance
 * and its excess. The path goes from edge to edge, each time to the window, vertex or seed from
 * which that bound is least. A window came from one of these, or was merged from windows that did,
 * and its excess counts what was lost; so with each step the bound falls by the step's length at
 * least, and the path is no longer than the bound at its start. Time linear in the number of its
 * steps and of the windows beside them.
 */
class MergedPath
{
public:
  /** @param bounds    at the vertices: distances with their excess
   * @param seeds      the seeds' points, by their numbers
   * @param values     at the seeds, by their numbers
   * @param arrivals   of all vertices: how paths as long as the bounds come there
   * All arguments must live as long as this. Time linear in the number of seeds. */
  MergedPath(const TriangleMesh& mesh, const EdgeTable& edges, const PassableTriangles& passable,
    const KeptWindows& kept, const DistanceField& bounds, std::span<const SurfacePoint> seeds,
    std::span<const double> values, std::span<const Arrival> arrivals);

  /**
   * Traces from a point to which a path comes as @p arrival says.
   * @return the points of the path, with both ends; empty if rounding led it astray
   */
  std::vector<SurfacePoint> from(const SurfacePoint& start, const Arrival& arrival) const;

private:
  /** How the path comes to a point of an edge of whose half-edge a window has crossed. */
  Arrival before(Index halfEdge, const Vector3& position) const;

  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  const PassableTriangles& Passable;
  const KeptWindows& Kept;
  const DistanceField& Bounds;
  std::span<const SurfacePoint> Seeds;
  std::span<const double> Values;
  std::span<const Arrival> Arrivals;
  /** The seeds on each triangle, but those at vertices. */
  std::unordered_map<Index, std::vector<Index>> SeedsOn;
};

}

#endif
