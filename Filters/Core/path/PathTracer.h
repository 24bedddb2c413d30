// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathTracer_h
#define geodesic_PathTracer_h

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
   * @param seeds the points from which the field was measured, by DistanceField::nearestSeed; all
   *              three must live as long as the tracer
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
  /** The next point of a path, and the distance to the seed through it. */
  struct Step
  {
    PathPoint point;
    /** Distance from the point to the seed. */
    double left;
    /** The same from where the step begins. */
    double total;
  };
  /** Where a step begins. */
  struct Place
  {
    Carriers carriers;
    Vector3 position;
  };
  /** What a step needs of a vertex to which it may lead. */
  struct Corner
  {
    Index vertex;
    /** See leadsToAim(). */
    bool leadsToAim;
    /** Distance from the vertex to the seed. */
    double left;
    const Vector3& position;
  };

  /** Sets Aim and AimCarriers. */
  void aimAt(Index seed);
  std::optional<SurfacePath> traceToAim(
    const PathPoint& start, PathOrder order, const MayEnd& mayEnd) const;
  /** Whether the vertex has a distance, and its nearest seed is Aim or Aim is any. */
  bool leadsToAim(Index vertex) const;
  /** The straight step to the nearest seed that shares an open face with the point; nothing if none
   * does. */
  std::optional<Step> stepToSeed(const PathPoint& point, PathOrder order) const;
  /** The step from the end of a path to the point with the least total on the edges of the faces
   * round it. It goes back across the face of the last step only where no other one will do, and
   * not a second time.
   * @param left  by the last step */
  std::optional<Step> stepAhead(const SurfacePath& path, double left) const;
  /** Replaces @p best by the step across a face if that has a lower total. */
  void tryFace(const Place& from, const Triangle& face, std::optional<Step>& best) const;
  /** The step to a neighbouring vertex with the least total; from a vertex only to lower distances.
   */
  std::optional<Step> stepAlongEdges(const PathPoint& point) const;
  /**
   * The path from a vertex that has no neighbour of a lower distance. There are such vertices where
   * the front came through the middle of an edge, or where neighbours lie at the same place.
   * @return the shortest path along edges to a vertex that has a lower distance or shares a face
   * with a seed, without @p vertex itself; empty if there is none
   */
  std::vector<Index> descentAlongEdges(Index vertex) const;
  Corner cornerAt(Index vertex) const
  {
    return { vertex, this->leadsToAim(vertex), this->Field.distance(vertex),
      this->Surface.mesh().position(vertex) };
  }
  /**
   * Replaces @p best by the step from a position to the best point inside an edge, if that has a
   * lower total.
   * @param cost of a unit of length of the step
   * @return whether there is such a point: steps to the edge's ends have no lower total then
   */
  bool tryEdge(const Vector3& position, const Corner& a, const Corner& b, double cost,
    std::optional<Step>& best) const;
  /** The same for the step to a vertex. */
  static void tryVertex(
    const Vector3& position, const Corner& corner, double cost, std::optional<Step>& best);

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
