// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_PointIdentity_h
#define geodesic_bridge_PointIdentity_h

#include "base/Index.h"
#include "base/Vector3.h"
#include "input/InputBlocks.h"

#include "vtkType.h"

#include <optional>
#include <vector>

namespace geodesic::bridge
{

/** Which points of an input are one and the same to the front. */
struct PointIdentity
{
  enum class By
  {
    Nothing,
    Coordinates,
    GlobalIds
  };

  By by = By::Nothing;
  bool acrossBlocks = false;
  /** The rank that has this piece of a surface; none: the surface is in one piece. */
  std::optional<int> rank = {};

  friend bool operator==(const PointIdentity&, const PointIdentity&) = default;
};

/**
 * The rule: by global ids where all pieces have them, else by coordinates where coincident points
 * are to be merged, else by nothing.
 */
PointIdentity::By identityBy(bool haveGlobalIds, bool mergeCoincidentPoints);

/**
 * The rule for the blocks of an input.
 * @throws std::invalid_argument where several blocks are to be connected and nothing tells which of
 * their points are one
 */
PointIdentity identityOf(const InputBlocks& blocks, bool mergeCoincidentPoints, bool connectBlocks);

/**
 * The global id of each point of all blocks, which must have them (see
 * InputBlocks::haveGlobalPointIds); -1 in blocks without faces.
 */
std::vector<vtkIdType> globalPointIdsOf(const InputBlocks& blocks);

/**
 * For each point of all blocks the lowest one that it is the same as.
 * @param points their coordinates
 * @throws std::invalid_argument where points of one global id are far apart
 * Time O(n log n).
 */
std::vector<Index> kindsOfPoints(
  const InputBlocks& blocks, const PointIdentity& identity, const std::vector<Vector3>& points);

}

#endif
