// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/LineChains.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace geodesic
{

std::vector<LineChain> chainsOf(std::span<const std::pair<Index, Index>> ends)
{
  // Lines of one chain have the same number: that of the first line with one of their ends.
  std::vector<std::size_t> first(ends.size());
  std::iota(first.begin(), first.end(), std::size_t{ 0 });
  const auto rootOf = [&](std::size_t line)
  {
    while (first[line] != line)
    {
      line = first[line] = first[first[line]];
    }
    return line;
  };
  std::map<Index, std::pair<std::size_t, std::size_t>> places;
  for (std::size_t line = 0; line < ends.size(); ++line)
  {
    for (const Index end : { ends[line].first, ends[line].second })
    {
      auto& [known, count] = places.emplace(end, std::pair{ line, 0 }).first->second;
      const std::size_t a = rootOf(known);
      const std::size_t b = rootOf(line);
      first[std::max(a, b)] = std::min(a, b);
      ++count;
    }
  }
  std::map<std::size_t, LineChain> chains;
  for (std::size_t line = 0; line < ends.size(); ++line)
  {
    chains[rootOf(line)].lines.push_back(line);
  }
  for (const auto& [end, lineAndCount] : places)
  {
    LineChain& chain = chains[rootOf(lineAndCount.first)];
    chain.isClosed = chain.isClosed && lineAndCount.second % 2 == 0;
  }
  std::vector<LineChain> list;
  list.reserve(chains.size());
  for (auto& [root, chain] : chains)
  {
    list.push_back(std::move(chain));
  }
  return list;
}

}
