// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/RegionSigns.h"

#include "base/SortUnique.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace geodesic
{
namespace
{

/** Two sums of borders or areas are equal if they differ by less than this part of the whole. */
constexpr double SameMeasure = 1e-9;

/**
 * A walk over the regions of a part of the surface, depth first. It knows at each region which
 * chains lie between it and the first region: those that were passed an odd number of times. The
 * regions where a chain was are its far side, the others its near side.
 */
class Walk
{
public:
  Walk(const RegionGraph& graph, std::span<const LineChain> chains, const std::string& name)
    : Graph(graph)
    , Lines(chains)
    , Name(name)
    , Chains(chains.size())
    , Regions(graph.regions.size())
    , Doors(graph.regions.size())
  {
    std::mt19937_64 random(1);
    for (Chain& chain : this->Chains)
    {
      chain.key = random();
    }
    for (std::size_t c = 0; c < graph.crossings.size(); ++c)
    {
      const auto& [first, second] = graph.crossings[c].regions;
      this->addDoor(first, second, static_cast<Index>(c));
    }
    for (const auto& [first, second] : graph.links)
    {
      this->addDoor(first, second, NoIndex);
    }
  }

  std::vector<std::int8_t> signs()
  {
    this->checkTurns();
    for (Index region = 0; region < this->Regions.size(); ++region)
    {
      if (!this->Regions[region].isSeen)
      {
        this->walkFrom(region);
      }
    }
    for (Index chain = 0; chain < this->Chains.size(); ++chain)
    {
      if (!this->Chains[chain].hasLeft)
      {
        this->fail(chain,
          " no side: the surface has no face beside it, or it goes back where it "
          "came from, or it is a single point; give a line of some length.");
      }
    }
    std::vector<std::int8_t> signs;
    for (const State& region : this->Regions)
    {
      signs.push_back(region.sign);
    }
    return signs;
  }

private:
  struct Chain
  {
    /** Random numbers whose combination by exclusive or tells sets of chains apart. */
    std::uint64_t key = 0;
    /** Whether the chain was passed an odd number of times. */
    bool isPassed = false;
    bool hasLeft = false;
    bool leftIsFar = false;
    /** What the far side has. */
    double area = 0.0;
    double border = 0.0;
  };
  struct State
  {
    bool isSeen = false;
    std::int8_t sign = 0;
    /** The keys of the chains between the first region and this one. */
    std::uint64_t passed = 0;
    /** Whether these are an odd number. */
    bool isOdd = false;
    /** What this region has, with those that were reached through it. */
    RegionGraph::Region whole;
    /** The region from which this one was reached, and the crossing. */
    Index from = NoIndex;
    Index through = NoIndex;
  };
  struct Door
  {
    Index to;
    /** NoIndex for a link. */
    Index crossing;
  };

  void checkTurns() const
  {
    for (const RegionGraph::Crossing& crossing : this->Graph.crossings)
    {
      for (const auto& [number, left] : crossing.passages)
      {
        if (left == 0 && !this->Lines[number].isClosed)
        {
          this->fail(number,
            " no left side: the faces on its two sides are turned differently. "
            "Make them consistent, for example by Surface Normals (Consistency).");
        }
      }
    }
  }

  void addDoor(Index first, Index second, Index crossing)
  {
    if (first != NoIndex)
    {
      this->Doors[first].push_back({ second, crossing });
    }
    if (second != NoIndex && second != first)
    {
      this->Doors[second].push_back({ first, crossing });
    }
  }

  std::span<const RegionGraph::Passage> passagesOf(Index crossing) const
  {
    return crossing == NoIndex ? std::span<const RegionGraph::Passage>()
                               : this->Graph.crossings[crossing].passages;
  }

  std::uint64_t keyOf(Index crossing) const
  {
    std::uint64_t key = 0;
    for (const auto& passage : this->passagesOf(crossing))
    {
      key ^= this->Chains[passage.chain].key;
    }
    return key;
  }

  void pass(Index crossing)
  {
    for (const auto& passage : this->passagesOf(crossing))
    {
      this->Chains[passage.chain].isPassed ^= true;
    }
  }

  void enter(Index region, Index from, Index crossing)
  {
    State& state = this->Regions[region];
    state.isSeen = true;
    state.whole = this->Graph.regions[region];
    state.from = from;
    state.through = crossing;
    if (from != NoIndex)
    {
      state.passed = this->Regions[from].passed ^ this->keyOf(crossing);
      state.isOdd = this->Regions[from].isOdd != (this->passagesOf(crossing).size() % 2 == 1);
    }
    this->pass(crossing);
    this->Seen.push_back(region);
    this->Path.push_back({ region, 0 });
  }

  void leave()
  {
    const State& state = this->Regions[this->Path.back().region];
    this->Path.pop_back();
    for (const auto& passage : this->passagesOf(state.through))
    {
      Chain& chain = this->Chains[passage.chain];
      const double sign = chain.isPassed ? 1.0 : -1.0;
      chain.area += sign * state.whole.area;
      chain.border += sign * state.whole.border;
    }
    this->pass(state.through);
    if (state.from != NoIndex)
    {
      RegionGraph::Region& whole = this->Regions[state.from].whole;
      whole.area += state.whole.area;
      whole.border += state.whole.border;
    }
  }

  /** Notes for the lines beside a region whether their left is their far side. */
  void lookAt(Index region, const RegionGraph::Crossing& crossing)
  {
    for (const auto& [number, left] : crossing.passages)
    {
      Chain& chain = this->Chains[number];
      const bool isLeft = (crossing.regions[0] == region) == (left == 1);
      const bool leftIsFar = chain.isPassed == isLeft;
      const bool isOpen = !this->Lines[number].isClosed;
      if (!chain.hasLeft)
      {
        this->Touched.push_back(number);
        chain.hasLeft = true;
        chain.leftIsFar = leftIsFar;
      }
      if (isOpen && chain.leftIsFar != leftIsFar)
      {
        this->fail(number,
          " no constant left side: an open line must not cross itself, lines that "
          "follow on each other must run in one direction, and the faces along them "
          "must be turned alike, as Surface Normals (Consistency) makes them.");
      }
    }
  }

  void walkFrom(Index start)
  {
    this->Seen.clear();
    this->Touched.clear();
    this->enter(start, NoIndex, NoIndex);
    while (!this->Path.empty())
    {
      const auto [region, next] = this->Path.back();
      if (next == this->Doors[region].size())
      {
        this->leave();
        continue;
      }
      ++this->Path.back().next;
      const Door& door = this->Doors[region][next];
      if (door.crossing != NoIndex)
      {
        this->lookAt(region, this->Graph.crossings[door.crossing]);
      }
      if (door.to == NoIndex)
      {
        continue;
      }
      if (!this->Regions[door.to].isSeen)
      {
        this->enter(door.to, region, door.crossing);
      }
      else if ((this->Regions[door.to].passed ^ this->Regions[region].passed) !=
        this->keyOf(door.crossing))
      {
        this->failBetween(region, door);
      }
    }
    this->sign(start);
  }

  /** Sets the signs of the regions that were seen, the first of which is @p start. */
  void sign(Index start)
  {
    const RegionGraph::Region& whole = this->Regions[start].whole;
    bool startIsMinus = false;
    for (Index number : this->Touched)
    {
      startIsMinus ^= !this->farSideIsMinus(number, whole);
    }
    for (Index region : this->Seen)
    {
      State& state = this->Regions[region];
      const bool isMinus = startIsMinus != state.isOdd;
      state.sign = this->Touched.empty() ? 0 : (isMinus ? -1 : 1);
    }
  }

  bool farSideIsMinus(Index number, const RegionGraph::Region& whole) const
  {
    const Chain& chain = this->Chains[number];
    if (!this->Lines[number].isClosed)
    {
      return !chain.leftIsFar;
    }
    const double moreBorder = 2.0 * chain.border - whole.border;
    if (std::abs(moreBorder) > SameMeasure * whole.border)
    {
      return moreBorder < 0.0;
    }
    const double moreArea = 2.0 * chain.area - whole.area;
    if (std::abs(moreArea) > SameMeasure * whole.area)
    {
      return moreArea < 0.0;
    }
    return chain.leftIsFar;
  }

  /** Throws for the chains that are not passed between two regions as they should be. */
  [[noreturn]] void failBetween(Index region, const Door& door) const
  {
    std::vector<Index> wrong;
    const auto note = [&](Index crossing)
    {
      for (const auto& passage : this->passagesOf(crossing))
      {
        wrong.push_back(passage.chain);
      }
    };
    note(door.crossing);
    for (Index end : { region, door.to })
    {
      for (Index at = end; at != NoIndex; at = this->Regions[at].from)
      {
        note(this->Regions[at].through);
      }
    }
    std::ranges::sort(wrong);
    // Of a chain that is there an even number of times nothing is wrong.
    std::size_t i = 0;
    while (i + 1 < wrong.size() && wrong[i] == wrong[i + 1])
    {
      i += 2;
    }
    const Index number = wrong[i];
    this->fail(number,
      this->Lines[number].isClosed
        ? " no inside: it is closed, but the surface goes on from one side to the other, as round "
          "a handle. Close it elsewhere, or turn Signed off."
        : " no two sides: it is open, and the surface goes on from one side to the other, beyond "
          "its ends or round a hole. Close it, lead its ends to the surface's border, or turn "
          "Signed off.");
  }

  [[noreturn]] void fail(Index chain, const std::string& what) const
  {
    const LineChain& lines = this->Lines[chain];
    throw std::invalid_argument(nameOfLines(this->Name, lines) +
      (lines.lines.size() == 1 ? " has" : " together have") + what);
  }

  struct Step
  {
    Index region;
    /** The next door to go through. */
    std::size_t next;
  };

  const RegionGraph& Graph;
  std::span<const LineChain> Lines;
  const std::string& Name;
  std::vector<Chain> Chains;
  std::vector<State> Regions;
  std::vector<std::vector<Door>> Doors;
  std::vector<Step> Path;
  /** The regions of this part of the surface, and the chains on it. */
  std::vector<Index> Seen;
  std::vector<Index> Touched;
};

}

std::vector<std::int8_t> regionSigns(
  const RegionGraph& graph, std::span<const LineChain> chains, const std::string& name)
{
  return Walk(graph, chains, name).signs();
}

std::string nameOfLines(const std::string& name, const LineChain& chain)
{
  const std::vector<std::size_t>& lines = chain.lines;
  std::string text =
    name + (lines.size() == 1 ? "'s line " : "'s lines ") + std::to_string(lines.front());
  if (lines.size() > 2 && lines.back() - lines.front() + 1 == lines.size())
  {
    return text + " to " + std::to_string(lines.back());
  }
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    text += (i + 1 < lines.size() ? ", " : " and ") + std::to_string(lines[i]);
  }
  return text;
}

}
