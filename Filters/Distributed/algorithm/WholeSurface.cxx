// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/WholeSurface.h"

#include "base/NumberText.h"
#include "gather/Corridor.h"
#include "gather/PatchCutter.h"
#include "methods/SolverTable.h"

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace geodesic::distributed
{
namespace
{

/** MPI counts what the first rank receives by an int. */
void checkSize(double bytes)
{
  constexpr double most = 2e9;
  if (bytes > most)
  {
    throw std::runtime_error("To gather the surface takes a message of " + textOf(bytes * 1e-9) +
      " GB, and the most is 2 GB, some 14 million points. Coarsen the surface, run on one rank, or "
      "use the method FastMarching.");
  }
}

}

WholeSurface::WholeSurface(RankGroup& ranks, const DividedMesh& pieces, const SolveOptions& options,
  const SolverTraits& method)
{
  const bool hasCost = ranks.isAny(!options.cost.empty());
  const PatchCutter cutter(pieces, options);
  const Ball everywhere{ {}, std::numeric_limits<double>::infinity() };
  SurfacePatch own;
  ranks.together([&] { own = cutter.cut({ &everywhere, 1 }, nullptr); });
  checkSize(ranks.sum(static_cast<double>(own.vertices.size() * sizeof(PatchVertex)) +
    static_cast<double>(own.triangles.size() * sizeof(PatchTriangle))));
  const std::vector<SurfacePatch> patches = patchesOfAll(ranks, [&] { return std::move(own); });
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
