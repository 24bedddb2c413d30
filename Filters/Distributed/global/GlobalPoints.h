// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_GlobalPoints_h
#define geodesic_distributed_GlobalPoints_h

#include "base/ThreadTeam.h"
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

/** A point of the whole surface, and its place on this rank's piece. */
struct GlobalPoint
{
  /** The same on all ranks. */
  Vector3 position;
  /** The point on this rank's piece; empty if the piece does not contain the point. */
  std::vector<SurfacePoint> local;
  /**
   * The corners of a triangle that contains the point, and their weights; the same on all ranks.
   */
  std::array<GlobalVertex, 3> corners;
  std::array<double, 3> weights;
  /** The longest edge at any of the corners. */
  double longestEdge;

  friend bool operator==(const GlobalPoint&, const GlobalPoint&) = default;
};

/**
 * Whether points are snapped to edges and vertices in single precision, see
 * bridge::snappedAsSingle().
 */
enum class Precision
{
  Double,
  Single
};

/**
 * Projects positions to the nearest points of the surface on all ranks. Of equally near points, the
 * one with the smallest coordinates is taken. Collective; all ranks must pass the same coordinates.
 * @param property name of the coordinates in the error message
 * @param team shares many positions
 * @throws as bridge::positionsAt(), on all ranks
 */
std::vector<GlobalPoint> globalPointsAt(RankGroup& ranks, const DistributedSurface& surface,
  std::span<const double> coordinates, const std::string& property,
  Precision precision = Precision::Double, const ThreadTeam& team = ThreadTeam(1));

/**
 * Projects the points of a data set, with those of its lines, as globalPointsAt() does in single
 * precision. Returns the points of all ranks; a point that a lower rank has, too, is left out.
 * Collective.
 * @param source null if this rank has no part of the data set
 */
std::vector<GlobalPoint> globalPointsOf(RankGroup& ranks, const DistributedSurface& surface,
  vtkDataObject* source, const std::string& property);

/**
 * Sets the corners and weights of points to those on another mesh of the same surface. Collective.
 * @param points their member local must refer to that mesh
 */
void restate(RankGroup& ranks, const DividedMesh& mesh, std::vector<GlobalPoint>& points);

/**
 * Returns x y z of the points of all ranks in turn; a point that a lower rank has, too, is left
 * out. Collective.
 */
std::vector<double> pointsOfAll(RankGroup& ranks, const std::vector<double>& own);

/**
 * Returns the points with the given ids: the input's point ids on one rank, global ids on several
 * ranks. Collective; all ranks must pass the same ids.
 * @param role name of the points in error messages
 * @throws std::exception on all ranks if no rank has a point with an id, or if there are several
 * ranks and no global ids
 */
std::vector<GlobalPoint> globalPointsWith(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::InputBlocks& blocks, vtkIdList* ids, const std::string& role);

/** Returns the target of a march (see SolveOptions::targets) for GlobalPoint::local. */
Triangle targetAt(const TriangleMesh& mesh, const std::vector<SurfacePoint>& local);

}

#endif
