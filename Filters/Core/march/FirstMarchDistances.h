// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FirstMarchDistances_h
#define geodesic_FirstMarchDistances_h

#include <span>

namespace geodesic
{

class DistanceField;
class LabelBounds;
class Partition;
class TriangleMesh;
struct Label;
struct StartValue;

/** Which vertices take their distance in the first march, see takeFirstMarch(). */
enum class Taking
{
  /** Those that no label reached. */
  WhereNone,
  /** Also those where it is less than that of a label: a label that others bounded may have come by
   * a detour. */
  WhereLess,
  /** The same ones, with distances raised by what is known of them. For cost 1. */
  WhereLessRaised
};

/**
 * After a march within bounds (see LabelBounds), gives vertices the distance in the first march,
 * and those without one the nearest seed of a neighbour. Collective.
 *
 * Between seeds the first march is too short, as its front is straight from one to the other. At
 * cost 1 a distance is no less than the least in a straight line from the seeds from which it may
 * come, and no more than along an edge from a neighbour. So it can be raised to that straight line
 * from the nearest seeds of neighbours. Where this would be more than along the edge, the nearest
 * seed is another one, and vertices take the middle between the first march and the edge. What
 * labels have beside raised vertices may be more than along an edge: these are noted as vertices at
 * which a label ends.
 * @param starts  those of all labels; pieces that share a vertex have the same ones there
 */
void takeFirstMarch(const TriangleMesh& mesh, std::span<const Label> labels,
  std::span<const StartValue> starts, Taking taking, LabelBounds& bounds, Partition& partition,
  DistanceField& field);

}

#endif
