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
 * Finds the point of a surface that is nearest to a point in space, or the first one on a ray. Such
 * a point may be anywhere on a face, not only at a vertex.
 *
 * The triangles of a TriangleMesh already follow a space-filling curve, so consecutive ones lie
 * together: a hierarchy of bounds over runs of them needs no sorting. A run is cut where the curve
 * jumps farthest (see BvhSplit), so that each part lies in one place. It is bounded by a box and by
 * a flat cylinder (see BvhBounds), because boxes alone rule out too little where the surface is
 * smooth and much of it is nearly as near as its nearest point. Holds about 20 bytes a triangle.
 */
class ClosestPointTree
{
public:
  /** @param mesh the surface, which the tree shares. Time and memory O(number of triangles). */
  explicit ClosestPointTree(std::shared_ptr<const TriangleMesh> mesh);

  struct Result
  {
    /** Snapped to edges and vertices (see snapped). */
    SurfacePoint point;
    Vector3 position;
    /** From the query point or the ray's origin, in the mesh's length unit. */
    double distance = 0.0;
  };

  /**
   * Returns the nearest point of the surface.
   * @param query a finite point
   * @throws std::invalid_argument where the surface has no triangle, or the square of the distance
   *         overflows
   * Time O(log n) for points near the surface.
   */
  Result closestPoint(const Vector3& query) const;

  /**
   * Returns where a ray first meets the surface, from either side; nothing where it misses. A ray
   * cannot pass between two triangles that share an edge.
   * @param origin     where the ray starts
   * @param direction  where it goes, of any length but 0
   * Time O(log n) for most rays.
   * S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2 (2013).
   */
  std::optional<Result> firstOnRay(const Vector3& origin, const Vector3& direction) const;

private:
  class Builder;
  /** Consecutive triangles from the first one on. If their number is 0, @a first is the number of a
   * node instead. */
  struct Run
  {
    Index first = NoIndex;
    Index triangles = 0;
  };
  /** The up to four parts that a run is cut into. Missing ones come last; their first is NoIndex.
   */
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
  /** The first node holds all triangles. */
  std::vector<Node> Nodes;
};

}

#endif
