// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lines/GlobalSides.h"

#include "pieces/SharedPoints.h"
#include "split/CurveSides.h"
#include "split/SplitMesh.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace geodesic::distributed
{
namespace
{

Walls wallsOf(const LinedSurface& surface)
{
  const bridge::Barriers& barriers = surface.barriers();
  return { surface.barrierPaths(), barriers.excluded, barriers.closed };
}

/** What a rank sends to the first one: one value for each region, shared vertex, and so on. */
struct GraphPart
{
  enum class Kind
  {
    Region,
    Link,
    AtVertex,
    BorderEdge
  };
  Kind kind;
  Index region;
  Index other;
  GlobalVertex first;
  GlobalVertex second;
  /** Area and border of a region, length of an edge. */
  double area;
  double length;
};

/** A region at a shared vertex, or beside a shared edge. */
template <class Place>
struct RegionAt
{
  Place place;
  int rank;
  Index region;
  double length;

  friend auto operator<=>(const RegionAt&, const RegionAt&) = default;
};

/** The vertices of the mesh that other ranks have, too, and their numbers on the solved mesh. */
class SharedVertices
{
public:
  explicit SharedVertices(const LinedSurface& surface)
    : Shared(surface.divided().shared())
    , Flags(surface.mesh()->numberOfVertices(), 0)
    , Solved(surface.mesh()->numberOfVertices(), NoIndex)
  {
    const SplitMesh* split = surface.split();
    for (const Index solved : this->Shared.vertices())
    {
      if (!split || isVertex(split->origin(solved)))
      {
        const Index vertex = split ? split->origin(solved).carriers()[0] : solved;
        this->Flags[vertex] = 1;
        this->Solved[vertex] = solved;
        this->Vertices.push_back(vertex);
      }
    }
  }

  const std::vector<std::uint8_t>& flags() const { return this->Flags; }
  const std::vector<Index>& vertices() const { return this->Vertices; }
  Index solved(Index vertex) const { return this->Solved[vertex]; }
  GlobalVertex globalOf(Index vertex) const { return this->Shared.globalOf(this->Solved[vertex]); }
  const SharedPoints& points() const { return this->Shared; }

private:
  const SharedPoints& Shared;
  std::vector<std::uint8_t> Flags;
  std::vector<Index> Solved;
  std::vector<Index> Vertices;
};

RankGroup::Message partsOf(const CurveSides& sides, const SharedVertices& shared)
{
  RankGroup::Message message;
  const RegionGraph& graph = sides.graph();
  for (Index region = 0; region < graph.regions.size(); ++region)
  {
    append(message,
      GraphPart{ GraphPart::Kind::Region, region, NoIndex, {}, {}, graph.regions[region].area,
        graph.regions[region].border });
  }
  for (const auto& [a, b] : graph.links)
  {
    append(message, GraphPart{ GraphPart::Kind::Link, a, b, {}, {}, 0.0, 0.0 });
  }
  for (const auto& [vertex, region] : sides.sharedRegions())
  {
    append(message,
      GraphPart{
        GraphPart::Kind::AtVertex, region, NoIndex, shared.globalOf(vertex), {}, 0.0, 0.0 });
  }
  for (const CurveSides::BorderEdge& edge : sides.sharedBorder())
  {
    append(message,
      GraphPart{ GraphPart::Kind::BorderEdge, edge.region, NoIndex,
        shared.globalOf(edge.ends.first), shared.globalOf(edge.ends.second), 0.0, edge.length });
  }
  return message;
}

/** Puts the parts of all ranks together to one graph. On the first rank. */
class GraphOfAll
{
public:
  GraphOfAll(const CurveSides& own, const std::vector<RankGroup::Message>& messages,
    const std::vector<GlobalVertex>& onCurve)
  {
    for (int rank = 0; rank < static_cast<int>(messages.size()); ++rank)
    {
      const auto first = static_cast<Index>(this->Graph.regions.size());
      for (const GraphPart& part : valuesIn<GraphPart>(messages[rank]))
      {
        this->add(part, rank, first);
      }
    }
    // The first rank's regions have the same numbers in the whole graph.
    this->Graph.crossings = own.graph().crossings;
    this->linkAtVertices(onCurve);
    this->linkAtEdges();
  }

  const RegionGraph& graph() const { return this->Graph; }

private:
  using Edge = std::pair<GlobalVertex, GlobalVertex>;

  void add(const GraphPart& part, int rank, Index first)
  {
    switch (part.kind)
    {
      case GraphPart::Kind::Region:
        this->Graph.regions.push_back({ part.area, part.length });
        break;
      case GraphPart::Kind::Link:
        this->Graph.links.emplace_back(first + part.region, first + part.other);
        break;
      case GraphPart::Kind::AtVertex:
        this->AtVertices.push_back({ part.first, rank, first + part.region, 0.0 });
        break;
      case GraphPart::Kind::BorderEdge:
        this->AtEdges.push_back({ std::minmax(part.first, part.second), rank,
          part.region == NoIndex ? NoIndex : first + part.region, part.length });
        break;
    }
  }

  void linkAtVertices(const std::vector<GlobalVertex>& onCurve)
  {
    std::sort(this->AtVertices.begin(), this->AtVertices.end());
    for (std::size_t i = 1; i < this->AtVertices.size(); ++i)
    {
      const auto& [vertex, rank, region, none] = this->AtVertices[i];
      const auto& before = this->AtVertices[i - 1];
      if (before.place == vertex && before.region != region &&
        !std::binary_search(onCurve.begin(), onCurve.end(), vertex))
      {
        this->Graph.links.emplace_back(before.region, region);
      }
    }
  }

  /**
   * An edge that one piece has alone is the surface's border. There it has several parts if lines
   * end on it, which lie on different sides.
   */
  void linkAtEdges()
  {
    std::sort(this->AtEdges.begin(), this->AtEdges.end());
    for (auto first = this->AtEdges.begin(); first != this->AtEdges.end();)
    {
      const auto last = std::find_if(first, this->AtEdges.end(),
        [&](const RegionAt<Edge>& part) { return part.place != first->place; });
      const bool isBorder = first->rank == std::prev(last)->rank;
      const bool isWall =
        std::any_of(first, last, [](const RegionAt<Edge>& part) { return part.region == NoIndex; });
      for (auto part = first; part != last; ++part)
      {
        if (part->region == NoIndex)
        {
          continue;
        }
        if (isBorder || isWall)
        {
          this->Graph.regions[part->region].border += part->length;
        }
        else if (part != first && part->region != std::prev(part)->region)
        {
          this->Graph.links.emplace_back(std::prev(part)->region, part->region);
        }
      }
      first = last;
    }
  }

  RegionGraph Graph;
  std::vector<RegionAt<GlobalVertex>> AtVertices;
  std::vector<RegionAt<Edge>> AtEdges;
};

/** Sets the signs of shared vertices without a face on this rank, and of those on lines. */
void completeSigns(RankGroup& ranks, const CurveSides& sides, const SharedVertices& shared,
  std::vector<std::int8_t>& signs, const SplitMesh* split)
{
  constexpr double onCurve = 2.0;
  std::vector<StartValue> own;
  for (const Index vertex : shared.vertices())
  {
    if (sides.isOnCurve(vertex))
    {
      own.push_back({ shared.solved(vertex), 0, onCurve, false });
    }
    else if (sides.regionAt(vertex) != NoIndex)
    {
      own.push_back({ shared.solved(vertex), 0, static_cast<double>(signs[vertex]), false });
    }
  }
  for (const StartValue& other : shared.points().exchange(ranks, own))
  {
    if (split && !isVertex(split->origin(other.vertex)))
    {
      continue;
    }
    const Index vertex = split ? split->origin(other.vertex).carriers()[0] : other.vertex;
    if (other.value == onCurve)
    {
      signs[vertex] = 1;
    }
    else if (sides.regionAt(vertex) == NoIndex && !sides.isOnCurve(vertex))
    {
      signs[vertex] = static_cast<std::int8_t>(other.value);
    }
  }
}

}

std::vector<std::int8_t> globalSides(RankGroup& ranks, const LinedSurface& surface,
  const std::shared_ptr<const RegionMesh>& mesh, const std::string& name)
{
  if (ranks.size() == 1)
  {
    return curveSides(mesh, surface.seedPaths(), name, wallsOf(surface));
  }
  const SharedVertices shared(surface);
  std::optional<CurveSides> sides;
  RankGroup::Message own;
  ranks.together(
    [&]
    {
      sides.emplace(mesh, surface.seedPaths(), name, wallsOf(surface), shared.flags());
      own = partsOf(*sides, shared);
    });
  const std::vector<RankGroup::Message> parts = ranks.toFirst(own);
  RankGroup::Message signsOfAll;
  ranks.together(
    [&]
    {
      if (ranks.rank() == 0)
      {
        std::vector<GlobalVertex> onCurve;
        for (const Index vertex : shared.vertices())
        {
          if (sides->isOnCurve(vertex))
          {
            onCurve.push_back(shared.globalOf(vertex));
          }
        }
        std::sort(onCurve.begin(), onCurve.end());
        const GraphOfAll all(*sides, parts, onCurve);
        for (const std::int8_t sign : regionSigns(all.graph(), sides->chains(), name))
        {
          append(signsOfAll, sign);
        }
      }
    });
  const auto ofAll = valuesIn<std::int8_t>(ranks.fromFirst(std::move(signsOfAll)));
  const auto count = static_cast<double>(sides->graph().regions.size());
  const std::vector<double> counts = ranks.gather({ &count, 1 });
  std::size_t first = 0;
  for (int rank = 0; rank < ranks.rank(); ++rank)
  {
    first += static_cast<std::size_t>(counts[rank]);
  }
  std::vector<std::int8_t> signs =
    sides->signs(std::span(ofAll).subspan(first, sides->graph().regions.size()));
  completeSigns(ranks, *sides, shared, signs, surface.split());
  return signs;
}

}
