// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexFan_h
#define geodesic_VertexFan_h

#include "path/AngleSum.h"
#include "path/WeightedMesh.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

/** The faces round a vertex, where they are one fan: each shares an edge with the next one, as
 * everywhere inside a surface and on a boundary. The directions between two points lie ahead of one
 * of them, in the order of the ring, up to the other one. */
class VertexFan
{
public:
  /** @pre isSimpleFan() */
  VertexFan(const WeightedMesh& weighted, Index vertex);

  /** See VertexLink::appendShorterSide(). */
  std::optional<double> appendShorterSide(
    const PathPoint& from, const PathPoint& to, std::vector<Triangle>& faces) const;

private:
  /** Where a point is seen from the vertex: at the edge of an entry, or in the face that it opens.
   */
  struct Place
  {
    std::size_t entry;
    bool isInFace;
    /** From the vertex. */
    Vector3 direction;
  };
  /** The faces from one place ahead to another one, and the sum of their angles. */
  struct Side
  {
    std::size_t firstFace;
    std::size_t faces = 0;
    AngleSum angle{};
  };

  /** Nothing if the point is in no crossable face with the vertex, or at the vertex. */
  std::optional<Place> placeOf(const PathPoint& point) const;
  /** Nothing if not all faces there are crossable, or the angle is above 180 degrees. */
  std::optional<Side> sideAhead(const Place& from, const Place& to) const;
  /** Whether an entry opens a face that is crossable. */
  bool hasFace(std::size_t entry) const;
  Triangle face(std::size_t entry) const;
  Vector3 directionOf(std::size_t entry) const;

  const WeightedMesh& Surface;
  Index Vertex;
  std::span<const RingEntry> Ring;
  /** Whether the last face shares an edge with the first one. */
  bool IsClosed;
  /** Of the vertex. */
  Vector3 Centre;
};

}

#endif
