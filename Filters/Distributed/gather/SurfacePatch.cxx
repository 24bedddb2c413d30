// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gather/SurfacePatch.h"

#include <algorithm>
#include <cstddef>

namespace geodesic::distributed
{

RankGroup::Message packed(const SurfacePatch& patch)
{
  RankGroup::Message message;
  append(message, patch.vertices.size());
  for (const PatchVertex& vertex : patch.vertices)
  {
    append(message, vertex);
  }
  for (const PatchTriangle& triangle : patch.triangles)
  {
    append(message, triangle);
  }
  return message;
}

SurfacePatch unpacked(const RankGroup::Message& message)
{
  std::size_t count = 0;
  const auto start = message.begin() + sizeof(count);
  std::copy(message.begin(), start, reinterpret_cast<char*>(&count));
  const auto middle = start + static_cast<std::ptrdiff_t>(count * sizeof(PatchVertex));
  return { valuesIn<PatchVertex>({ start, middle }),
    valuesIn<PatchTriangle>({ middle, message.end() }) };
}

std::vector<SurfacePatch> patchesOfAll(
  RankGroup& ranks, const std::function<SurfacePatch()>& cutLocally)
{
  RankGroup::Message own;
  ranks.together([&] { own = packed(cutLocally()); });
  std::vector<SurfacePatch> patches;
  for (const RankGroup::Message& message : ranks.toFirst(own))
  {
    patches.push_back(unpacked(message));
  }
  return patches;
}

}
