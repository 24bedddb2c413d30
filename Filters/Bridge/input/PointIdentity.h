// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PointIdentity_h
#define geodesic_bridge_PointIdentity_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "input/InputBlocks.h"

#include "vtkType.h"

#include <optional>
#include <span>
#include <vector>

namespace geodesic::bridge
{

/** The rule by which several points of an input are one vertex of the mesh. */
struct PointIdentity
{
  enum class By
  {
    Nothing,
    Coordinates,
    GlobalIds
  };

  By by = By::Nothing;
  /** Whether points of different blocks can be one vertex. */
  bool acrossBlocks = false;
  /** The rank that has this piece of the surface; none if the surface is in one piece. */
  std::optional<int> rank = {};

  friend bool operator==(const PointIdentity&, const PointIdentity&) = default;
};

/**
 * Chooses the rule: global ids if all pieces have them; otherwise coordinates if coincident points
 * are to be merged; otherwise nothing.
 */
PointIdentity::By identityBy(bool haveGlobalIds, bool mergeCoincidentPoints);

/**
 * Chooses the rule for the blocks of an input.
 * @throws std::invalid_argument if several blocks are to be connected and nothing tells which of
 * their points are the same
 */
PointIdentity identityOf(const InputBlocks& blocks, bool mergeCoincidentPoints, bool connectBlocks);

/**
 * Returns the global id of each point of all blocks; -1 in blocks without faces.
 * @pre blocks.haveGlobalPointIds()
 */
std::vector<vtkIdType> globalPointIdsOf(const InputBlocks& blocks);

/**
 * Returns for each point of all blocks the lowest point that is the same vertex.
 * @param points their coordinates
 * Time O(n log n).
 * @throws std::invalid_argument if points with the same global id are farther apart than by
 * rounding
 */
std::vector<Index> kindsOfPoints(
  const InputBlocks& blocks, const PointIdentity& identity, std::span<const Vector3> points);

}

#endif
