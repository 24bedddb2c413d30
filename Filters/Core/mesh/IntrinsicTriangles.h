// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IntrinsicTriangles_h
#define geodesic_IntrinsicTriangles_h

#include "base/Index.h"
#include "base/PlanePoint.h"
#include "mesh/EdgeLengths.h"
#include "mesh/SurfacePoint.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * Triangles of a surface that suit fast marching better than the faces of its mesh: their sides are
 * straight on the surface and may cross edges of the mesh. Distances on the surface are the same.
 *
 * They are the intrinsic Delaunay triangulation of the mesh's vertices: the two angles opposite to
 * an edge sum to at most a half turn. It is made by flips: two triangles that are laid into a plane
 * get the other diagonal. Where triangles are then still thin, as between the ends of a long
 * fillet, their longest sides are halved by a new vertex, and edges flipped again, until none is
 * thin whose sides are longer than the edges of the mesh near it. Caps stay, whose third corner
 * lies before the middle of the longest side. Sides that are far longer than the mesh's edges are
 * halved, too: where two fronts meet on one, values are too small by a part of it. Where that would
 * take more new vertices than there are, or many steps, as on a strip of needles alone, there are
 * no new vertices at all.
 *
 * Edges stay that have more than two triangles or lie at a triangle that is fixed or at a vertex of
 * very many triangles, and where the other diagonal joins vertices that an edge joins already: an
 * edge is named by its ends. Where new vertices come depends on the positions of the vertices, and
 * not on the order of the input.
 *
 * M. Fisher, B. Springborn, P. Schroeder, A. Bobenko, An algorithm for the construction of
 * intrinsic Delaunay triangulations with applications to digital geometry processing, Computing 81
 * (2007). N. Sharp, Y. Soliman, K. Crane, Navigating intrinsic triangulations, ACM Trans. Graph. 38
 * (2019).
 */
class IntrinsicTriangles
{
public:
  /**
   * @param mesh     the surface; must outlive this object
   * @param isFixed  one flag for each triangle whose edges must stay; or empty
   * Time O(n) and the flips and new vertices, some for each needle. Memory 100 bytes for each of
   * them.
   */
  IntrinsicTriangles(const TriangleMesh& mesh, const std::vector<bool>& isFixed);

  /** The vertices of the mesh, and new ones behind them. */
  Index numberOfVertices() const { return static_cast<Index>(this->LeastEdges.size()); }
  std::span<const Triangle> triangles() const { return this->Corners; }
  /** The number of a triangle of the mesh among these; triangles with the same corners have the
   * same one. If one of these is fixed, it has its corners still. */
  Index numberOf(Index triangle) const { return this->Numbers[triangle]; }
  /** The length of an edge of a triangle, on the surface. Time O(1). */
  double length(Index a, Index b) const;
  std::size_t numberOfSteps() const { return this->Steps.size(); }
  /** The edges of the mesh that no side of these triangles is, sorted. */
  std::vector<std::array<Index, 2>> removedEdges() const;

  /** A point of the mesh as one of these triangles. Time O(1) for each step that changed its
   * triangle, some on average. */
  SurfacePoint pointOf(const SurfacePoint& onMesh) const;

private:
  /** Half-edge 3t + k is the side of triangle t opposite its corner k, from corner k + 1 on. */
  using HalfEdge = Index;

  /**
   * What changed one or two triangles: the line from c to d now divides what the triangles a, b, c
   * and b, a, d were together. In a flip it takes the place of the side from a to b. Where this
   * side was halved, d is the new vertex on it, and the only triangle was a, b, c.
   */
  struct Step
  {
    std::array<Index, 4> corners;
    /** Where c and d lie if a is at (0, 0) and b at (x, 0); c is above. */
    double x;
    PlanePoint c;
    PlanePoint d;
    /** The triangles then: that with a and that with b. */
    std::array<Index, 2> triangles;
    /** The next step of each of them; NoStep if there is none. */
    std::array<std::uint32_t, 2> next{ NoStep, NoStep };
  };
  static constexpr std::uint32_t NoStep = static_cast<std::uint32_t>(-1);
  /** Edges are left as they are once there were so many steps for each triangle, and with a quarter
   * of them there are no new vertices; one to four are common. */
  static constexpr std::size_t MostStepsOfTriangle = 64;
  /** Triangles stay round a vertex with more of them, as in a fan: they are thin, but a front comes
   * from its middle or goes to it, and a new vertex would change them all. */
  static constexpr std::size_t MostRoundVertex = 256;
  /** In Twins: the edge must stay; and the edge has no other triangle. */
  static constexpr HalfEdge Fixed = NoIndex;
  static constexpr HalfEdge Border = NoIndex - 1;

  static HalfEdge following(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static HalfEdge preceding(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index cornerOf(HalfEdge h) const { return this->Corners[h / 3][h % 3]; }
  bool hasTwin(HalfEdge h) const { return this->Twins[h] < Border; }
  /** Makes a half-edge that of a given length beside another one, or one without. */
  void join(HalfEdge h, HalfEdge twin, double length);
  /** Where the apex of a half-edge's triangle lies if the half-edge goes from (0, 0) along the x
   * axis. */
  PlanePoint apexOf(HalfEdge h) const;

  /** Makes the triangulation without new vertices. */
  void makeDelaunay(const std::vector<bool>& isFixed);
  /** Takes over the triangles of the mesh, those with the same corners once, in an order that
   * positions alone decide. */
  void takeTriangles();
  /** @param isFixed  by the mesh's numbers */
  void linkTwins(const std::vector<bool>& isFixed);
  /** Flips the edges that wait, and those beside them, until none is to be flipped. */
  void flipWaiting();
  /** Whether the angles opposite to an edge sum to more than a half turn. */
  bool isToBeFlipped(HalfEdge h) const;
  /** Replaces an edge by the other diagonal. @return false, with nothing done, if it must stay */
  bool flip(HalfEdge h);
  /** Turns a triangle over. */
  void reverse(Index triangle);
  bool isEdge(Index a, Index b) const;
  bool isMeshEdge(Index a, Index b) const;
  void note(const Step& step);

  /** The length above which sides are halved whatever their triangle's shape: 1.3 times the mean of
   * the vertices' longest edges, or twice the side of a square of the area for each vertex where
   * that is more, so that there are at most some more new vertices than vertices. Beside edges that
   * are far shorter, it is the mean, or one and a half times that side. */
  double mostLength() const;
  /** Halves sides of thin triangles and long ones, see IntrinsicRefinement.cxx.
   * @return false, with a part done, where this takes too many vertices or steps */
  bool refine();
  /** The longest side of a triangle if it is to be halved; else NoIndex. */
  HalfEdge sideToHalve(Index triangle) const;
  void halve(HalfEdge h);
  /** Divides a triangle by a line to the middle of a side. @return the new triangle's half that is
   * behind the middle */
  HalfEdge divide(HalfEdge h, Index middle);

  static constexpr double Removed = -1.0;

  const TriangleMesh& Mesh;
  std::vector<Index> Numbers;
  std::vector<Triangle> Corners;
  std::vector<double> Lengths;
  /** The other half-edge of the same edge, Fixed or Border. */
  std::vector<HalfEdge> Twins;
  /** Lengths of edges that steps made; Removed for edges that they removed. */
  EdgeLengths Changed;
  /** For each vertex the length of the mesh's shortest edge there; of a new one the less of those
   * at the ends of its edge. */
  std::vector<double> LeastEdges;
  double MostLength = std::numeric_limits<double>::infinity();
  std::vector<Step> Steps;
  std::vector<std::uint32_t> FirstStep;
  std::vector<std::uint32_t> LastStep;
  std::vector<HalfEdge> Waiting;
  /** Triangles that flips have changed since refine() looked at them. */
  std::vector<Index> Touched;
};

}

#endif
