// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexLink_h
#define geodesic_VertexLink_h

#include "path/StripFunnel.h"
#include "path/WeightedMesh.h"

#include <optional>
#include <vector>

namespace geodesic
{

/**
 * The directions in which the faces round a vertex can be entered: a graph whose nodes are the
 * vertex's neighbours and whose arcs are its crossable faces, of their angle's length. On a smooth
 * surface it is one circle; on a boundary, a chain; with edges of more than two faces, any graph.
 */
class VertexLink
{
public:
  VertexLink(const WeightedMesh& weighted, Index vertex);

  /**
   * A path comes to the vertex from @p from and leaves it to @p to.
   * @return the faces to turn through on the side where the angle between the two is smallest,
   * if it is less than half a turn: the path is shorter there than through the vertex. The faces
   * that the two points lie in are among them, where they are not passed along an edge.
   */
  std::optional<std::vector<Triangle>> shorterSide(
    const PathPoint& from, const PathPoint& to) const;

private:
  struct Arc
  {
    std::size_t first;
    std::size_t second;
    double angle;
  };
  /** A direction between two nodes, at an angle from each; twice the same for a node's own. */
  struct Direction
  {
    std::array<std::size_t, 2> nodes;
    std::array<double, 2> angles;
  };

  std::size_t nodeOf(Index neighbour) const;
  std::optional<Direction> directionTo(const PathPoint& point) const;
  double angleBetween(const Vector3& a, const Vector3& b) const;

  const WeightedMesh& Surface;
  Index Vertex;
  std::vector<Index> Nodes;
  std::vector<Arc> Arcs;
};

}

#endif
