// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LineBounds_h
#define geodesic_LineBounds_h

#include "base/Index.h"
#include "march/LabelBounds.h"
#include "march/StraightLines.h"
#include "march/TriangleCost.h"
#include "solve/DistanceField.h"
#include "solve/SeedFront.h"
#include "solve/StartValue.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

class OptionsOfMarches;
class Partition;
class StopLimit;
class TriangleMesh;

/**
 * Bounds of dense labels that need no first march. At cost 1 no distance is less than the straight
 * line through space to the nearest seed, and on a surface that is flat from one seed to the next
 * it is hardly more. So a part more than the line bounds the values that count, up to twice the
 * spacing of labels.
 *
 * Whether it did is known after the march: where the least value of a vertex with the usual excess
 * is within the bound, no value that counts was kept away. Elsewhere, behind folds, holes and
 * barriers and far from all seeds, a first march goes on from the vertices where it was, and raises
 * the bounds: to its distances with the excess; beyond twice the spacing labels end with
 * labelReaches(). Then the march of labels goes on. Higher bounds only add values, and updates are
 * monotone, so it comes to the field that it would have found with these bounds from the start,
 * which does not depend on its order. Neither does it depend on a stop beyond.
 */
class LineBounds
{
public:
  /** What a run on this piece of the surface is about. */
  struct Run
  {
    const TriangleMesh& mesh;
    OptionsOfMarches& marches;
    Partition& partition;
    const SeedFront& front;
    const UnitCost& cost;
    const StopLimit& limit;
  };
  /** A first march of a part, with a flag for each vertex that is not to be marched over.
   * Collective. @return its field, or null when cancelled */
  using Marching = std::function<const DistanceField*(
    std::span<const StartValue> starts, std::span<const std::uint8_t> excluded)>;

  /** @param bounds  gets the bounds; must outlive this object, as all of the run */
  LineBounds(const Run& run, LabelBounds& bounds, Marching marching)
    : On(run)
    , Bounds(bounds)
    , March(std::move(marching))
  {
  }

  /**
   * Whether a front's labels can be bounded so: round ones of different seeds with the same value,
   * with space enough for each, on a surface that is not intrinsic. Collective.
   * @pre no vertex is a hub (see hubVertices())
   */
  static bool suit(const TriangleMesh& mesh, const SeedFront& front, Partition& partition);

  /** Sets the bounds, none less than a start at its vertex. Collective. @param lines  of the mesh
   */
  void set(StraightLines& lines, std::span<const StartValue> starts);

  /**
   * Raises the bounds that were too low in a march within them. Collective.
   * @param field   what the march has found
   * @param beside  gets the vertices whose values may now go on to others
   */
  LabelBounds::Check raise(const DistanceField& field, std::vector<Index>& beside);

private:
  /** Finds the largest bound without a seed's value. Collective. */
  void findMost(std::span<const StartValue> starts);
  /** The largest of the numbers of all pieces. Collective. */
  double mostOfAll(double own) const;
  double excess(Index vertex, double distance) const;
  /** The vertices whose bounds were too low in a march. */
  std::vector<Index> lowIn(const DistanceField& field) const;
  /** The starts of a first march to these vertices: those of them that were reached, and the others
   * beside them. @param isLow  a flag for each vertex */
  std::vector<StartValue> startsOfWays(const DistanceField& field, std::span<const Index> low,
    const std::vector<std::uint8_t>& isLow) const;
  /** Sets bounds of labels. Collective. */
  void boundLabels(const DistanceField& ways);
  /** Raises bounds to ways. Collective. @return whether any is now higher on this piece */
  bool raiseTo(const DistanceField& ways, std::span<const Index> low);

  Run On;
  LabelBounds& Bounds;
  Marching March;
  double SeedValue = 0.0;
  double Most = 0.0;
};

}

#endif
