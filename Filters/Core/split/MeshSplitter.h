// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MeshSplitter_h
#define geodesic_MeshSplitter_h

#include "path/PathPoint.h"
#include "split/FaceTriangulation.h"

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * Splits the triangles of a mesh along curves, for SplitMesh and RegionCut. Calls come in this
 * order: add() for each curve, split(), curve(), cutAlong(); results last.
 *
 * Points are numbered: first the vertices of the base mesh, then new points. Time and memory depend
 * on the curves, not on the mesh.
 */
class MeshSplitter
{
public:
  explicit MeshSplitter(const TriangleMesh& base);

  /**
   * Adds a curve that is to run along edges. @pre split() was not called
   * @return the number of the curve
   * @throws std::invalid_argument for consecutive points that share no face
   */
  std::size_t add(const SurfacePath& curve);
  /** Splits the triangles along all curves that were added. */
  void split();
  /** Cuts the split triangles open along curves. @param curves their numbers */
  void cutAlong(std::span<const std::size_t> curves);

  Index numberOfPoints() const
  {
    return this->Base.numberOfVertices() + static_cast<Index>(this->NewOrigins.size());
  }
  /** The place of a point on the base mesh. */
  PathPoint origin(Index point) const
  {
    const Index vertices = this->Base.numberOfVertices();
    return point < vertices ? PathPoint::atVertex(point) : this->NewOrigins[point - vertices];
  }
  /** The triangles of the base mesh that are split, sorted. */
  const std::set<Index>& splitTriangles() const { return this->SplitTriangles; }
  /** The triangles that these were split into, in the same order, of the numbers of points. */
  const std::vector<Triangle>& pieces() const { return this->Pieces; }
  /** For each piece the triangle of the base mesh of which it is a part. */
  const std::vector<Index>& baseTriangles() const { return this->BaseTriangles; }
  /** The points along the curve of a number. @pre split() was called */
  std::vector<Index> curve(std::size_t number) const;
  /** Edges along which the mesh is cut, smaller point first. */
  const std::set<std::pair<Index, Index>>& cutEdges() const { return this->CutEdges; }
  /** Whether a point lies on a cut. */
  bool isOnCut(Index point) const { return this->OnCut.count(point) > 0; }

private:
  using Edge = std::pair<Index, Index>;

  /** The point at a place on the base mesh; a new one if there is none yet. */
  Index pointAt(const PathPoint& place);
  Index addPoint(const PathPoint& origin);
  /** Adds the pieces of a triangle of the base mesh. */
  void splitTriangle(Index triangle);
  /** The points from a to b, with both. @pre a and b lie on one edge of the base mesh */
  std::vector<Index> alongEdge(Index a, Index b) const;
  /** Cuts the mesh open at a point on cuts: each side of the cuts but one gets a new point there.
   * @param pieces  those round the point
   * @param uncut   all pieces before any point was replaced */
  void openAt(Index point, const std::vector<Index>& pieces, const std::vector<Triangle>& uncut);

  const TriangleMesh& Base;
  /** The places of the new points. */
  std::vector<PathPoint> NewOrigins;
  std::set<Index> SplitTriangles;
  std::vector<Triangle> Pieces;
  std::vector<Index> BaseTriangles;
  /** The points on each edge of the base mesh, by the fraction of the edge from its smaller vertex
   * to them. */
  std::map<Edge, std::map<double, Index>> EdgePoints;
  /** The points inside each face of the base mesh, and the segments of curves across it. */
  std::map<Index, std::vector<Index>> FacePoints;
  /** The same, by a sum of weights in which few points are equal. */
  std::map<Index, std::multimap<double, Index>> FacePlaces;
  std::map<Index, std::vector<Edge>> FaceSegments;
  /** For each segment inside a face, the points along it: the ends of its pieces after split(). */
  std::map<Edge, std::vector<Index>> PiecesOfSegment;
  std::vector<std::vector<Index>> Curves;
  std::set<Edge> CutEdges;
  std::set<Index> OnCut;
};

}

#endif
