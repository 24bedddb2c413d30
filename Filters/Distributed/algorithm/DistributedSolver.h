// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DistributedSolver_h
#define geodesic_distributed_DistributedSolver_h

#include "ranks/RankGroup.h"
#include "solve/KnownValues.h"
#include "solve/Partition.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace geodesic::distributed
{

class DividedMesh;

/** The work of solving, over all ranks. */
struct DistributedWork
{
  /** How often the ranks marched and exchanged values. */
  std::size_t rounds = 0;
  /** The number of vertices taken from queues. */
  double updates = 0.0;
  /**
   * The updates that follow each other: the sum over all rounds of the most updates of any rank.
   * However fast messages are, the ranks take as long as one rank takes for so many updates.
   */
  double longestChain = 0.0;
  /** The number of bytes sent between neighbours. */
  double bytes = 0.0;
};

/**
 * Solves on a surface whose pieces are on several ranks. Each rank's local solver takes this object
 * as SolveOptions::partition; together their fields are one field of the whole surface.
 *
 * In each round every rank marches up to a common limit. Then it sends the values of shared
 * vertices that became lower to the ranks that share them, and a received value that is lower
 * starts the march there again. The solver is done when no rank has any work left. The limit
 * follows the least distance that is left, so that no rank marches far on values that will still
 * become lower. X. Yang, F. Stern, A highly scalable massively parallel fast marching method for
 * the Eikonal equation, J. Comput. Phys. 332 (2017). Because the update is monotone, the field is
 * that of the whole surface on one rank (to 1e-10).
 *
 * No rank ever holds more of the surface than its piece.
 */
class DistributedSolver final : public Partition
{
public:
  /** @param ranks,mesh must outlive this object */
  DistributedSolver(RankGroup& ranks, const DividedMesh& mesh);

  std::size_t number() const override { return static_cast<std::size_t>(this->Ranks.rank()); }
  bool isDivided() const override { return this->Ranks.size() > 1; }
  bool owns(Index vertex) const override;
  std::span<const Index> sharedVertices() const override;
  std::span<const float> longestSides() const override;
  void together(const std::function<void()>& step) override { this->Ranks.together(step); }
  std::vector<double> gather(std::span<const double> own) override
  {
    return this->Ranks.gather(own);
  }
  std::vector<StartValue> exchange(std::span<const StartValue> own) override;
  bool march(MarchingFront& front, StopLimit& limit) override;

  /** Returns the work since this object was made. Collective. */
  DistributedWork work();

private:
  /** Returns by how much the limit grows from round to round. Collective.
   * @param meanEdge  of this rank, see MarchingFront */
  double stepOf(double meanEdge);
  /**
   * Marches up to a distance; returns the number of updates.
   * @throws std::logic_error if there was something to do and none was made
   */
  double advance(MarchingFront& front, double end);
  /** Adds the slots beside the vertices that were taken to those whose values may have fallen. */
  void addTouched();
  /** Returns one message for each neighbour. */
  std::vector<RankGroup::Message> gatherNews(const MarchingFront& front);
  /** Returns how many values fell. */
  double takeNews(MarchingFront& front, const std::vector<RankGroup::Message>& received);

  RankGroup& Ranks;
  const DividedMesh& Mesh;
  std::vector<int> Partners;
  KnownValues Known;
  /** The vertices that were taken in this round. */
  std::vector<Index> Taken;
  /** The slots whose values may have fallen since the last messages, and for each slot whether it
   * is one of them. In the first round these are all, as they may have got values before. */
  std::vector<std::uint32_t> Touched;
  std::vector<bool> IsTouched;
  DistributedWork Own;
};

}

#endif
