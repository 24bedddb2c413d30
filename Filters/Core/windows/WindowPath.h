// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowPath_h
#define geodesic_WindowPath_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "mesh/SurfacePoint.h"
#include "windows/Arrival.h"

#include <cstddef>
#include <span>
#include <vector>

namespace geodesic
{

class DistanceField;
class EdgeTable;
class Junctions;
class PassableTriangles;
struct LaidTriangle;
class TriangleMesh;

/**
 * Follows a shortest path back from a point to its seed, by how it and the vertices at which it
 * turns were reached. Between turns it is a straight line over triangles unfolded one after the
 * other, towards the source that the window had. Time linear in the number of triangles, but where
 * more than two meet at an edge: there the line tries one after the other, and gives up those from
 * which no window with that source came to the next such edge, or which the distances rule out.
 */
class WindowPath
{
public:
  /**
   * @param seeds     the seeds' points, by their numbers
   * @param arrivals  of all vertices; all arguments must live as long as this
   */
  WindowPath(const TriangleMesh& mesh, const EdgeTable& edges, const PassableTriangles& passable,
    const Junctions& junctions, const DistanceField& field, std::span<const SurfacePoint> seeds,
    std::span<const Arrival> arrivals);

  /**
   * Traces from a point.
   * @param start, distance, seed, arrival  of that point
   * @return the points of the path, with both ends; empty if rounding led it astray
   */
  std::vector<SurfacePoint> from(
    const SurfacePoint& start, double distance, Index seed, const Arrival& arrival);

private:
  /** A straight line at an edge, in the plane of a half-edge whose triangle it enters. */
  struct Crossing
  {
    Index halfEdge;
    /** Where it meets the edge, from the lower vertex on. */
    double place;
    /** Its direction, of length 1, with y >= 0. */
    double x;
    double y;
    /** The length that is left. */
    double left;
    /** How many points the path has, this one included. */
    std::size_t points;
  };

  /** Follows the line of an arrival across an edge. @return whether it came to its source, at which
   * Turn is set */
  bool follow(const Arrival& arrival);
  /** Takes the line into all triangles beyond an edge. */
  void enter(Index halfEdge, const Crossing& at);
  /** Whether the line ends in the triangle that it enters; sets Turn. */
  bool endsIn(const Crossing& at, double offset);
  /** Takes the line to the edge at which it leaves the triangle that it enters. */
  void cross(const Crossing& at);
  /** The same to the side of the lower vertex, the left one, or of the higher one. */
  void crossTo(const Crossing& at, const LaidTriangle& laid, bool isLeft);
  /** Whether a distance on an edge agrees with those at its ends. */
  bool isPossible(const Crossing& at, double offset) const;
  /** Whether a window with the line's source went on from an edge where it crosses it; also where
   * fronts do not divide. */
  bool hasPassed(const Crossing& at, double offset) const;

  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  const PassableTriangles& Passable;
  const Junctions& Divided;
  const DistanceField& Field;
  std::span<const SurfacePoint> Seeds;
  std::span<const Arrival> Arrivals;
  std::vector<SurfacePoint> Path;
  std::vector<Crossing> Open;
  /** The vertex at which the line ended; NoIndex at the seed. */
  Index Turn = NoIndex;
  Index Seed = NoIndex;
  /** By how much places that are one may differ. */
  double Tolerance = 0.0;
};

}

#endif
