// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineJoining_h
#define geodesic_IsolineJoining_h

#include "base/Index.h"
#include "path/Isolines.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** A part of a level in one face. */
struct LevelPiece
{
  /** A place where an edge has the level: a half-edge that stands for the edge, and 0 or 1. */
  using Node = std::pair<Index, Index>;

  std::array<Node, 2> ends;
  std::vector<Vector3> points;
  double length;
  /** The set of faces whose parts below the level are connected. */
  Index set;
  /** The set of the part of the face that is nearer than the level. */
  Index nearSet;
};

/**
 * Makes curves of the pieces of a level. Two pieces with a common end follow on each other; where
 * more meet, curves end.
 * @param areas     for each piece the area of its set
 * @param isolines  gets the curves, open ones first; those of no length are left out
 * Time O(k log k) for k pieces.
 */
void joinPieces(double level, std::span<const LevelPiece> pieces, std::span<const double> areas,
  std::vector<Isoline>& isolines);

}

#endif
