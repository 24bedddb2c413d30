// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DistributedSolver_h
#define geodesic_distributed_DistributedSolver_h

#include "ranks/RankGroup.h"
#include "solve/Partition.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace geodesic::distributed
{

class DividedMesh;

/** What solving on several ranks took, over all of them. */
struct DistributedWork
{
  /** Times that the ranks marched and exchanged values. */
  std::size_t rounds = 0;
  /** Vertices taken from queues. */
  double updates = 0.0;
  /** Sent from neighbour to neighbour. */
  double bytes = 0.0;
};

/**
 * Solves on a surface whose pieces are on several ranks: given to the local solver of each rank as
 * SolveOptions::partition, it makes their fields one.
 *
 * In each round every rank marches up to a common limit and sends the values of shared vertices
 * that fell to the ranks that share them; lower ones start the march again. Done when no rank has
 * anything left. The limit grows with what is left, so that no rank marches far on values that
 * will still fall. X. Yang, F. Stern, A highly scalable massively parallel fast marching method for
 * the Eikonal equation, J. Comput. Phys. 332 (2017). As the update is monotone the field is that of
 * the whole surface on one rank (to 1e-10).
 *
 * No rank ever holds more of the surface than its piece.
 */
class DistributedSolver final : public Partition
{
public:
  /** @param ranks and @param mesh must live as long as this */
  DistributedSolver(RankGroup& ranks, const DividedMesh& mesh);

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

  /** Since this was made. Collective. */
  DistributedWork work();

private:
  /** A value as it was last sent to or heard from those that share the vertex. */
  struct KnownValue
  {
    Index label;
    double value;
  };

  /** By how much the limit grows from round to round. */
  double stepOf(const MarchingFront& front);
  void exchangeNews(MarchingFront& front);
  /** One message for each neighbour. */
  std::vector<RankGroup::Message> gatherNews(const MarchingFront& front);
  /** Whether a value is lower than what those that share the slot know; then they will know it. */
  bool isNews(std::uint32_t slot, Index label, double value);

  RankGroup& Ranks;
  const DividedMesh& Mesh;
  std::vector<int> Partners;
  std::vector<std::vector<KnownValue>> Known;
  DistributedWork Own;
};

}

#endif
