// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StraightLines_h
#define geodesic_StraightLines_h

#include "base/BoundingBox.h"
#include "base/Index.h"
#include "base/Vector3.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace geodesic
{

/**
 * Finds for the vertices of a mesh the straight lines to the nearest of some places.
 *
 * Vertices with near numbers are near each other in space, so blocks of them are within small
 * boxes. A place is left out for a block, and for all blocks in it, where another one is nearer to
 * all of its box.
 */
class StraightLines
{
public:
  /** @param positions  of the vertices; must outlive this object. Time O(n) */
  explicit StraightLines(std::span<const Vector3> positions);

  /** Gets the number of the first vertex of a block, and for each of its vertices the square of the
   * length of its line. */
  using Visit = std::function<void(Index first, std::span<const double> squares)>;

  /**
   * Calls @p visit for each block that may have a vertex within a distance of a place, in order.
   * Time O(n) for all vertices and some hundred of them a place, and no more than O(n k) for k
   * places.
   * @param places  at least one
   * @param most    the distance
   */
  void measure(std::span<const Vector3> places, double most, const Visit& visit);

private:
  /** @param places  those that may be the nearest one of a vertex of the block */
  void measure(std::size_t level, std::size_t block, std::span<const Vector3> places,
    double mostSquare, const Visit& visit);
  void measureVertices(
    std::size_t block, std::span<const Vector3> places, const Visit& visit) const;

  std::span<const Vector3> Positions;
  /** The boxes of blocks, of blocks of blocks and so on; the last is one box. */
  std::vector<std::vector<BoundingBox>> Boxes;
  /** What is left of the places in the present block of each level. */
  std::vector<std::vector<Vector3>> Places;
};

}

#endif
