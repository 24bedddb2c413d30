// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeedFront_h
#define geodesic_SeedFront_h

#include "base/Vector3.h"
#include "solve/Seed.h"

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class Partition;
class TriangleMesh;

/** The shape of a front: round, from a point, or straight, from a line or region. */
enum class FrontShape
{
  Round,
  Straight
};

/** A part of a seed whose front marches by itself, with values apart from those of other labels. */
struct Label
{
  /** The number of the seed. */
  Index seed;
  FrontShape shape;
  /** The seed's value. */
  double value;
  /** Where a round front starts. Its triangle is NoIndex where only other pieces have the point. */
  SurfacePoint origin;
  /** The position of a round front's origin, known on all pieces. */
  Vector3 position;
  /** The length of a straight front's line if round fronts start at both ends; else infinity. */
  double length = std::numeric_limits<double>::infinity();
};

/** A vertex that a label reaches in a straight line, through one triangle. */
struct FrontStart
{
  Index vertex;
  Index label;
  /** Length of the straight line, without the label's value. */
  double length;
};

/**
 * The labels of all seeds, and the vertices where their fronts start.
 *
 * A point makes one round label, which starts at the point's vertex, at the corners of all
 * triangles of its edge, or at the corners of its face. A curve makes one straight label for each
 * straight part, which starts at the corners of the triangles that the part touches, and a round
 * label at each end and bend. A region makes one straight label at its vertices, a round one at
 * each isolated vertex and, if its border is small, one at each vertex of the border. Within a
 * triangle the straight line is the shortest, so that lengths are final.
 */
struct SeedFront
{
  std::vector<Label> labels;
  std::vector<FrontStart> starts;
};

/** How often makeSeedFront() calls goesOn(). */
inline constexpr std::size_t PointsOfFrontReport = 4096;

/**
 * Makes labels and starts of seeds. Labels are the same on all pieces of the surface; starts are
 * those of this piece. Collective; the number of collective calls does not depend on the number of
 * seeds.
 * @pre checkSeeds() has accepted the seeds
 * @param closed triangles that no front crosses; none starts through them either
 * @param joinsCurves  see SolveOptions::numbersSeeds
 * @param goesOn called for each few thousand points and vertices of seeds; once it has returned
 * false, the front is of no use
 * @param front  gets the labels and starts; what it held is lost, but its memory is used again
 */
void makeSeedFront(const TriangleMesh& mesh, const ClosedTriangles& closed,
  std::span<const Seed> seeds, bool joinsCurves, const std::function<bool()>& goesOn,
  Partition& partition, SeedFront& front);

}

#endif
