// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/GlobalRegions.h"

#include "base/DisjointSets.h"
#include "base/SortUnique.h"
#include "input/PointIdentity.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace geodesic::distributed
{
namespace
{

/**
 * A shared vertex, or a point on an edge between two, the same on all ranks: the ends in increasing
 * order and the weight of the second one. MeshSplitter has the same weight to the last digit
 * whichever end comes first.
 */
struct EdgePlace
{
  GlobalVertex first;
  GlobalVertex second;
  double weight;

  friend auto operator<=>(const EdgePlace&, const EdgePlace&) = default;
};

EdgePlace placeOf(const SharedPoints& shared, const PathPoint& point)
{
  const Carriers carriers = point.carriers();
  const GlobalVertex first = shared.globalOf(carriers[0]);
  if (carriers.size() == 1)
  {
    return { first, first, 0.0 };
  }
  const GlobalVertex second = shared.globalOf(carriers[1]);
  return first < second ? EdgePlace{ first, second, weightOf(point, carriers[1]) }
                        : EdgePlace{ second, first, weightOf(point, carriers[0]) };
}

/** A side between shared vertices as it is sent, with a region of its rank. */
struct SentSide
{
  EdgePlace from;
  EdgePlace to;
  Index region;
  Index isOnLine;
  double length;

  bool isBeside(const SentSide& other) const
  {
    return this->from == other.from && this->to == other.to;
  }
};

/** What a rank sends to the first one: the areas of its regions, then its shared sides. */
struct Part
{
  std::vector<double> areas;
  std::vector<SentSide> sides;

  Part(const SharedPoints& shared, const RegionCut& cut)
    : areas(cut.areas())
  {
    for (const RegionCut::SharedSide& side : cut.sharedSides())
    {
      const auto [from, to] = std::minmax(placeOf(shared, cut.pointAt(side.edge.first)),
        placeOf(shared, cut.pointAt(side.edge.second)));
      this->sides.push_back({ from, to, side.region, side.isOnLine ? Index{ 1 } : 0, side.length });
    }
  }
  explicit Part(const RankGroup::Message& message)
  {
    const auto counted = valuesIn<std::uint64_t>(message).front();
    const char* areas = message.data() + sizeof(std::uint64_t);
    const char* sides = areas + counted * sizeof(double);
    this->areas = valuesIn<double>({ areas, sides });
    this->sides = valuesIn<SentSide>({ sides, message.data() + message.size() });
  }

  RankGroup::Message message() const
  {
    RankGroup::Message message;
    append(message, std::uint64_t{ this->areas.size() });
    for (const double area : this->areas)
    {
      append(message, area);
    }
    for (const SentSide& side : this->sides)
    {
      append(message, side);
    }
    return message;
  }
};

/** The regions of all ranks put together. On the first rank. */
class RegionsOfAll
{
public:
  explicit RegionsOfAll(const std::vector<RankGroup::Message>& messages)
  {
    std::vector<double> areas;
    for (const RankGroup::Message& message : messages)
    {
      const Part part(message);
      const auto first = static_cast<Index>(areas.size());
      this->Firsts.push_back(first);
      areas.insert(areas.end(), part.areas.begin(), part.areas.end());
      for (SentSide side : part.sides)
      {
        side.region += first;
        this->Sides.push_back(side);
      }
    }
    this->IsSeparating.assign(this->Sides.size(), 0);
    this->sortSides();
    this->number(areas);
    this->measure();
  }

  /** Of each region of each rank in turn, its number on the surface. */
  const std::vector<Index>& numbers() const { return this->Numbers; }
  const std::vector<Index>& firsts() const { return this->Firsts; }
  const std::vector<double>& areas() const { return this->Areas; }
  /** Of shared sides only. */
  const std::vector<double>& perimeters() const { return this->Perimeters; }
  /** Of each side of each rank that is on a line, in turn. */
  std::vector<char> separating() const
  {
    std::vector<char> separating;
    for (std::size_t side = 0; side < this->Sides.size(); ++side)
    {
      if (this->Sides[side].isOnLine != 0)
      {
        separating.push_back(this->IsSeparating[side]);
      }
    }
    return separating;
  }

private:
  void sortSides()
  {
    for (std::size_t side = 0; side < this->Sides.size(); ++side)
    {
      this->Order.push_back(side);
    }
    std::sort(this->Order.begin(), this->Order.end(),
      [&](std::size_t a, std::size_t b)
      {
        const SentSide& first = this->Sides[a];
        const SentSide& second = this->Sides[b];
        return std::tie(first.from, first.to, a) < std::tie(second.from, second.to, b);
      });
  }

  /** Calls @p visit with the numbers of the sides at each edge. */
  template <class Visit>
  void visitEdges(const Visit& visit) const
  {
    for (auto first = this->Order.begin(); first != this->Order.end();)
    {
      const auto last = std::find_if(first, this->Order.end(),
        [&](std::size_t side) { return !this->Sides[side].isBeside(this->Sides[*first]); });
      visit(std::span(first, last));
      first = last;
    }
  }

  void number(const std::vector<double>& areas)
  {
    DisjointSets sets(static_cast<Index>(areas.size()));
    this->visitEdges(
      [&](std::span<const std::size_t> sides)
      {
        const bool isOnLine = std::any_of(sides.begin(), sides.end(),
          [&](std::size_t side) { return this->Sides[side].isOnLine != 0; });
        for (std::size_t i = 1; i < sides.size() && !isOnLine; ++i)
        {
          sets.connect(this->Sides[sides[0]].region, this->Sides[sides[i]].region);
        }
      });
    std::vector<double> sums;
    std::vector<Index> numbers(areas.size(), NoIndex);
    for (Index region = 0; region < areas.size(); ++region)
    {
      Index& number = numbers[sets.rootOf(region)];
      if (number == NoIndex)
      {
        number = static_cast<Index>(sums.size());
        sums.push_back(0.0);
      }
      sums[number] += areas[region];
    }
    const std::vector<Index> places = placesBySize(sums);
    this->Areas.resize(sums.size());
    for (Index number = 0; number < sums.size(); ++number)
    {
      this->Areas[places[number]] = sums[number];
    }
    for (Index region = 0; region < areas.size(); ++region)
    {
      this->Numbers.push_back(places[numbers[sets.rootOf(region)]]);
    }
  }

  void measure()
  {
    this->Perimeters.assign(this->Areas.size(), 0.0);
    this->visitEdges(
      [&](std::span<const std::size_t> sides)
      {
        std::vector<Index> regions;
        for (const std::size_t side : sides)
        {
          regions.push_back(this->Numbers[this->Sides[side].region]);
        }
        sortUnique(regions);
        if (sides.size() > 1 && regions.size() == 1)
        {
          return;
        }
        for (const Index region : regions)
        {
          this->Perimeters[region] += this->Sides[sides[0]].length;
        }
        for (const std::size_t side : sides)
        {
          this->IsSeparating[side] = regions.size() > 1 ? 1 : 0;
        }
      });
  }

  std::vector<Index> Firsts;
  std::vector<SentSide> Sides;
  /** The numbers of the sides, sorted by their edges. */
  std::vector<std::size_t> Order;
  std::vector<char> IsSeparating;
  std::vector<Index> Numbers;
  std::vector<double> Areas;
  std::vector<double> Perimeters;
};

/** The sums of the values of all ranks. Collective. */
std::vector<double> sumsOf(
  RankGroup& ranks, const std::vector<double>& own, const std::vector<double>& onFirst)
{
  RankGroup::Message message;
  for (const double value : own)
  {
    append(message, value);
  }
  const std::vector<RankGroup::Message> messages = ranks.toFirst(message);
  RankGroup::Message sums;
  ranks.together(
    [&]
    {
      std::vector<double> values = onFirst;
      for (const RankGroup::Message& ofRank : messages)
      {
        const auto added = valuesIn<double>(ofRank);
        std::transform(values.begin(), values.end(), added.begin(), values.begin(), std::plus<>{});
      }
      for (const double value : values)
      {
        append(sums, value);
      }
    });
  return valuesIn<double>(ranks.fromFirst(std::move(sums)));
}

/** Sends values from the first rank. Collective. */
template <class T>
std::vector<T> fromFirst(RankGroup& ranks, const std::vector<T>& values)
{
  RankGroup::Message message;
  for (const T& value : values)
  {
    append(message, value);
  }
  return valuesIn<T>(ranks.fromFirst(std::move(message)));
}

/** Whether a point of a cut lies on an edge between shared vertices. */
bool isOnSharedEdge(const RegionCut& cut, Index point)
{
  return cut.isShared({ point, point });
}

}

std::vector<std::uint8_t> sharedFlags(const DistributedSurface& surface)
{
  std::vector<std::uint8_t> flags(surface.mesh().numberOfVertices(), 0);
  for (const Index vertex : surface.shared().vertices())
  {
    flags[vertex] = 1;
  }
  return flags;
}

void joinRegions(RankGroup& ranks, const DistributedSurface& surface, RegionCut& cut)
{
  if (ranks.size() == 1)
  {
    return;
  }
  RankGroup::Message own;
  ranks.together([&] { own = Part(surface.shared(), cut).message(); });
  const std::vector<RankGroup::Message> parts = ranks.toFirst(own);
  std::vector<Index> firsts;
  std::vector<Index> numbers;
  std::vector<char> separating;
  std::vector<double> areas;
  std::vector<double> perimeters;
  ranks.together(
    [&]
    {
      if (ranks.rank() == 0)
      {
        const RegionsOfAll all(parts);
        firsts = all.firsts();
        numbers = all.numbers();
        separating = all.separating();
        areas = all.areas();
        perimeters = all.perimeters();
      }
    });
  firsts = fromFirst(ranks, firsts);
  numbers = fromFirst(ranks, numbers);
  separating = fromFirst(ranks, separating);
  areas = fromFirst(ranks, areas);

  double sidesOnLines = 0.0;
  for (const RegionCut::SharedSide& side : cut.sharedSides())
  {
    sidesOnLines += side.isOnLine ? 1.0 : 0.0;
  }
  const std::vector<double> counts = ranks.gather({ &sidesOnLines, 1 });
  auto answer = separating.begin();
  for (int rank = 0; rank < ranks.rank(); ++rank)
  {
    answer += static_cast<std::ptrdiff_t>(counts[rank]);
  }
  std::vector<bool> ofSides;
  for (const RegionCut::SharedSide& side : cut.sharedSides())
  {
    ofSides.push_back(side.isOnLine && *answer++ != 0);
  }
  const std::size_t regions = cut.areas().size();
  ranks.together(
    [&]
    {
      cut.renumber(
        std::span(numbers).subspan(firsts[ranks.rank()], regions), std::move(areas), ofSides);
    });
  cut.setPerimeters(sumsOf(ranks, cut.perimeters(), perimeters));
}

std::vector<Index> regionsWith(RankGroup& ranks, const RegionCut& cut,
  std::span<const GlobalPoint> points, const std::string& property)
{
  std::vector<double> own;
  ranks.together(
    [&]
    {
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        for (const SurfacePoint& local : points[i].local)
        {
          for (const Index region : cut.regionsAt(local))
          {
            own.push_back(static_cast<double>(i));
            own.push_back(region);
          }
        }
      }
    });
  std::vector<std::set<Index>> found(points.size());
  const std::vector<double> rows = ranks.gather(own);
  for (std::size_t i = 0; i < rows.size(); i += 2)
  {
    found[static_cast<std::size_t>(rows[i])].insert(static_cast<Index>(rows[i + 1]));
  }
  std::vector<Index> regions;
  ranks.together(
    [&]
    {
      for (const std::set<Index>& there : found)
      {
        if (there.size() > 1)
        {
          throw std::invalid_argument("Point " + std::to_string(regions.size()) + " of " +
            property + " lies on a line, between " + std::to_string(there.size()) +
            " regions; move it off the line.");
        }
        regions.push_back(*there.begin());
      }
    });
  return regions;
}

std::vector<vtkIdType> idsOfNewPoints(RankGroup& ranks, const DistributedSurface& surface,
  const bridge::InputBlocks& blocks, const RegionCut& cut)
{
  if (!ranks.isAny(blocks.haveGlobalPointIds()))
  {
    return {};
  }
  std::vector<vtkIdType> used;
  const Index first = surface.mesh().numberOfVertices();
  std::vector<Index> onShared;
  RankGroup::Message own;
  ranks.together(
    [&]
    {
      used =
        blocks.haveGlobalPointIds() ? bridge::globalPointIdsOf(blocks) : std::vector<vtkIdType>{};
      for (Index point = first; point < cut.numberOfPoints(); ++point)
      {
        if (isOnSharedEdge(cut, point))
        {
          onShared.push_back(point);
          append(own, placeOf(surface.shared(), cut.pointAt(point)));
        }
      }
    });
  // Ids are below 2^63, more than a double tells apart; but the counts of points are not.
  const vtkIdType largest = used.empty() ? -1 : *std::max_element(used.begin(), used.end());
  RankGroup::Message largestOfRank;
  append(largestOfRank, largest);
  const std::vector<RankGroup::Message> largestOfAll = ranks.toFirst(largestOfRank);
  const std::vector<RankGroup::Message> places = ranks.toFirst(own);
  std::vector<vtkIdType> ids;
  ranks.together(
    [&]
    {
      std::map<EdgePlace, vtkIdType> known;
      vtkIdType least = 0;
      for (const RankGroup::Message& message : largestOfAll)
      {
        least = std::max(least, valuesIn<vtkIdType>(message).front() + 1);
      }
      for (const RankGroup::Message& message : places)
      {
        for (const EdgePlace& place : valuesIn<EdgePlace>(message))
        {
          ids.push_back(
            known.emplace(place, least + static_cast<vtkIdType>(known.size())).first->second);
        }
      }
      // The first one that is free comes last.
      ids.push_back(least + static_cast<vtkIdType>(known.size()));
    });
  ids = fromFirst(ranks, ids);
  const std::array counts{ static_cast<double>(onShared.size()),
    static_cast<double>(cut.numberOfPoints() - first) - static_cast<double>(onShared.size()) };
  const std::vector<double> countsOfAll = ranks.gather(counts);
  auto shared = ids.begin();
  vtkIdType free = ids.back();
  for (int rank = 0; rank < ranks.rank(); ++rank)
  {
    shared += static_cast<std::ptrdiff_t>(countsOfAll[2 * rank]);
    free += static_cast<vtkIdType>(countsOfAll[2 * rank + 1]);
  }
  std::vector<vtkIdType> ofPoints;
  for (Index point = first; point < cut.numberOfPoints(); ++point)
  {
    ofPoints.push_back(isOnSharedEdge(cut, point) ? *shared++ : free++);
  }
  return ofPoints;
}

}
