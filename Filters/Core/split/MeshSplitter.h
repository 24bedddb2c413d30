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

/** Splits the triangles of a mesh along curves; what SplitMesh is made by. */
class MeshSplitter
{
public:
  explicit MeshSplitter(const TriangleMesh& base);

  /**
   * A curve to run along edges. All curves must be given before the first is asked for.
   * @return its number
   * @throws std::invalid_argument for consecutive points that share no face
   */
  std::size_t add(const SurfacePath& curve);
  /** Splits the triangles along the curves. */
  void split();
  /** Cuts the split triangles open along a curve. */
  void cutAlong(std::span<const std::size_t> curves);

  // Points are numbered: the base mesh's vertices first.

  const std::vector<PathPoint>& origins() const { return this->Origins; }
  const std::vector<Triangle>& triangles() const { return this->Triangles; }
  /** By the numbers of triangles. */
  const std::vector<Index>& baseTriangles() const { return this->BaseTriangles; }
  /** The points along a curve. */
  std::vector<Index> curve(std::size_t number) const;
  /** Edges along which the mesh is cut, smaller point first. */
  const std::set<std::pair<Index, Index>>& cutEdges() const { return this->CutEdges; }
  /** Whether a point lies on a cut. */
  bool isOnCut(Index point) const { return this->OnCut.count(point) > 0; }

private:
  using Edge = std::pair<Index, Index>;

  Index pointAt(const PathPoint& place);
  Index addPoint(const PathPoint& origin);
  void splitTriangle(Index triangle);
  /** The points from a to b, which lie on one edge of the base mesh. */
  std::vector<Index> alongEdge(Index a, Index b) const;
  void openAt(Index point, const std::vector<Index>& triangles, const std::vector<Triangle>& uncut);

  const TriangleMesh& Base;
  std::vector<PathPoint> Origins;
  std::vector<Triangle> Triangles;
  std::vector<Index> BaseTriangles;
  /** Points on an edge of the base mesh, by the fraction of the way from its smaller vertex. */
  std::map<Edge, std::map<double, Index>> EdgePoints;
  std::map<Index, std::vector<Index>> FacePoints;
  std::map<Index, std::vector<Edge>> FaceSegments;
  /** What became of a segment inside a face. */
  std::map<Edge, std::vector<Index>> Ways;
  std::vector<std::vector<Index>> Curves;
  std::set<Edge> CutEdges;
  std::set<Index> OnCut;
  /** Where the triangles of split ones begin. */
  std::size_t FirstPiece = 0;
};

}

#endif
