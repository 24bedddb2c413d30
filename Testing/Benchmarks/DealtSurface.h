// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_DealtSurface_h
#define geodesic_testing_DealtSurface_h

#include "Surfaces.h"

#include <vector>

namespace geodesic::testing
{

/**
 * Cuts a surface into compact patches of equally many triangles, across the longest side of each
 * part's bounding box again and again, and deals them out to the ranks in turn.
 * @param patches the number of patches of each rank: with 1, ranks have compact pieces; with more,
 *                patches that lie beside each other are on different ranks
 * @return the rank of each triangle
 */
std::vector<int> dealt(const Surface& surface, int ranks, int patches);

/** A rank's part of a surface. */
struct Piece
{
  Surface surface;
  /** The numbers that the points have in the whole surface, in ascending order. */
  std::vector<Index> points;
};

/** The parts of a surface, one for each rank. */
std::vector<Piece> piecesOf(const Surface& surface, const std::vector<int>& owners, int ranks);

/** The points that triangles of several ranks have, in ascending order. */
std::vector<Index> pointsOnCuts(const Surface& surface, const std::vector<int>& owners);

}

#endif
