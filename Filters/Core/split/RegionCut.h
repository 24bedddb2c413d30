// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionCut_h
#define geodesic_RegionCut_h

#include "path/PathPoint.h"
#include "split/MeshSplitter.h"
#include "split/RegionMesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

class DisjointSets;

/** The place of each of some sizes among them, the largest first; equal ones keep their order. */
std::vector<Index> placesBySize(std::span<const double> sizes);

/**
 * The regions that lines divide a surface into. Triangles are split so that the lines run along
 * edges; two triangles are of one region if one gets from one to the other over edges that are on
 * no line. Points of the surface do not connect: at a vertex where only corners meet, regions are
 * apart.
 *
 * Regions are numbered by their area, the largest first; putFirst() makes another one number 0. An
 * edge at which several sheets meet connects all of them, and a line along it separates all.
 * Triangles with the same three corners are of one region, and are split alike.
 *
 * The mesh can be a piece of a surface. Then sharedSides() tells what other pieces have to know,
 * and renumber() brings their answer.
 */
class RegionCut
{
public:
  /** A part of a split triangle. */
  struct Piece
  {
    /** The triangle of the mesh, and the piece's corners as numbers of points, see pointAt(). */
    Index triangle;
    Triangle corners;
    Index region;
  };

  /**
   * @param mesh   the surface; the object keeps it
   * @param lines  paths on it, in any position to each other: nested, touching, crossing, doubled.
   *               One of a single point splits the triangles there.
   * @param shared one flag for each vertex, 1 if other pieces of the surface have it too; empty if
   *               the mesh is the whole surface
   * @throws std::invalid_argument for a line with consecutive points that share no face
   * Time O(n) for the mesh, with small constants, and O(k log k) for k points of lines.
   */
  RegionCut(std::shared_ptr<const RegionMesh> mesh, std::span<const SurfacePath> lines,
    std::vector<std::uint8_t> shared = {});

  /** The area of each region. */
  const std::vector<double>& areas() const { return this->Areas; }
  /**
   * The length of each region's border: of its edges along lines to other regions, and of those of
   * the surface's border; without edges between shared vertices.
   */
  const std::vector<double>& perimeters() const { return this->Perimeters; }

  /** The region of a triangle that is not split; NoIndex if it is split. */
  Index regionOf(Index triangle) const { return this->Regions[triangle]; }
  /** The parts of the split triangles, sorted by triangle. */
  const std::vector<Piece>& pieces() const { return this->Pieces; }
  /** The place of a point of a piece. Points below the number of the mesh's vertices are those. */
  PathPoint pointAt(Index point) const { return this->Splitter.origin(point); }
  Index numberOfPoints() const { return this->Splitter.numberOfPoints(); }
  /** Pairs of triangles, none of them split, with an edge between them that lies on a line. */
  const std::vector<std::pair<Index, Index>>& closedEdges() const { return this->ClosedEdges; }

  /** The regions at a point of the surface, sorted: several only on a line. */
  std::vector<Index> regionsAt(const SurfacePoint& point) const;
  /** Numbers a region 0, and those before it one higher. */
  void putFirst(Index region);

  /** A triangle's, or a part's, side between shared vertices. */
  struct SharedSide
  {
    /** Points, see pointAt(): shared vertices, or on the edge between two. */
    std::pair<Index, Index> edge;
    Index region;
    bool isOnLine;
    double length;
  };
  const std::vector<SharedSide>& sharedSides() const { return this->SharedSides; }
  /** Whether both ends of an edge are shared vertices, or on the edge between two. */
  bool isShared(const std::pair<Index, Index>& edge) const;
  /**
   * Makes the regions those of the whole surface.
   * @param numbers    of each region on the surface; several can have become one
   * @param areas      of the surface's regions
   * @param separating for each of sharedSides(): whether other regions lie beside its edge
   */
  void renumber(
    std::span<const Index> numbers, std::vector<double> areas, const std::vector<bool>& separating);
  /** Replaces the perimeters by those of the whole surface. */
  void setPerimeters(std::vector<double> perimeters) { this->Perimeters = std::move(perimeters); }

  /** Whether a line has different regions on its sides, at least along a part of it. */
  bool separates(std::size_t line) const;
  /** The points of a line after splitting, as numbers. */
  std::vector<Index> pointsOf(std::size_t line) const { return this->Splitter.curve(line); }

private:
  using Edge = std::pair<Index, Index>;
  /** A side of a piece, or of a triangle beside one or beside a line. */
  struct Side
  {
    Edge edge;
    /** A triangle of the mesh, or its number of triangles plus the number of a piece. */
    Index part;

    friend auto operator<=>(const Side&, const Side&) = default;
  };

  /** Marks the edges on lines. @return the edges, sorted */
  std::vector<Edge> edgesOfLines(std::size_t lines) const;
  void collectPieces();
  /** The sides of pieces and of the triangles beside them and beside lines, sorted by edge. */
  std::vector<Side> sidesAtLines(const std::vector<Edge>& lines);
  void connectTriangles(DisjointSets& parts) const;
  void number(DisjointSets& parts);
  void replaceRegions(std::span<const Index> numbers);
  void collectSharedSides(const std::vector<Edge>& lines);
  void measure();
  Index regionOfPart(Index part) const;
  double lengthOf(const Edge& edge) const;
  double areaOf(const Piece& piece) const;
  /** The pieces of a triangle. */
  std::span<const Piece> piecesOf(Index triangle) const;

  std::shared_ptr<const RegionMesh> Mesh;
  MeshSplitter Splitter;
  std::vector<std::uint8_t> Shared;
  std::vector<Piece> Pieces;
  std::vector<Index> Regions;
  /** One flag for each half-edge: 1 if it is on a line. */
  std::vector<std::uint8_t> IsClosed;
  std::vector<std::pair<Index, Index>> ClosedEdges;
  /** Of pieces and of the triangles beside them and beside lines. */
  std::vector<Side> Sides;
  std::vector<SharedSide> SharedSides;
  std::vector<double> Areas;
  std::vector<double> Perimeters;
  /** Edges with different regions beside them, sorted. */
  std::vector<Edge> Separating;
};

}

#endif
