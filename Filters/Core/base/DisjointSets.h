// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DisjointSets_h
#define geodesic_DisjointSets_h

#include "base/Index.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace geodesic
{

/**
 * Numbers in sets that only grow together. Each set has its least number as root. Paths are halved
 * on the way to it, so that a look-up takes O(log n) on average.
 */
class DisjointSets
{
public:
  /** @param count each number below it is a set of its own at first */
  explicit DisjointSets(Index count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), Index{ 0 });
  }

  Index rootOf(Index member)
  {
    while (this->Parents[member] != member)
    {
      this->Parents[member] = this->Parents[this->Parents[member]];
      member = this->Parents[member];
    }
    return member;
  }
  /** Makes two sets one. @return its root and the one that is no root any more; equal if they were
   * one already */
  std::pair<Index, Index> connect(Index a, Index b)
  {
    const std::pair<Index, Index> roots = std::minmax(this->rootOf(a), this->rootOf(b));
    this->Parents[roots.second] = roots.first;
    return roots;
  }
  /** Adds a number in a set of its own. */
  Index add()
  {
    this->Parents.push_back(static_cast<Index>(this->Parents.size()));
    return this->Parents.back();
  }
  Index size() const { return static_cast<Index>(this->Parents.size()); }

private:
  std::vector<Index> Parents;
};

}

#endif
