// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/WholeSurface.h"

#include "gather/Corridor.h"
#include "gather/PatchCutter.h"
#include "methods/SolverTable.h"

#include <limits>
#include <vector>

namespace geodesic::distributed
{

WholeSurface::WholeSurface(RankGroup& ranks, const DividedMesh& pieces, const SolveOptions& options,
  const SolverTraits& method)
{
  const bool hasCost = ranks.isAny(!options.cost.empty());
  const PatchCutter cutter(pieces, options);
  const Ball everywhere{ {}, std::numeric_limits<double>::infinity() };
  const std::vector<SurfacePatch> patches = patchesOfAll(ranks,
    [&] {
      return cutter.cut({ &everywhere, 1 }, nullptr);
    });
  ranks.together(
    [&]
    {
      if (ranks.rank() == 0)
      {
        Corridor corridor;
        corridor.add(patches, { &everywhere, 1 });
        this->Mesh = std::make_shared<const CorridorMesh>(corridor, hasCost);
        this->Solver =
          method.make(std::shared_ptr<const TriangleMesh>(this->Mesh, &this->Mesh->mesh()));
      }
    });
}

}
