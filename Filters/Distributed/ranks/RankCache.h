// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_RankCache_h
#define geodesic_distributed_RankCache_h

#include "ranks/RankGroup.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace geodesic::distributed
{

/**
 * Finds again what the ranks made together, as long as all of them still have it. Several threads
 * may use it at once if there is one rank; on several ranks, all make the same calls in the same
 * order.
 * @tparam Entry what one rank keeps; its isExpired() tells that it can't be used any more. An entry
 * does not keep alive what it refers to.
 */
template <class Entry>
class RankCache
{
public:
  /**
   * Returns this rank's entry of what the ranks made together last and for which @p isSame holds on
   * all of them; nothing if there is none. Collective.
   */
  template <class IsSame>
  std::optional<Entry> find(RankGroup& ranks, const IsSame& isSame)
  {
    const std::vector<Numbered> same = this->allThat(isSame);
    std::vector<double> numbers;
    for (const Numbered& one : same)
    {
      numbers.push_back(one.number);
    }
    const double newest = ranks.largestCommon(numbers);
    const auto found = std::find_if(
      same.begin(), same.end(), [&](const Numbered& one) { return one.number == newest; });
    return found == same.end() ? std::nullopt : std::optional<Entry>(found->entry);
  }

  /** Adds this rank's entry of what the ranks have just made together. Collective. */
  void add(RankGroup& ranks, Entry entry)
  {
    const double number = ranks.newNumber();
    const std::lock_guard lock(this->Mutex);
    this->Known.push_back({ number, std::move(entry) });
  }

private:
  struct Numbered
  {
    /** See RankGroup::newNumber(). */
    double number;
    Entry entry;
  };

  template <class IsSame>
  std::vector<Numbered> allThat(const IsSame& isSame)
  {
    const std::lock_guard lock(this->Mutex);
    std::erase_if(this->Known, [](const Numbered& one) { return one.entry.isExpired(); });
    std::vector<Numbered> same;
    std::copy_if(this->Known.begin(), this->Known.end(), std::back_inserter(same),
      [&](const Numbered& one) { return isSame(one.entry); });
    return same;
  }

  std::mutex Mutex;
  std::vector<Numbered> Known;
};

}

#endif
