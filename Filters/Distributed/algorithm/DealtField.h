// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_DealtField_h
#define geodesic_distributed_DealtField_h

#include "pieces/DealtSurface.h"
#include "pieces/DividedMesh.h"
#include "ranks/RankGroup.h"
#include "solve/DistanceField.h"

#include <memory>
#include <optional>

namespace geodesic::distributed
{

/**
 * A surface whose triangles are dealt out to the ranks anew, and the field on the pieces as they
 * were before. It is kept from run to run.
 */
class DealtField
{
public:
  /** Deals the surface out, unless it is dealt out so already. Collective. */
  void deal(
    RankGroup& ranks, const std::shared_ptr<const DividedMesh>& pieces, const Dealing& dealing)
  {
    if (ranks.isAny(
          !this->Dealt || this->Dealt->origin() != pieces || !(this->Dealt->dealing() == dealing)))
    {
      this->Dealt = std::make_unique<const DealtSurface>(ranks, pieces, dealing);
      this->OfPiece.emplace(pieces->mesh().numberOfVertices());
    }
  }

  const DealtSurface& surface() const { return *this->Dealt; }

  /**
   * Brings a field on the dealt triangles back to the pieces. Collective.
   * @param solved  null on a rank that solved nothing
   * @return the field on this rank's piece, until the next call
   */
  const DistanceField& takeBack(RankGroup& ranks, const DistanceField* solved, StopReason reason)
  {
    this->Dealt->takeBack(ranks, solved, reason, *this->OfPiece);
    return *this->OfPiece;
  }

  void clear()
  {
    this->Dealt.reset();
    this->OfPiece.reset();
  }

private:
  std::unique_ptr<const DealtSurface> Dealt;
  std::optional<DistanceField> OfPiece;
};

}

#endif
