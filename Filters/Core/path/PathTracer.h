// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathTracer_h
#define geodesic_PathTracer_h

#include "path/BestStep.h"
#include "path/PathEnds.h"
#include "path/PathPoint.h"
#include "path/WeightedMesh.h"
#include "solve/DistanceField.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

/** Which points a traced path consists of. */
enum class PathOrder
{
  /** Vertices, along edges. */
  Vertices,
  /** Points on edges, across faces. */
  Edges
};

/**
 * Traces the shortest path from a point back to the nearest seed, by a field of distances that any
 * solver made.
 *
 * Across faces each step goes from p to the point q of a face's edges at which phi(q) + |p q| is
 * least, where phi is the distance from the flat point source that the edge's two values define.
 * That is the inverse of fast marching's update (see EikonalUpdate.h). The distance left falls from
 * step to step; where it would not, the path goes along edges until it does. So a trace always
 * ends.
 */
class PathTracer
{
public:
  /**
   * @param field distances, with one at every vertex near the path
   * @param seeds the points from which the field was measured, by DistanceField::nearestSeed. None
   *              if they are beyond the border of an incomplete mesh: no path ends at a seed then.
   *              All three must live as long as the tracer
   */
  PathTracer(const WeightedMesh& weighted, const DistanceField& field, const PathEnds& seeds)
    : Surface(weighted)
    , Field(field)
    , Seeds(seeds)
  {
  }

  using MayEnd = std::function<bool(const SurfacePath&)>;

  /**
   * The numbers of the seeds that are nearest to the corners of the faces round a point, the
   * likeliest first. One of them is the nearest to the point, unless the area to which a seed is
   * the nearest ends in a tip inside the face. None if the field does not reach the point.
   */
  std::vector<Index> seedsNear(const PathPoint& point) const;

  /**
   * @param seed one of seedsNear(); the path may end at another one if no trace leads to this one
   * @param mayEnd  whether the path may end at its last point, before it has come to a seed; asked
   *        after each step
   * @return the path from @p start to a seed, with both among its points; nothing if the field does
   *         not reach the start
   */
  std::optional<SurfacePath> trace(
    const PathPoint& start, Index seed, PathOrder order, const MayEnd& mayEnd = {});

private:
  /** Where a step begins. */
  struct Place
  {
    PathPoint point;
    Carriers carriers;
    Vector3 position;
  };

  /** Sets Aim and AimCarriers. */
  void aimAt(Index seed);
  std::optional<SurfacePath> traceToAim(
    const PathPoint& start, PathOrder order, const MayEnd& mayEnd) const;
  /** The straight step to the nearest seed that shares an open face with the point; nothing if none
   * does. */
  std::optional<PathStep> stepToSeed(const Place& from, PathOrder order) const;
  /** Whether a face may have both the vertices of a place and those of the aim: tells mostly, and
   * sooner than the faces are found, that none has. */
  bool mayReachAim(const Carriers& from) const;
  /** The step from the end of a path to the point with the least total on the edges of the faces
   * round it. It goes back across the face of the last step only where no other one will do, and
   * not a second time.
   * @param left  by the last step */
  std::optional<PathStep> stepAhead(const Place& from, const SurfacePath& path, double left) const;
  /** As stepAhead(), from a vertex, and from a point of an edge. */
  void tryRoundVertex(Index vertex, BestStep& best) const;
  void tryBesideEdge(
    const Carriers& ends, const SurfacePath& path, double left, BestStep& best) const;
  StepFace faceOf(const Triangle& corners) const;
  /** Tries the steps from a point inside a face. */
  void tryFace(const Triangle& face, BestStep& best) const;
  /** The step to a neighbouring vertex with the least total; from a vertex only to lower distances.
   */
  std::optional<PathStep> stepAlongEdges(const Place& from) const;
  /**
   * The path from a vertex that has no neighbour of a lower distance. There are such vertices where
   * the front came through the middle of an edge, or where neighbours lie at the same place.
   * @return the shortest path along edges to a vertex that has a lower distance or shares a face
   * with a seed, without @p vertex itself; empty if there is none
   */
  std::vector<Index> descentAlongEdges(Index vertex) const;
  Place placeAt(const PathPoint& point) const
  {
    return { point, point.carriers(), point.position(this->Surface.mesh()) };
  }
  StepCorner cornerAt(Index vertex) const
  {
    const Index seed = this->Field.nearestSeed(vertex);
    const bool leadsToAim = this->Aim == NoIndex || seed == this->Aim;
    return { vertex, leadsToAim ? seed : NoIndex, this->Field.distance(vertex),
      &this->Surface.mesh().position(vertex) };
  }

  const WeightedMesh& Surface;
  const DistanceField& Field;
  const PathEnds& Seeds;
  /** The number of the seed at which the path is to end; NoIndex for any seed. */
  Index Aim = NoIndex;
  /** Those of that seed. */
  Carriers AimCarriers;
};

}

#endif
