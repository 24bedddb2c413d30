// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeedFront_h
#define geodesic_SeedFront_h

#include "base/Vector3.h"
#include "solve/Seed.h"

#include <span>
#include <string>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class Partition;
class TriangleMesh;

/** How a front was born: round a point, or from a line, which it leaves in a straight front. */
enum class FrontShape
{
  Round,
  Straight
};

/** A part of a seed whose front is marched by itself, apart from the other labels'. */
struct Label
{
  Index seed;
  FrontShape shape;
  /** The seed's value. */
  double value;
  /** Where a round front starts; no triangle where that is on other pieces of the surface only. */
  SurfacePoint origin;
  Vector3 position;
};

/** A vertex that a label reaches in a straight line, through one triangle. */
struct FrontStart
{
  Index vertex;
  Index label;
  /** Length from the label, without its value. */
  double length;
};

/**
 * Where the fronts of the seeds start.
 *
 * A point is one round label: it starts at the point's vertex, at the corners of all triangles of
 * its edge, or at the corners of its face. A curve is one straight label for each straight piece,
 * which starts at the corners of the triangles that the piece touches, and a round one at each end
 * and bend. A region is one straight label at its vertices, and a round one for each isolated
 * vertex and, on small regions, for each vertex of its border. Within a triangle the straight line
 * is the shortest, so lengths are final.
 */
struct SeedFront
{
  std::vector<Label> labels;
  std::vector<FrontStart> starts;
};

/**
 * @throws std::invalid_argument naming the first seed that is none: without points, in a triangle
 * that does not exist, of weights that are no barycentric weights, of a value that is negative or
 * not finite
 */
void checkSeeds(const TriangleMesh& mesh, std::span<const Seed> seeds, const Partition& partition);

/**
 * The labels are the same on all pieces of the surface, the starts those of this one.
 * @pre the seeds are checked
 * @param closed triangles that no front crosses, nor starts through
 * @throws std::invalid_argument for a curve with a segment that is neither in one face nor along
 * one edge
 */
SeedFront seedFront(const TriangleMesh& mesh, const ClosedTriangles& closed,
  std::span<const Seed> seeds, Partition& partition);

/** The vertices whose weights carry the point: a vertex, the ends of an edge, a face's corners. */
std::vector<Index> carriersOf(const TriangleMesh& mesh, const SurfacePoint& point);

}

#endif
