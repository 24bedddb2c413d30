// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/DistinctPositions.h"

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

std::uint64_t hashOf(const Vector3& position)
{
  // 0 and -0 are equal coordinates; their sum with 0 is 0.
  const auto bitsOf = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;
  std::uint64_t hash = bitsOf(position.x) * odd;
  hash = (std::rotl(hash, 32) ^ bitsOf(position.y)) * odd;
  hash = (std::rotl(hash, 32) ^ bitsOf(position.z)) * odd;
  return hash;
}

/** One bit for each of so many hashes that few positions share one by chance. */
class HashBits
{
public:
  explicit HashBits(std::size_t positions)
    : Shift(64 - std::bit_width(BitsOfPosition * positions + BitsOfWord))
    , Words((std::size_t{ 1 } << (64 - this->Shift)) / BitsOfWord)
  {
  }

  bool has(std::uint64_t hash) const
  {
    return (this->Words[this->wordOf(hash)] & this->bitOf(hash)) != 0;
  }
  void add(std::uint64_t hash) { this->Words[this->wordOf(hash)] |= this->bitOf(hash); }

private:
  static constexpr std::size_t BitsOfPosition = 32;
  static constexpr std::size_t BitsOfWord = 64;
  std::size_t wordOf(std::uint64_t hash) const { return (hash >> this->Shift) / BitsOfWord; }
  std::uint64_t bitOf(std::uint64_t hash) const
  {
    return std::uint64_t{ 1 } << ((hash >> this->Shift) % BitsOfWord);
  }

  int Shift;
  std::vector<std::uint64_t> Words;
};

}

bool areDistinct(std::span<const Vector3> positions)
{
  // Of equal positions, all but the first find the bit of their hash set.
  HashBits seen(positions.size());
  std::vector<std::uint64_t> again;
  for (const Vector3& position : positions)
  {
    const std::uint64_t hash = hashOf(position);
    if (seen.has(hash))
    {
      again.push_back(hash);
    }
    seen.add(hash);
  }
  HashBits suspicious(again.size());
  for (const std::uint64_t hash : again)
  {
    suspicious.add(hash);
  }
  std::vector<Vector3> suspects;
  for (const Vector3& position : positions)
  {
    if (suspicious.has(hashOf(position)))
    {
      suspects.push_back(position);
    }
  }
  std::sort(suspects.begin(), suspects.end(),
    [](const Vector3& p, const Vector3& q)
    { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); });
  return std::adjacent_find(suspects.begin(), suspects.end()) == suspects.end();
}

}
