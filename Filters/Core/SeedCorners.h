#ifndef geodesic_SeedCorners_h
#define geodesic_SeedCorners_h

#include "SolveOptions.h"

#include <span>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/** A vertex that a seed reaches in a straight line, through one triangle. */
struct SeedCorner
{
  Index vertex;
  Index seed;
  /** From the seed, without its value. */
  double distance;
};

/**
 * Where the front starts: for a seed at a vertex that vertex; for one on an edge the corners of all
 * the edge's triangles; for one inside a face the face's corners. Within a triangle the straight
 * line is the shortest, so these distances are final.
 * @throws std::invalid_argument naming the first seed whose triangle does not exist, whose weights
 *         are no barycentric weights, or whose value is negative or not finite
 */
std::vector<SeedCorner> seedCorners(const TriangleMesh& mesh, std::span<const Seed> seeds);

}

#endif
