// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_PiecewisePaths_h
#define geodesic_distributed_PiecewisePaths_h

#include "algorithm/DistributedPathFinder.h"
#include "algorithm/FoundPath.h"
#include "algorithm/PartialSearch.h"
#include "gather/CorridorMesh.h"
#include "gather/PatchCutter.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace geodesic::distributed
{

/** Two points that a path is to join. */
struct PointPair
{
  GlobalPoint from;
  GlobalPoint to;
};

/**
 * Finds many paths, each between two points near each other, on a surface whose pieces are on
 * several ranks. Each rank finds those on its piece by itself, at the same time as the others. The
 * first rank finds those that cross from one piece to another, many together, on a corridor of
 * balls round the straight lines between the points. Either is known to be the path on the whole
 * surface where the part is enough, see PartialSearch; of others nothing is known.
 *
 * A field that all ranks solve together takes some ten rounds of messages, for each path.
 */
class PiecewisePaths
{
public:
  /**
   * Whether paths can be found so: on several ranks, without gathered triangles and without a whole
   * surface, and with costs that hardly differ from a vertex to the next. Where they jump, a field
   * depends on costs far beside it (see Detours). Collective.
   */
  static bool suit(const PathRequest& request);
  /**
   * @param request  that suits. It has progress to report
   * @param fromBothEnds see PathSearches::between()
   */
  PiecewisePaths(const PathRequest& request, bool fromBothEnds);

  /** Collective; all ranks must pass the same pairs. */
  std::vector<FoundPath> find(std::span<const PointPair> pairs);
  /** The paths on the surface of the input, on the first rank; none where there is none.
   * Collective.
   */
  std::vector<std::optional<TracedPath>> onInput(std::span<const FoundPath> found);

  /** See DistributedPathFinder. */
  std::size_t largestCorridor() const { return this->LargestCorridor; }

private:
  class PieceSearch;

  /** Finds paths on the pieces. @param ranksOfPairs  the rank that is to search for each */
  void findOnPieces(std::span<const PointPair> pairs, std::span<const double> ranksOfPairs,
    std::span<FoundPath> found);
  /** Finds the unknown ones on corridors. @param width of these, in units of the usual one */
  void findAcross(std::span<const PointPair> pairs, double width, std::span<FoundPath> found);
  /** For each pair how many points of all ranks its balls hold. Collective. */
  std::vector<double> pointsOfBalls(
    std::span<const PointPair> pairs, std::span<const Index> numbers, double width);
  /** Finds some on a corridor of the first rank. Collective. */
  void findOnCorridor(std::span<const PointPair> pairs, std::span<const Index> numbers,
    double width, std::span<FoundPath> found);
  SolveOptions optionsOn(const SolveOptions& part);
  /** Reports progress. @param steps since those of the searches before @return whether to go on */
  bool report(std::size_t steps);
  /** The same by all ranks, which go on together. Collective.
   * @param searches  how many of those of all ranks have been made */
  bool allGoOn(double searches);

  PathRequest Request;
  bool FromBothEnds;
  bool HasCost;
  PatchCutter Cutter;
  /** The steps that are reported of the searches before. */
  std::size_t StepsBefore = 0;
  bool IsCancelled = false;
  std::size_t LargestCorridor = 0;
};

}

#endif
