// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexLink_h
#define geodesic_VertexLink_h

#include "path/WeightedMesh.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace geodesic
{

/**
 * The directions in which the faces round a vertex can be entered, as a graph. Its nodes are the
 * vertex's neighbours. Its arcs are the vertex's crossable faces; the length of an arc is the
 * face's angle at the vertex. Where the faces are one fan, it is a circle or a chain, and
 * VertexFan does without it; with edges of more than two faces it can be any graph.
 */
class VertexLink
{
public:
  /** The link of no vertex as yet: one serves for many, as what it allocates stays. */
  explicit VertexLink(const WeightedMesh& weighted)
    : Surface(weighted)
  {
  }

  /**
   * The side on which a path that bends at a vertex gets shorter, or at least no longer.
   * @param from, to  points of the path before and after the vertex, each in a face with it
   * @param faces     the faces round the vertex on the side where the angle between the two points
   *        is smallest are appended, if it is at most 180 degrees. The faces in which the points
   *        lie are among them, unless the path runs along an edge there
   * @return the angle on that side, in radians; nothing if there is no such side
   */
  std::optional<double> appendShorterSide(
    Index vertex, const PathPoint& from, const PathPoint& to, std::vector<Triangle>& faces);

private:
  /** A face as an arc between two nodes. */
  struct Arc
  {
    std::size_t first;
    std::size_t second;
    double angle;
  };
  /** A direction between two nodes, with its angle to each. For the direction of a node both are
   * that node. */
  struct Direction
  {
    std::array<std::size_t, 2> nodes;
    std::array<double, 2> angles;
  };

  /** Stands for no node. */
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  /** Makes the link that of a vertex. */
  void lookAt(Index vertex);
  /** Finds the smallest angles from a direction. */
  void sweepFrom(const Direction& source);
  /** Makes final the angles of a sweep that are not, by Dijkstra's algorithm. */
  void settle();
  /** The place of a neighbour in Nodes. */
  std::size_t nodeOf(Index neighbour) const;
  /** The direction from the vertex to a point; nothing if the point's face is not crossable. */
  std::optional<Direction> directionTo(const PathPoint& point) const;
  /** The angle between two points as seen from the vertex. */
  double angleBetween(const Vector3& a, const Vector3& b) const;

  const WeightedMesh& Surface;
  Index Vertex = NoIndex;
  /** The neighbours, sorted. */
  std::vector<Index> Nodes;
  std::vector<Arc> Arcs;
  /** For each node the smallest angle to a direction, infinite where there is none. */
  std::vector<double> Angles;
  /** For each node the one before on the way there. */
  std::vector<std::size_t> Previous;
};

}

#endif
