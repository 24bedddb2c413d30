// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ClosestPointTree_h
#define geodesic_ClosestPointTree_h

#include "base/Vector3.h"
#include "mesh/SurfacePoint.h"
#include "search/BvhBounds.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Finds the point of a surface that is nearest to a point in space or first on a ray, on faces, not
 * only at vertices.
 *
 * The triangles of a TriangleMesh already follow a space filling curve, so consecutive ones lie
 * together: a hierarchy of bounds over runs of them needs no sorting. A run is cut where the curve
 * jumps farthest (see BvhSplit), so that its parts lie in one place each, and is bounded by a box
 * and by a flat cylinder (see BvhBounds): boxes alone would tell little wherever the surface is
 * smooth and much of it is nearly as near as its nearest point. Holds about 20 bytes a triangle.
 */
class ClosestPointTree
{
public:
  /** @param mesh is shared. Time and memory O(number of triangles). */
  explicit ClosestPointTree(std::shared_ptr<const TriangleMesh> mesh);

  struct Result
  {
    /** Snapped to edges and vertices (see snapped). */
    SurfacePoint point;
    Vector3 position;
    /** From the query point, in the mesh's length unit. */
    double distance = 0.0;
  };

  /**
   * @param query a finite point
   * @throws std::invalid_argument where the surface has no triangle, or the square of the distance
   *         overflows
   * Time O(log n) for points near the surface.
   */
  Result closestPoint(const Vector3& query) const;

  /**
   * Where a ray first meets the surface, from either side; nothing where it misses. A ray cannot
   * slip through between two triangles that share an edge.
   * @param direction  of any length but 0
   * Time O(log n) for most rays.
   * S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2 (2013).
   */
  std::optional<Result> firstOnRay(const Vector3& origin, const Vector3& direction) const;

private:
  class Builder;
  /** Some triangles from a first one on; where there are none, the node of that number. */
  struct Run
  {
    Index first = NoIndex;
    Index triangles = 0;
  };
  /** The parts that a run is cut into; missing ones come last and have no first. */
  struct Node
  {
    FourBvhBounds bounds;
    std::array<Run, FourBvhBounds::Runs> runs;
  };

  std::array<Vector3, 3> cornersOf(Index triangle) const;
  void prefetch(const Run& run) const;

  std::shared_ptr<const TriangleMesh> Mesh;
  /** Bounds are stored relative to this point, so that floats resolve a surface far from 0. */
  Vector3 Origin;
  /** The first one holds all triangles. */
  std::vector<Node> Nodes;
};

}

#endif
