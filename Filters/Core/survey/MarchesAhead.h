// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_MarchesAhead_h
#define geodesic_MarchesAhead_h

#include "base/Index.h"
#include "methods/SolverTeam.h"
#include "solve/SolveOptions.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/** A vertex and its distance from a sample. */
struct NearerVertex
{
  Index vertex;
  double distance;
};

/**
 * The marches of samples, on threads: together with the march of the sample that was taken, those
 * of vertices that are likely to be samples soon. What such a march finds is true also when
 * distances have fallen since, so it is kept until its turn comes, or until the vertex itself has
 * fallen: then another sample came near, and the vertex will hardly be one.
 *
 * Which marches are made together does not depend on the number of threads, so that the samples do
 * not either.
 */
class MarchesAhead
{
public:
  /** @param solvers    prepared, on a surface in one piece
   * @param distances  the distances of all vertices from the samples so far */
  MarchesAhead(SolverTeam& solvers, std::span<const double> distances)
    : Solvers(solvers)
    , Distances(distances)
    , HasMarched(solvers.numberOfThreads())
  {
  }

  /** Whether it gains to make marches ahead. They become shorter with each sample; those of fewer
   * than about ten vertices take no longer than to choose them. */
  bool gains() const { return !this->HasFailed && (this->Size == 0 || this->Size >= LeastSize); }
  /** How many marches are to be made together: enough to pay for starting threads, and for 16 of
   * them. */
  std::size_t sizeOfBatch() const;
  /** Whether the march from a vertex has been made. */
  bool isMade(Index vertex) const { return this->Made.contains(vertex); }
  /**
   * Marches from some vertices, from each for itself. Where one ahead fails, as it needs more than
   * its part of the memory, it is left out, and no more are made ahead from then on.
   * @param vertices   the first one is the sample
   * @param options    for each march; usefulBelow is the distances
   * @param mayGoOn    called by the calling thread now and then; false cancels all
   * @return false when cancelled
   * @throws whatever the sample's march throws alone
   */
  bool march(std::span<const Index> vertices, const SolveOptions& options,
    const std::function<bool()>& mayGoOn);
  /** What the march from a vertex has found to be nearer to it. @pre isMade() */
  std::vector<NearerVertex> take(Index vertex);

private:
  static constexpr std::size_t LeastSize = 10;

  /** A march that was made. */
  struct March
  {
    bool isWhole = false;
    /** The vertex's own distance then. */
    double distance = 0.0;
    std::vector<NearerVertex> nearer{};
  };

  March marchFrom(Index vertex, SolveOptions options, std::size_t thread);
  /** Drops the marches from vertices whose distance has fallen. */
  void dropFallen();

  SolverTeam& Solvers;
  std::span<const double> Distances;
  std::unordered_map<Index, March> Made;
  /** For each thread whether its solver has marched here. */
  std::vector<std::uint8_t> HasMarched;
  /** Of the last marches, the mean number of vertices. */
  std::size_t Size = 0;
  bool HasFailed = false;
};

}

#endif
