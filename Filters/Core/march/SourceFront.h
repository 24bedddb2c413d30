// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceFront_h
#define geodesic_SourceFront_h

#include "base/Vector3.h"
#include "march/VertexState.h"
#include "solve/SeedFront.h"

#include <cmath>

namespace geodesic
{

/**
 * No way is shorter than the straight line to where a round front starts. Holding updates to that
 * keeps them monotone, and keeps rounding from growing from update to update where triangles lie on
 * each other over the source: there the update's slope exceeds 1.
 */
class StraightLineBound
{
public:
  StraightLineBound(const Label& label, double smallestCost)
    : Origin(label.position)
    , SquaredCost(label.shape == FrontShape::Round ? smallestCost * smallestCost : 0.0)
  {
  }

  /** @p value, or the bound at @p position where that is more. */
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

struct FrontGroup;

/** A label as a march asks for it. */
struct SourceFront
{
  /** @param bits as in VertexState; 0 where there is only one label */
  SourceFront(const Label& label, Index bits, double smallestCost)
    : seedValue(label.value)
    , leastOf(label, smallestCost)
    , labelBits(bits)
    , shape(label.shape)
  {
  }

  /** Among the labels of the march, where there are several. */
  Index number() const { return VertexState::labelOf(this->labelBits); }
  /** A value of the label as a distance. */
  double distance(double value) const { return value + this->seedValue; }

  double seedValue;
  StraightLineBound leastOf;
  Index labelBits;
  FrontShape shape;
  /** That its front belongs to. */
  FrontGroup* group = nullptr;
};

}

#endif
