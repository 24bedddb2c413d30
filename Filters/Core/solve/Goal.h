// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Goal_h
#define geodesic_Goal_h

#include "base/BoundingBox.h"
#include "base/Vector3.h"
#include "mesh/TriangleMesh.h"
#include "solve/SolveOptions.h"

#include <algorithm>

namespace geodesic
{

/**
 * Where the targets of a march lie: in a ball. What is left of a path from a point to a target is
 * at least as long as a straight line to the ball, times the least cost. A vertex matters for paths
 * to targets only if its distance and what is left are together within the largest distance of a
 * target. Where the surface is flat these vertices lie in an ellipse with seed and target as foci.
 */
class Goal
{
public:
  /** No goal, so that nothing is left anywhere. */
  Goal() = default;

  /** The ball of the targets. Time linear in the number of targets and, with costs, of vertices. */
  Goal(const TriangleMesh& mesh, const SolveOptions& options)
    : LeastCost(
        options.cost.empty() ? 1.0 : *std::min_element(options.cost.begin(), options.cost.end()))
  {
    const auto visitCorners = [&](const auto& visit)
    {
      for (const Triangle& target : options.targets)
      {
        std::for_each(
          target.begin(), target.end(), [&](Index corner) { visit(mesh.position(corner)); });
      }
    };
    BoundingBox box;
    visitCorners([&](const Vector3& position) { box.add(position); });
    this->Middle = box.low + 0.5 * (box.high - box.low);
    visitCorners([&](const Vector3& position)
      { this->Radius = std::max(this->Radius, norm(position - this->Middle)); });
  }

  bool isKnown() const { return this->LeastCost > 0.0; }
  const Vector3& middle() const { return this->Middle; }

  /** The least that is left of a path to a target.
   * @param length  from its beginning to the middle of the ball, in a straight line */
  double leftOf(double length) const
  {
    constexpr double rounding = 1e-9;
    // In this order, NaN is nothing left: a vertex without a position.
    return this->LeastCost * std::max(0.0, (1.0 - rounding) * length - this->Radius);
  }
  double leftFrom(const Vector3& position) const
  {
    return this->isKnown() ? this->leftOf(norm(position - this->Middle)) : 0.0;
  }

private:
  Vector3 Middle{};
  double Radius = 0.0;
  /** 0 where there is no goal. */
  double LeastCost = 0.0;
};

}

#endif
