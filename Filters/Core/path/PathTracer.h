// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathTracer_h
#define geodesic_PathTracer_h

#include "path/PathPoint.h"
#include "path/WeightedMesh.h"
#include "solve/DistanceField.h"

#include <optional>
#include <span>
#include <vector>

namespace geodesic
{

/** What a traced path may run through. */
enum class PathOrder
{
  /** Vertices, along edges. */
  Vertices,
  /** Points on edges, across faces. */
  Edges
};

/**
 * Traces the shortest way from a point back to the nearest seed, down a field of distances that any
 * solver made.
 *
 * Across faces each step goes to the point of a face's edges where phi + |p q| is least, phi being
 * the distance from the flat point source that the edge's two values define: the update of fast
 * marching, turned round (see EikonalUpdate.h). The value falls from step to step; where it would
 * not, the path goes along edges until it does. So a trace always ends.
 */
class PathTracer
{
public:
  /**
   * @param field with a distance at every vertex on the way
   * @param seeds the points it was measured from, by the numbers of DistanceField::nearestSeed
   */
  PathTracer(
    const WeightedMesh& weighted, const DistanceField& field, std::span<const PathPoint> seeds)
    : Surface(weighted)
    , Field(field)
    , Seeds(seeds)
  {
  }

  /**
   * The numbers of the seeds that are nearest to the corners round a point, the likeliest first:
   * one of them is the nearest to the point, but where the places that a seed is the nearest to end
   * in a tip inside the face. None where the field does not reach the point.
   */
  std::vector<Index> seedsNear(const PathPoint& point) const;

  /**
   * @param seed one of seedsNear; the path may end at another where no trace leads to this one
   * @return the path from @p start to a seed, both among its points; none where the field does not
   * reach the start
   */
  std::optional<SurfacePath> trace(const PathPoint& start, Index seed, PathOrder order);

private:
  /** A point to go on to, and the distance to the seed by way of it. */
  struct Step
  {
    PathPoint point;
    /** Distance left at the point. */
    double left;
    /** The same at where the step begins. */
    double total;
  };

  std::optional<SurfacePath> traceToAim(const PathPoint& start, PathOrder order) const;
  /** Whether the vertex has a distance, and from the seed that is aimed at. */
  bool leadsToAim(Index vertex) const;
  /** A seed in a face with the point, and what is left to it. */
  std::optional<Step> stepToSeed(const PathPoint& point) const;
  std::optional<Step> stepAcrossFaces(const PathPoint& point) const;
  /** To a vertex of a lower distance. */
  std::optional<Step> stepAlongEdges(const PathPoint& point) const;
  /**
   * A vertex may be nearer to the seed than all its neighbours: where the front came through the
   * middle of an edge, or neighbours lie on it.
   * @return the shortest way along edges to a vertex of a lower distance, or one that shares a face
   * with a seed, without @p vertex itself
   */
  std::vector<Index> wayDown(Index vertex) const;
  void tryEdge(const PathPoint& point, const Triangle& face, Index a, Index b,
    std::optional<Step>& best) const;
  void tryVertex(
    const PathPoint& point, Index vertex, double cost, std::optional<Step>& best) const;

  const WeightedMesh& Surface;
  const DistanceField& Field;
  std::span<const PathPoint> Seeds;
  /** The number of the seed that the path is to end at; NoIndex: any. */
  Index Aim = NoIndex;
};

}

#endif
