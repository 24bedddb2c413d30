// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gather/InputCutter.h"

#include <optional>

namespace geodesic::distributed
{

InputCutter::InputCutter(
  RankGroup& ranks, const DistributedSurface& surface, const bridge::PathAttributes& input)
  : Ranks(ranks)
  , Surface(surface)
  , Input(input)
  , Cutter(surface.divided(), SolveOptions())
{
}

std::vector<SurfacePatch> InputCutter::cutOnAll(std::span<const GlobalVertex> vertices)
{
  const SharedPoints& shared = this->Surface.shared();
  return patchesOfAll(this->Ranks,
    [&]
    {
      std::vector<Index> local;
      for (const GlobalVertex& vertex : vertices)
      {
        if (const Index known = shared.find(vertex); known != NoIndex)
        {
          local.push_back(known);
        }
      }
      SurfacePatch patch = this->Cutter.cutRound(local, nullptr);
      for (PatchVertex& vertex : patch.vertices)
      {
        const Index number = shared.find(vertex.vertex);
        const std::optional<Vector3> normal = this->Input.normalOf(number);
        vertex.hasNormal = normal ? 1 : 0;
        vertex.normal = normal.value_or(Vector3{});
        vertex.id =
          this->Surface.piece().numbering().hasUniqueIds() ? this->Input.idOf(number) : -1;
      }
      return patch;
    });
}

}
