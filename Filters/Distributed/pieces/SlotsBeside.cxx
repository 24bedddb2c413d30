// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces/SlotsBeside.h"

#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <utility>

namespace geodesic::distributed
{

SlotsBeside::SlotsBeside(const TriangleMesh& mesh, std::span<const Index> shared)
  : HasSlots(mesh.numberOfVertices(), false)
{
  std::vector<std::pair<Index, std::uint32_t>> pairs;
  for (std::uint32_t slot = 0; slot < shared.size(); ++slot)
  {
    pairs.emplace_back(shared[slot], slot);
    for (const RingEntry& entry : mesh.ring(shared[slot]))
    {
      pairs.emplace_back(entry.neighbour(), slot);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  this->Slots.reserve(pairs.size());
  for (const auto& [vertex, slot] : pairs)
  {
    if (!this->HasSlots[vertex])
    {
      this->HasSlots[vertex] = true;
      this->Vertices.push_back(vertex);
      this->First.push_back(static_cast<std::uint32_t>(this->Slots.size()));
    }
    this->Slots.push_back(slot);
  }
  this->First.push_back(static_cast<std::uint32_t>(this->Slots.size()));
}

std::span<const std::uint32_t> SlotsBeside::of(Index vertex) const
{
  if (!this->HasSlots[vertex])
  {
    return {};
  }
  const auto place =
    std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex) - this->Vertices.begin();
  return { this->Slots.data() + this->First[place], this->Slots.data() + this->First[place + 1] };
}

}
