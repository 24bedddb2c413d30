// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelReach_h
#define geodesic_LabelReach_h

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace geodesic
{

class Partition;
class TriangleMesh;
struct SeedFront;

/** How labels are thinned, see labelReaches(). All are in the longest edge round a place. */
struct LabelThinning
{
  /** The most by which a label that stays may be farther than one that ends. */
  double mostError;
  /** LabelReach::allowance of labels that last. */
  double allowance;
  /** How far a label has to be needed to last. */
  double lasting;
  /** What the bound of a vertex exceeds the least distance by, see LabelBounds. */
  double excess;
};

/** How far a label matters in a march of dense labels, see labelReaches() and LabelBounds. */
struct LabelReach
{
  bool isFinite() const { return this->value < std::numeric_limits<double>::infinity(); }

  /** The largest value of the label that is needed, without the value of its seed. */
  double value = std::numeric_limits<double>::infinity();
  /** By how much a distance of the label that counts may exceed the bound of its vertex. */
  double allowance = 0.0;
};

/**
 * Computes how far each label matters: the largest value of a label that a march of dense labels
 * needs (see LabelBounds), without the value of its seed.
 *
 * At a distance d from a row of points, a point that lies beside the nearest one by t is farther by
 * about t² / 2d. So the farther from a row, the fewer of its points are needed. The labels are
 * thinned in steps. In the step for a distance d, a label ends at d if in each direction, at d from
 * it, some label that stays is nearer than it or farther by at most a small part of an edge, or
 * another label is nearer still. What stays is thinned in the next step, for a distance half as
 * large again. Distances are in straight lines in the plane that touches the surface at the label:
 * near a label, where its neighbours are, the surface is almost flat. If a label ends at d, no
 * place beyond gets a distance that is larger by more than what the places at d do, since the
 * shortest line to it passes one of them.
 *
 * Labels that lie within a tenth of an edge of another one, of no larger value, end at once. So the
 * time does not depend on how many crowd in a face.
 *
 * A straight front between two round ones ends where the round ones are as good: a line of length l
 * is nearer than its ends by at most l² / 8d.
 *
 * What lasts for a number of edges or more stands for the many that end before. The place where it
 * is the nearest may be a strip narrower than an edge at first, at whose sides other labels are
 * nearer at all vertices. So that it comes through there, its distances have an allowance.
 *
 * All lengths are in the longest edge round the label. Everything is decided from the input and
 * from one number that does not depend on the order of the march, in the order of the labels.
 *
 * @param cost      of each vertex; empty for 1
 * @param farthest  the largest distance; labels that may matter up to it get +infinity
 * @param goesOn    called for each few hundred labels; when it returns false this ends, and what it
 *                  returns is of no use
 * @return one value for each label. All pieces of the surface get the same ones. Collective.
 * Time O(k log k) for k labels.
 */
std::vector<LabelReach> labelReaches(const TriangleMesh& mesh, const SeedFront& front,
  std::span<const double> cost, double farthest, const LabelThinning& thinning,
  const std::function<bool()>& goesOn, Partition& partition);

}

#endif
