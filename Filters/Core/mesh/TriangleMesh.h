// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleMesh_h
#define geodesic_TriangleMesh_h

#include "base/BulkVector.h"
#include "base/Index.h"
#include "base/Platform.h"
#include "base/SharedVector.h"
#include "base/ThreadTeam.h"
#include "base/Vector3.h"
#include "base/WorkCount.h"
#include "mesh/SurfacePoint.h"
#include "mesh/VertexRings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

class IntrinsicTriangles;
struct LazyMotionTable;

/** Whether points of equal coordinates are one vertex of the mesh. */
enum class CoincidentPoints
{
  Separate,
  Merge
};

/**
 * An immutable triangle mesh, built once for an input and shared by every solver and tracer on it.
 *
 * Its *vertices* are the input's *points* that at least one triangle uses, renumbered along a
 * space-filling curve (see spatialOrder). With CoincidentPoints::Merge, points of equal coordinates
 * are one vertex; with the constructor that takes kinds, points of the same kind are. Triangles are
 * sorted by their lowest vertex, and by the other two where one vertex is the lowest of many. Any
 * surface is allowed: boundaries, several parts, mixed orientation, edges with more than two
 * triangles, triangles of zero area. A triangle that repeats a corner has no area and no interior
 * and is left out.
 *
 * Holds about 130 bytes a vertex, and 32 more for the numbers of a measurer. Lengths are computed
 * from the coordinates where they are used: on current machines that is cheaper than reading them
 * from memory.
 */
class TriangleMesh
{
public:
  /**
   * @param points      coordinates, in any length unit
   * @param triangles   point ids
   * @param coincident  whether points of equal coordinates become one vertex
   * @param team        threads to build it on; the mesh does not depend on their number
   * @param measurer    of numbers to make along with the rings, see RingNumbers.h; null for none.
   *                    It must outlive the mesh.
   * @throws std::invalid_argument where a triangle names a point that does not exist, or one whose
   *         coordinates are not finite, and where the largest coordinate is below 1e-30 (but not 0)
   *         or above 1e30
   * @throws std::length_error for more than 2^30 - 1 vertices or 700 million triangles
   * Time O(n).
   */
  TriangleMesh(std::span<const Vector3> points, std::span<const Triangle> triangles,
    CoincidentPoints coincident = CoincidentPoints::Separate, const ThreadTeam& team = ThreadTeam(),
    const RingMeasurer* measurer = nullptr);
  /**
   * Builds the mesh with points merged by the caller's choice instead of by coordinates.
   * @param kinds  a number below points.size() for each point: points of the same kind are one
   *               vertex, at the position of the lowest of them that a triangle uses
   */
  TriangleMesh(std::span<const Vector3> points, std::span<const Triangle> triangles,
    std::span<const Index> kinds, const ThreadTeam& team = ThreadTeam(),
    const RingMeasurer* measurer = nullptr);

  /**
   * Returns this mesh without some of its triangles. All vertices stay, with their numbers; one
   * that has no triangle left has an empty ring.
   * @param leftOut  one flag for each triangle
   * @param team     as for the constructor. Time O(n).
   */
  TriangleMesh without(
    const std::vector<bool>& leftOut, const ThreadTeam& team = ThreadTeam()) const;

  /**
   * Returns the same surface with other triangles: straight on the surface, but not in space. Their
   * sides have the lengths that @p intrinsic tells, not the distances of their ends in space; what
   * is measured round a vertex is measured by toNeighbour(). The vertices keep their numbers.
   * Behind them come those that @p intrinsic added; these have no point, and NaN as position.
   * @param team  as for the constructor. Time O(n). Memory 170 bytes a vertex more.
   */
  TriangleMesh withTriangles(
    const IntrinsicTriangles& intrinsic, const ThreadTeam& team = ThreadTeam()) const;

  /**
   * Returns this mesh with its points elsewhere. It shares all that does not depend on positions,
   * also the order in memory, which suits neighbours wherever they are. Distances on it are those
   * on a mesh that is built of the points, but for rounding.
   * @param points      numberOfPoints() of them
   * @param coincident  as when this mesh was built
   * @param team        as for the constructor
   * @return nothing where the points are no longer the same vertices, as some meet or part, or
   *         where the position of a used point is not finite: then a mesh must be built
   * @throws std::invalid_argument for coordinates that are too large or small, see the constructor
   * Time O(n), a third of what it takes to build a mesh; the first time as long. The first motion
   * adds 28 bytes a vertex, which all moved meshes share.
   */
  std::optional<TriangleMesh> withPositions(std::span<const Vector3> points,
    CoincidentPoints coincident, const ThreadTeam& team = ThreadTeam()) const;
  /** The same of a mesh that was built with @p kinds. */
  std::optional<TriangleMesh> withPositions(std::span<const Vector3> points,
    std::span<const Index> kinds, const ThreadTeam& team = ThreadTeam()) const;
  /** Whether the other mesh is this one with points elsewhere, or both are the same one so moved.
   */
  bool hasStructureOf(const TriangleMesh& other) const
  {
    return this->Triangles.isShared(other.Triangles) && this->Rings.areShared(other.Rings);
  }
  /** Whether the constructor would make the same of these triangles, of points that are the same
   * vertices. Time O(n). */
  bool isMadeOf(std::span<const Triangle> triangles) const;

  Index numberOfPoints() const { return static_cast<Index>(this->VertexOfPoint.size()); }
  Index numberOfVertices() const { return static_cast<Index>(this->Positions.size()); }
  Index numberOfTriangles() const { return static_cast<Index>(this->Triangles.size()); }

  /** The vertex that an input point became; NoIndex where no triangle uses the point. */
  Index vertexOfPoint(Index point) const { return this->VertexOfPoint[point]; }
  /** The input point that became a vertex; of several merged ones, the lowest. */
  Index pointOfVertex(Index vertex) const { return this->PointOfVertex[vertex]; }

  const Vector3& position(Index vertex) const { return this->Positions[vertex]; }
  std::span<const Vector3> positions() const { return this->Positions; }
  const Triangle& triangle(Index triangle) const { return this->Triangles[triangle]; }
  std::span<const Triangle> triangles() const { return this->Triangles; }
  /** The number that a triangle has in the constructor's list. */
  Index sourceOfTriangle(Index triangle) const { return this->SourceOfTriangle[triangle]; }
  /** Whether triangles are straight on another surface and not in space, see withTriangles(). */
  bool isIntrinsic() const { return !this->Offsets.empty(); }
  /** The vector from a vertex to the neighbour of an entry of its ring: in space, or, on an
   * intrinsic mesh, where the triangles of that fan lie if they are laid into a plane. */
  Vector3 toNeighbour(Index vertex, std::size_t entry) const
  {
    return this->isIntrinsic()
      ? this->Offsets[this->Rings.firstEntry(vertex) + entry]
      : this->Positions[this->ring(vertex)[entry].neighbour()] - this->Positions[vertex];
  }
  /** On an intrinsic mesh toNeighbour() of all entries of all rings, and VertexRings::Overrun
   * vectors more; else empty. */
  std::span<const Vector3> offsets() const
  {
    return { this->Offsets.data(), this->Offsets.size() };
  }
  /** The triangles round a vertex; see VertexRings. */
  std::span<const RingEntry> ring(Index vertex) const { return this->Rings[vertex]; }
  const VertexRings& rings() const { return this->Rings; }
  /** The numbers that were made along with the rings; null if none were. See ringNumbers(). */
  const std::shared_ptr<const RingNumbers>& numbers() const { return this->Numbers; }
  /** The measurer of these numbers, for meshes that are made from this one; null if there is none.
   */
  const RingMeasurer* measurer() const { return this->Numbers ? this->Numbers->measurer : nullptr; }
  /** Asks the processor to fetch a vertex's position and ring, which will soon be read. This reads
   * where the ring begins, so call prefetchRingStart() some time before. */
  GEODESIC_INLINED void prefetch(Index vertex) const
  {
    this->Rings.prefetch(vertex);
    prefetchToRead(&this->Positions[vertex]);
  }
  GEODESIC_INLINED void prefetchRingStart(Index vertex) const { this->Rings.prefetchStart(vertex); }

  /** The vertex as a point of the surface. @pre a triangle uses it. Time O(log n). */
  SurfacePoint pointAtVertex(Index vertex) const;
  /** The triangles that have all of some vertices as corners, sorted by number. Time O(log n) for
   * each triangle round the one of these vertices that has the fewest. */
  std::vector<Index> trianglesWith(std::span<const Index> corners) const;
  /** Whether a triangle has all of some vertices as corners. @pre there are one to three, all
   * different. Time O(log n) for three of them, else that of visitTrianglesWith(). */
  bool hasTriangleWith(std::span<const Index> corners) const;
  /** The lowest number of a triangle that has all of some vertices as corners; NoIndex if none has.
   * Time O(log n), and O(1) for each triangle round the one of one or two vertices that has the
   * fewest. @pre there are one to three vertices, all different */
  Index firstTriangleWith(std::span<const Index> corners) const;
  /**
   * Calls visit(centre, place, corners) for each triangle that has all of some vertices as corners.
   * The centre is the one of these vertices that has the fewest triangles, as fans can be large;
   * the triangle is between the entries @p place and @p place + 1 of its ring.
   */
  template <class Visit>
  void visitTrianglesWith(std::span<const Index> corners, const Visit& visit) const
  {
    const Index centre = *std::min_element(corners.begin(), corners.end(),
      [&](Index a, Index b) { return this->ring(a).size() < this->ring(b).size(); });
    const std::span<const RingEntry> ring = this->ring(centre);
    WorkCount::add(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (ring[i].opensTriangle())
      {
        const Triangle t{ centre, ring[i].neighbour(), ring[i + 1].neighbour() };
        if (std::all_of(corners.begin(), corners.end(),
              [&](Index corner) { return std::find(t.begin(), t.end(), corner) != t.end(); }))
        {
          visit(centre, i, t);
        }
      }
    }
  }
  /** The position in space of a point of the surface. */
  Vector3 positionOf(const SurfacePoint& point) const;

  /** Mean of longestEdgeAround() over all vertices; 0 for a mesh without vertices. */
  double meanLongestEdge() const { return this->MeanLongestEdge; }
  /** How far the lengths longestEdgeAround() are spread: their mean by their harmonic mean; 1 if
   * all are equal. */
  double spreadOfEdges() const { return this->SpreadOfEdges; }
  /** Length of the longest side of any triangle, rounded up to a float. */
  double longestEdgeLength() const { return this->LongestEdgeLength; }
  /** Length of the longest side of the triangles round a vertex, rounded up to a float. */
  double longestEdgeAround(Index vertex) const { return this->Rings.longestSides()[vertex]; }

private:
  /** The triangles @p first to @p last - 1. */
  struct TriangleRange
  {
    Index first;
    Index last;
  };

  /** A vertex that is the lowest corner of more triangles has these sorted by their other corners.
   */
  static constexpr std::ptrdiff_t MostUnsorted = 32;

  /** How points are vertices. */
  struct Numbering
  {
    BulkVector<Vector3> positions;
    BulkVector<Index> vertexOfPoint;
    BulkVector<Index> pointOfVertex;
  };
  /** The vertex of a point that only left-out triangles use. */
  struct BarePoint
  {
    Index point;
    Index vertex;
  };
  /** Triangles while they are put in order. */
  struct OrderedTriangles
  {
    /** Sorts triangles of one lowest corner by their other corners. */
    void sortByCorners(const TriangleRange& range);

    BulkVector<Triangle> triangles;
    BulkVector<Index> sources;
  };
  friend class MotionTable;

  TriangleMesh() = default;
  static Numbering numbered(std::span<const Vector3> points, std::span<const std::uint8_t> used,
    CoincidentPoints coincident, const ThreadTeam& team);
  void build(Numbering numbering, std::span<const Triangle> triangles, const ThreadTeam& team,
    const RingMeasurer* measurer);
  /** Makes the rings and what is measured along with them. @param room see VertexRings */
  void makeRings(std::span<Index> room, const ThreadTeam& team, const RingMeasurer* measurer);
  /** @param corners workspace, three numbers for each triangle */
  void orderTriangles(std::span<const Index> vertexOfPoint, std::span<const Triangle> triangles,
    std::span<Index> corners, const ThreadTeam& team);
  /** The triangles with these three corners, sorted by number. Time O(log n), and the same again
   * for each of them. */
  std::vector<Index> trianglesOf(const Triangle& corners) const;
  /** Sets NoIndex as the vertex of points that only left-out triangles use: they aren't on the
   * surface. */
  void forgetBareVertices(std::span<Index> vertexOfPoint);
  void measureEdges();
  /** Measures the rings of an intrinsic mesh. */
  void makeOffsets(const IntrinsicTriangles& intrinsic, const ThreadTeam& team);

  /** Where points put the vertices; nothing if one of these is not finite. */
  std::optional<BulkVector<Vector3>> movedPositions(
    std::span<const Vector3> points, const ThreadTeam& team) const;
  TriangleMesh moved(BulkVector<Vector3> positions, const ThreadTeam& team) const;
  /** The vertices of all points, also of those that only left-out triangles use. */
  std::vector<Index> verticesOfAllPoints() const;
  /** Whether these triangles use the points that those of this mesh do. */
  bool usesPointsOf(std::span<const Triangle> triangles) const;

  BulkVector<Vector3> Positions;
  SharedVector<Triangle> Triangles;
  SharedVector<Index> SourceOfTriangle;
  VertexRings Rings;
  SharedVector<Vector3> Offsets;
  std::shared_ptr<const RingNumbers> Numbers;
  SharedVector<Index> VertexOfPoint;
  SharedVector<Index> PointOfVertex;
  SharedVector<BarePoint> BarePoints;
  std::size_t NumberOfSources = 0;
  std::shared_ptr<LazyMotionTable> Motion;
  double MeanLongestEdge = 0.0;
  double SpreadOfEdges = 1.0;
  double LongestEdgeLength = 0.0;
};

/** The length of an edge, the same from both ends to the last digit. */
inline double edgeLength(const TriangleMesh& mesh, Index a, Index b)
{
  return norm(mesh.position(std::max(a, b)) - mesh.position(std::min(a, b)));
}

}

#endif
