// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LineBounds_h
#define geodesic_LineBounds_h

#include "base/Index.h"
#include "march/LabelBounds.h"
#include "march/TriangleCost.h"
#include "solve/DistanceField.h"
#include "solve/SeedFront.h"
#include "solve/StartValue.h"

#include <span>
#include <vector>

namespace geodesic
{

class ClosedTriangles;
class OptionsOfMarches;
class Partition;
class StopLimit;
class TriangleMesh;

/**
 * Bounds of dense labels that need no first march. At cost 1 no distance is less than the straight
 * line through space to the nearest seed, and on a surface that is flat from one seed to the next
 * it is hardly more. So a part more than the line bounds the values that count.
 *
 * Whether it did is known after the march: where the least value of a vertex with the usual excess
 * is within the bound, no value that counts was kept away. Elsewhere, behind folds, holes and
 * barriers, the bound is raised: to the least way along edges from the vertices where it was not
 * too low, with the excess. Then the march goes on. Higher bounds only add values, and updates are
 * monotone, so it comes to the field that it would have found with these bounds from the start,
 * which does not depend on its order.
 */
class LineBounds
{
public:
  /** What a run on this piece of the surface is about. */
  struct Run
  {
    const TriangleMesh& mesh;
    const ClosedTriangles& closed;
    OptionsOfMarches& options;
    Partition& partition;
    const SeedFront& front;
    const UnitCost& cost;
    const StopLimit& limit;
  };

  /** @param bounds  gets the bounds; both must outlive this object */
  LineBounds(const Run& run, LabelBounds& bounds)
    : On(run)
    , Bounds(bounds)
  {
  }

  /**
   * Whether a front's labels can be bounded so: round ones of different seeds with the same value,
   * with space enough for each, on a surface without hubs (see hubVertices()) that is not
   * intrinsic. Collective.
   */
  static bool suit(const TriangleMesh& mesh, const SeedFront& front, Partition& partition);

  /** Sets the bounds, none less than a start at its vertex. @return false, with nothing done, where
   * labels are not spread over the surface. Collective. */
  bool set(std::span<const StartValue> starts);

  /**
   * Raises the bounds that were too low in a march within them, unless there are so many that two
   * marches take less, see areUseless(). Collective.
   * @param field   what the march has found
   * @param beside  gets the vertices, by distance, whose values may now go on to others
   */
  LabelBounds::Check raise(const DistanceField& field, std::vector<Index>& beside);
  /** Whether there were so many that the march was in vain. */
  bool areUseless() const { return this->AreUseless; }

private:
  double excess(Index vertex, double distance) const;
  /** The vertices whose bounds were too low in a march. */
  std::vector<Index> lowIn(const DistanceField& field) const;
  /** The least ways along edges to vertices whose bounds were too low. Collective.
   * @return false when cancelled */
  bool findWays(const DistanceField& field, std::span<const Index> low, DistanceField& ways) const;
  /** Raises bounds to ways. Collective. @return the vertices whose bound is now higher */
  std::vector<Index> raiseTo(const DistanceField& ways, std::span<const Index> low);
  /** Whether so few bounds were raised, and by so little, that it is worth going on. Collective. */
  bool isWorthwhile(std::span<const Index> raised, const DistanceField& ways) const;

  Run On;
  LabelBounds& Bounds;
  double SeedValue = 0.0;
  bool AreUseless = false;
};

}

#endif
