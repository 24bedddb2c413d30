#ifndef geodesic_ClosestPointTree_h
#define geodesic_ClosestPointTree_h

#include "SurfacePoint.h"
#include "Vector3.h"

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
 * together: a hierarchy of bounds over runs of them needs no sorting, no child pointers and about
 * 15 bytes a triangle. A run is bounded by a box and by a slab across the mean of its normals. Seen
 * from far inside a smooth surface, where nearly all of it is nearly as near as its nearest point,
 * boxes alone would tell little.
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
  struct Box
  {
    float low[3];
    float high[3];
  };
  /** The points p with low <= direction p <= high. */
  struct Slab
  {
    /** At most of length 1. */
    Vector3 direction() const { return { this->x, this->y, this->z }; }

    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;
    float low = 0.0f;
    float high = 0.0f;
  };
  struct Bounds
  {
    Box box;
    Slab slab;
  };

  Box boxOfTriangles(Index first, Index last) const;
  std::array<Vector3, 3> cornersOf(Index triangle) const;
  Vector3 normalOfTriangles(Index first, Index last) const;
  Slab slabOfTriangles(const Vector3& across, Index first, Index last) const;

  std::shared_ptr<const TriangleMesh> Mesh;
  /** Bounds are stored relative to this point, so that floats resolve a surface far from 0. */
  Vector3 Origin;
  /** Levels[0] bounds runs of triangles; each further level bounds runs of the one below. */
  std::vector<std::vector<Bounds>> Levels;
};

}

#endif
