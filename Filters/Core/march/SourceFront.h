// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceFront_h
#define geodesic_SourceFront_h

#include "base/Vector3.h"
#include "march/VertexState.h"
#include "solve/SeedFront.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace geodesic
{

/**
 * A lower bound of a round front's values: no path is shorter than the straight line from the point
 * where the front starts. Raising updates to the bound leaves them monotone. It also keeps rounding
 * errors from growing with each update where triangles lie on each other over the source: there the
 * update's slope exceeds 1. A straight front has the bound 0.
 */
class StraightLineBound
{
public:
  /** @param smallestCost on all pieces of the surface */
  StraightLineBound(const Label& label, double smallestCost)
    : Origin(label.position)
    , SquaredCost(label.shape == FrontShape::Round ? smallestCost * smallestCost : 0.0)
  {
  }

  /** The larger of @p value and the bound at @p position. */
  double raised(double value, const Vector3& position) const
  {
    const Vector3 away = position - this->Origin;
    const double square = this->SquaredCost * dot(away, away);
    return value * value < square ? std::sqrt(square) : value;
  }

private:
  Vector3 Origin;
  double SquaredCost;
};

/** The least value of the seeds of labels. @pre there is a label */
inline double leastSeedValue(std::span<const Label> labels)
{
  return std::min_element(
    labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.value < b.value; })
    ->value;
}

/** A label with what a march needs to know of it. */
struct SourceFront
{
  /** @param bits of the label, see VertexState; 0 if it is the only one */
  SourceFront(const Label& label, Index bits, double smallestCost)
    : seedValue(label.value)
    , leastOf(label, smallestCost)
    , labelBits(bits)
    , shape(label.shape)
  {
  }

  /** The number of the label in SeedFront::labels. @pre there are several labels */
  Index number() const { return VertexState::labelOf(this->labelBits); }
  /** A value of the label as a distance: with the value of its seed. */
  double distance(double value) const { return value + this->seedValue; }

  /** The distance at the seed. */
  double seedValue;
  /** The largest value that counts; see LabelBounds. */
  double reach = std::numeric_limits<double>::infinity();
  /** By how much a distance that counts may exceed the bound of its vertex; see LabelBounds. */
  double allowance = 0.0;
  StraightLineBound leastOf;
  Index labelBits;
  FrontShape shape;
  /** The number of the group of fronts that it belongs to, see FrontQueues; NoIndex before its
   * first value. */
  Index group = NoIndex;
};

}

#endif
