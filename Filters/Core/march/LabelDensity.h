// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelDensity_h
#define geodesic_LabelDensity_h

namespace geodesic
{

class Partition;
class TriangleMesh;
struct SeedFront;

/**
 * Whether the labels of a front are so dense that the values which count are to be bounded (see
 * LabelBounds). Labels that crowd on a surface of at least 10,000 vertices are: those with, in the
 * mean, more than 4 of them within 10 mean edges, themselves included. Each would count at nearly
 * all vertices: 5 in a place take as long as 12 fields of one label, 24 as long as 150. Of more
 * than 24 labels those are dense as well that have fewer than 64 vertices each, or of which more
 * than 24 and more than a quarter of all start within 14 mean edges of another. If costs are
 * spread, up to 24 labels are never dense, and more of them are. It depends on the input alone, and
 * all pieces of the surface agree. Collective.
 * @param costsAreSpread  whether costs differ so much that the margins of dear vertices hold nearly
 *                        all labels
 */
bool labelsAreDense(
  const TriangleMesh& mesh, const SeedFront& front, bool costsAreSpread, Partition& partition);

/** Whether there are at least 64 vertices for each label. Collective. */
bool labelsHaveRoom(const TriangleMesh& mesh, const SeedFront& front, Partition& partition);

/** The spacing of labels: the side of a square of as many vertices as there are for each.
 * Collective.
 */
double labelSpacing(const TriangleMesh& mesh, const SeedFront& front, Partition& partition);

/**
 * Whether round labels are spread so evenly that few compete for a vertex, also without
 * labelReaches(). With their spacing, the side of a square of as many vertices as there are for
 * each label, no vertex is farther from all of them than twice the spacing, and in the mean at most
 * 8 labels share a cube of space of that side; of random ones some 3 to 5 do. Where edges differ
 * much, as needles or coarse parts do, the spacing is too large, and more share a cube. Collective.
 * @param farthest  the largest distance of a vertex, at cost 1, less the least value of a seed
 */
bool labelsAreSpread(
  const TriangleMesh& mesh, const SeedFront& front, double farthest, Partition& partition);

/**
 * Whether, of the labels that start in one triangle, the nearest one of what is behind a side may
 * be farther than others from both ends of the side by much of its length. So it is with points
 * that crowd in a triangle, and with lines across triangles that are long beside the spacing of
 * their points, as where edges differ much. Collective.
 */
bool labelsCompeteInTriangles(
  const TriangleMesh& mesh, const SeedFront& front, Partition& partition);

}

#endif
