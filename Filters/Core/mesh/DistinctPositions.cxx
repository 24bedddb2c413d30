// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/DistinctPositions.h"

#include "base/BulkVector.h"
#include "base/Index.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace geodesic
{
namespace
{

struct Hashed
{
  std::uint32_t hash;
  Index position;
};

std::uint32_t hashOf(const Vector3& position)
{
  // 0 and -0 are equal coordinates; their sum with 0 is 0. Few of the lower bits of a coordinate
  // differ, so the higher ones are mixed in.
  const auto mixed = [](double x, std::uint64_t odd)
  {
    const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
    return (bits ^ bits >> 32) * odd;
  };
  const std::uint64_t hash = mixed(position.x, 0x9e3779b97f4a7c15u) +
    mixed(position.y, 0xc2b2ae3d27d4eb4fu) + mixed(position.z, 0x165667b19e3779f9u);
  return static_cast<std::uint32_t>(hash >> 32);
}

/** Drops hashes that have a place of their own among eight or more times as many: about seven of
 * eight, unless there are equal ones. */
void dropSingle(BulkVector<Hashed>& hashes, std::uint32_t odd)
{
  constexpr std::size_t places = 8;
  constexpr std::size_t bitsOfWord = 64;
  const int bits = std::clamp(static_cast<int>(std::bit_width(places * hashes.size())), 6, 32);
  std::vector<std::uint64_t> once((std::size_t{ 1 } << bits) / bitsOfWord);
  std::vector<std::uint64_t> twice(once.size());
  const auto placeOf = [&](const Hashed& h) { return (h.hash * odd) >> (32 - bits); };
  for (const Hashed& h : hashes)
  {
    const std::uint32_t place = placeOf(h);
    const std::uint64_t bit = std::uint64_t{ 1 } << place % bitsOfWord;
    twice[place / bitsOfWord] |= once[place / bitsOfWord] & bit;
    once[place / bitsOfWord] |= bit;
  }
  std::erase_if(hashes,
    [&](const Hashed& h)
    {
      const std::uint32_t place = placeOf(h);
      return (twice[place / bitsOfWord] >> place % bitsOfWord & 1) == 0;
    });
}

}

bool areDistinct(std::span<const Vector3> positions, const ThreadTeam& team)
{
  BulkVector<Hashed> hashes(positions.size());
  team.run(positions.size(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        hashes[i] = { hashOf(positions[i]), static_cast<Index>(i) };
      }
    });
  // Equal positions share their places in each round.
  for (const std::uint32_t odd : { 1u, 0x9e3779b1u, 0x85ebca77u })
  {
    dropSingle(hashes, odd);
  }
  std::vector<Vector3> left;
  for (const Hashed& h : hashes)
  {
    left.push_back(positions[h.position]);
  }
  std::sort(left.begin(), left.end(),
    [](const Vector3& p, const Vector3& q)
    { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); });
  return std::adjacent_find(left.begin(), left.end()) == left.end();
}

}
