// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalPoints_h
#define geodesic_distributed_GlobalPoints_h

#include "pieces/DistributedSurface.h"
#include "pieces/SharedPoints.h"
#include "ranks/RankGroup.h"
#include "solve/Seed.h"

#include "vtkType.h"

#include <array>
#include <span>
#include <string>
#include <vector>

class vtkDataObject;
class vtkIdList;

namespace geodesic::distributed
{

/** A point of the whole surface, as this rank knows it. */
struct GlobalPoint
{
  /** The same on all ranks. */
  Vector3 position;
  /** The point on this rank's piece: one, or none where the piece does not have it. */
  std::vector<SurfacePoint> local;
  /** The corners of a triangle that it lies in, and their weights; the same on all ranks. */
  std::array<GlobalVertex, 3> corners;
  std::array<double, 3> weights;
  /** The longest edge at any of the corners. */
  double longestEdge;

  bool isAt(const GlobalPoint& other) const
  {
    return this->corners == other.corners && this->weights == other.weights;
  }
};

/** Whether points are put where single precision can tell (see bridge::snappedAsSingle). */
enum class Precision
{
  Double,
  Single
};

/**
 * Positions projected to the nearest points of the surface on all ranks; of equally near ones that
 * of the smallest coordinates. Collective, with the same coordinates on all ranks.
 * @param property what gave them, for the message
 * @throws as bridge::positionsAt, on all ranks
 */
std::vector<GlobalPoint> globalPointsAt(RankGroup& ranks, const DistributedSurface& surface,
  std::span<const double> coordinates, const std::string& property,
  Precision precision = Precision::Double);

/**
 * The points of a data set, also of those on lines, as globalPointsAt in single precision. Those of
 * all ranks, one that a lower rank has as well counted once.
 * @param source null where this rank has none of it
 */
std::vector<GlobalPoint> globalPointsOf(RankGroup& ranks, const DistributedSurface& surface,
  vtkDataObject* source, const std::string& property);

/**
 * Gives points the corners and weights that they have on another mesh of the same surface.
 * Collective.
 * @param points here on that mesh
 */
void restate(RankGroup& ranks, const DividedMesh& mesh, std::vector<GlobalPoint>& points);

/** x y z of the points of all ranks, without those that a lower rank has as well. Collective. */
std::vector<double> pointsOfAll(RankGroup& ranks, const std::vector<double>& own);

/**
 * The points that have ids. On one rank these are the input's point ids, on several the global ids
 * of @p globalIds. Collective, with the same ids on all ranks.
 * @param role what the points are, for the message
 * @throws std::exception on all ranks for an id that is on none, or where there are no global ids
 */
std::vector<GlobalPoint> globalPointsWith(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::InputBlocks& blocks, vtkIdList* ids, const std::string& role);

/** A target of the front (see SolveOptions::targets). */
Triangle targetAt(const TriangleMesh& mesh, const std::vector<SurfacePoint>& local);

}

#endif
