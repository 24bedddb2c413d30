// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/ThinTriangleNotice.h"

#include "base/MachineMemory.h"
#include "input/InputBlocks.h"
#include "input/InputSurface.h"
#include "pieces/DistributedSurface.h"

#include <algorithm>
#include <array>
#include <vector>

namespace geodesic::distributed
{

void ThinTriangleNotice::update(RankGroup& ranks,
  const std::shared_ptr<const DistributedSurface>& surface, const bridge::InputBlocks& blocks)
{
  if (this->Counted.lock() != surface)
  {
    const std::vector<bool> areGhosts = blocks.areGhosts();
    const bridge::InputSurface& piece = surface->piece();
    this->OfThisRank = countThinTriangles(surface->mesh(),
      [&](Index triangle)
      { return areGhosts.empty() || !areGhosts[piece.cellOfTriangle(triangle)]; });
    this->Counted = surface;
  }
  const auto ofAll = [&](std::size_t count)
  { return static_cast<std::size_t>(ranks.sum(static_cast<double>(count))); };
  this->OfAll = { ofAll(this->OfThisRank.thin), ofAll(this->OfThisRank.needles),
    ofAll(this->OfThisRank.all) };
}

bool ThinTriangleNotice::needOthers(RankGroup& ranks, std::span<const Seed> seeds, bool hasCost,
  Index vertices, std::size_t limit) const
{
  const bool arePoints = std::all_of(
    seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.kind == Seed::Kind::Point; });
  if (!this->OfAll.needOthers() || hasCost || ranks.isAny(!arePoints))
  {
    return false;
  }
  // The first of several ranks gets all of the surface. What it takes there, see
  // IntrinsicMarchingSolver.
  constexpr double bytesOfVertex = 2000.0;
  const double bytes = ranks.sum(static_cast<double>(vertices)) * bytesOfVertex;
  constexpr double partOfMachine = 0.75;
  std::array room{ limit > 0 ? static_cast<double>(limit)
                             : partOfMachine * static_cast<double>(machineMemory()) };
  ranks.takeLeast(room);
  return bytes <= room[0];
}

std::string ThinTriangleNotice::text(bool isIntrinsic, bool hasCost) const
{
  if (!this->OfAll.areMany())
  {
    return {};
  }
  const std::string count = std::to_string(this->OfAll.thin) + " of " +
    std::to_string(this->OfAll.all) + " triangles are thin; ";
  if (isIntrinsic)
  {
    return count + "FastMarching goes over others of the same surface instead.";
  }
  return count + "distances of FastMarching can be far off there. " +
    (hasCost ? "Remesh the surface."
             : "Use the method Exact, Bounded or VirtualSources, or remesh the surface.");
}

}
