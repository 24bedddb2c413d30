// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ranks/KeyMatches.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace geodesic::distributed
{
namespace
{

struct SentKey
{
  Key key;
  int rank;
  Index number;

  friend auto operator<=>(const SentKey&, const SentKey&) = default;
};

/**
 * Sends a message to every rank, and returns the values that this rank received. Its message to
 * itself is not sent.
 */
template <class T>
std::vector<T> deliver(RankGroup& ranks, std::vector<RankGroup::Message>& byRank)
{
  const std::vector<int> others = ranks.others();
  std::vector<RankGroup::Message> messages;
  for (const int rank : others)
  {
    messages.push_back(std::move(byRank[rank]));
  }
  std::vector<T> all = valuesIn<T>(byRank[ranks.rank()]);
  for (const RankGroup::Message& message : ranks.exchange(others, messages))
  {
    const std::vector<T> values = valuesIn<T>(message);
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

/** Adds the answers for the senders of one key, which tell them of each other. */
void answer(std::span<const SentKey> same, std::vector<RankGroup::Message>& answers)
{
  for (const SentKey& to : same)
  {
    for (const SentKey& other : same)
    {
      append(answers[to.rank], KeyMatch{ to.number, other.rank, other.number });
    }
  }
}

}

std::uint64_t hashOf(const Key& key)
{
  std::uint64_t hash = 0;
  for (const std::uint64_t part : key)
  {
    // Coordinates can differ in few bits, so they are mixed as in SplitMix64 (Steele, Lea, Flood,
    // OOPSLA 2014).
    hash = (hash ^ part) + 0x9e3779b97f4a7c15ull;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ull;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebull;
    hash ^= hash >> 31;
  }
  return hash;
}

std::vector<KeyMatch> matchKeys(RankGroup& ranks, const std::vector<KeyedNumber>& own)
{
  std::vector<RankGroup::Message> asked(ranks.size());
  for (const KeyedNumber& keyed : own)
  {
    append(
      asked[hashOf(keyed.key) % ranks.size()], SentKey{ keyed.key, ranks.rank(), keyed.number });
  }
  auto known = deliver<SentKey>(ranks, asked);
  std::sort(known.begin(), known.end());

  std::vector<RankGroup::Message> answers(ranks.size());
  for (auto first = known.begin(); first != known.end();)
  {
    const auto last = std::find_if(
      first, known.end(), [&](const SentKey& other) { return other.key != first->key; });
    if (last - first > 1)
    {
      answer({ first, last }, answers);
    }
    first = last;
  }
  auto matches = deliver<KeyMatch>(ranks, answers);
  std::sort(matches.begin(), matches.end());
  return matches;
}

}
