// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleMesh_h
#define geodesic_TriangleMesh_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/Platform.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"
#include "mesh/SurfacePoint.h"
#include "mesh/VertexRings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic
{

/** Whether points of equal coordinates are one vertex of the mesh. */
enum class CoincidentPoints
{
  Separate,
  Merge
};

/**
 * An immutable triangle mesh, built once for an input and shared by every solver and tracer on it.
 *
 * Its *vertices* are the input's *points* that at least one triangle uses, renumbered along a space
 * filling curve (see spatialOrder); with CoincidentPoints::Merge, points of equal coordinates are
 * one vertex, and so are points that are said to be of the same kind. Triangles follow the order of
 * their lowest vertex. Any surface is allowed: boundaries, several parts, mixed orientation, edges
 * with more than two triangles, triangles of zero area. A triangle that repeats a corner has no
 * area and no interior and is left out.
 *
 * Holds about 130 bytes a vertex. Lengths are computed from the coordinates where they are used:
 * on current machines that is cheaper than reading them from memory.
 */
class TriangleMesh
{
public:
  /**
   * @param points     coordinates, in any length unit
   * @param triangles  point ids
   * @param team       threads to build it on; the mesh does not depend on their number
   * @throws std::invalid_argument where a triangle names a point that does not exist, or one whose
   *         coordinates are not finite
   * @throws std::length_error for more than 2^30 - 1 vertices or 700 million triangles
   * Time O(n).
   */
  TriangleMesh(std::span<const Vector3> points, std::span<const Triangle> triangles,
    CoincidentPoints coincident = CoincidentPoints::Separate,
    const ThreadTeam& team = ThreadTeam());
  /**
   * The same of points that are one vertex by something else than their coordinates.
   * @param kinds  a number below points.size() for each point: points of the same kind are one
   *               vertex, at the position of the lowest of them that a triangle uses
   */
  TriangleMesh(std::span<const Vector3> points, std::span<const Triangle> triangles,
    std::span<const Index> kinds, const ThreadTeam& team = ThreadTeam());

  Index numberOfPoints() const { return static_cast<Index>(this->VertexOfPoint.size()); }
  Index numberOfVertices() const { return static_cast<Index>(this->Positions.size()); }
  Index numberOfTriangles() const { return static_cast<Index>(this->Triangles.size()); }

  /** The vertex that stands for an input point, NoIndex where no triangle uses the point. */
  Index vertexOfPoint(Index point) const { return this->VertexOfPoint[point]; }
  /** The input point (the lowest of the merged ones) that a vertex stands for. */
  Index pointOfVertex(Index vertex) const { return this->PointOfVertex[vertex]; }

  const Vector3& position(Index vertex) const { return this->Positions[vertex]; }
  std::span<const Vector3> positions() const { return this->Positions; }
  const Triangle& triangle(Index triangle) const { return this->Triangles[triangle]; }
  std::span<const Triangle> triangles() const { return this->Triangles; }
  /** Which of the triangles given to the constructor this one was. */
  Index sourceOfTriangle(Index triangle) const { return this->SourceOfTriangle[triangle]; }
  /** The triangles round a vertex. */
  std::span<const RingEntry> ring(Index vertex) const { return this->Rings[vertex]; }
  const VertexRings& rings() const { return this->Rings; }
  /** Has the processor fetch a vertex's position and ring, which are soon to be read; best some
   * time after prefetchRingStart(), which fetches where the ring is. */
  GEODESIC_INLINED void prefetch(Index vertex) const
  {
    this->Rings.prefetch(vertex);
    prefetchToRead(&this->Positions[vertex]);
  }
  GEODESIC_INLINED void prefetchRingStart(Index vertex) const { this->Rings.prefetchStart(vertex); }

  /** The vertex as a point of the surface. Time O(log n). */
  SurfacePoint pointAtVertex(Index vertex) const;
  /** The triangles that have all of some vertices as corners; time O(log n). */
  std::vector<Index> trianglesWith(std::span<const Index> corners) const;
  /** Where a point of the surface is in space. */
  Vector3 positionOf(const SurfacePoint& point) const;

  /** Mean over all vertices of longestEdgeAround(); 0 without any. */
  double meanLongestEdge() const { return this->MeanLongestEdge; }
  /** Length of the longest side of any triangle, rounded up to a float. */
  double longestEdgeLength() const { return this->LongestEdgeLength; }
  /** Length of the longest side of the triangles round a vertex, rounded up to a float. */
  double longestEdgeAround(Index vertex) const { return this->Rings.longestSides()[vertex]; }

private:
  void numberVertices(std::span<const Vector3> points, std::span<const std::uint8_t> used,
    CoincidentPoints coincident, const ThreadTeam& team);
  void build(std::span<const Triangle> triangles, const ThreadTeam& team);
  /** @param corners room to work in, three numbers a triangle */
  void orderTriangles(
    std::span<const Triangle> triangles, std::span<Index> corners, const ThreadTeam& team);
  /** Points that only triangles without an area use are not on the surface. */
  void forgetBareVertices();
  void measureEdges();

  BulkVector<Vector3> Positions;
  BulkVector<Triangle> Triangles;
  BulkVector<Index> SourceOfTriangle;
  VertexRings Rings;
  BulkVector<Index> VertexOfPoint;
  BulkVector<Index> PointOfVertex;
  double MeanLongestEdge = 0.0;
  double LongestEdgeLength = 0.0;
};

}

#endif
