// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LabelPlaces_h
#define geodesic_LabelPlaces_h

#include "base/Vector3.h"

#include <functional>
#include <span>
#include <vector>

namespace geodesic
{

class Partition;
class TriangleMesh;
struct SeedFront;

/** Where a label starts, as far as it matters for how far it reaches; see LabelReach.h. */
struct LabelPlace
{
  Vector3 position;
  /** Of the surface there, of length 1; or 0 if it has no direction. */
  Vector3 normal{ 0.0, 0.0, 0.0 };
  /** The longest edge there, and the largest cost. */
  double edge = 0.0;
  double cost = 0.0;
  /** The value of the seed as a length. */
  double value = 0.0;

  /** The price of an edge. */
  double unit() const { return this->edge * this->cost; }
};

/**
 * The places of all labels, in the order of the labels, from what each piece of the surface knows
 * of them. All pieces get the same ones. Collective.
 * @param cost    of each vertex; empty for 1
 * @param goesOn  called for each few hundred labels; once it has returned false, the places are of
 *                no use
 */
std::vector<LabelPlace> labelPlaces(const TriangleMesh& mesh, const SeedFront& front,
  std::span<const double> cost, const std::function<bool()>& goesOn, Partition& partition);

}

#endif
