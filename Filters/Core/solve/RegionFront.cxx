// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solve/RegionFront.h"

#include "base/SortUnique.h"
#include "mesh/TriangleMesh.h"
#include "solve/Partition.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace geodesic
{
namespace
{

/** A region with more border vertices gets no round labels there. */
constexpr double MostOnBorder = 256.0;

/** A vertex of a region. */
struct Member
{
  /** The number of the region's seed. */
  Index seed;
  Index vertex;

  auto operator<=>(const Member&) const = default;
};

/** Vertices of all regions, in ascending order and each once. */
using Members = std::vector<Member>;

/** Where a round front of a region starts. */
struct Origin
{
  Index seed;
  std::array<double, 3> place;
  /** NoIndex where only other pieces have it. */
  Index vertex;
};

/** How many vertices of a region are on all pieces. */
struct RegionCount
{
  double joined = 0.0;
  double onBorder = 0.0;
};

class RegionParts
{
public:
  RegionParts(const TriangleMesh& mesh, std::span<const Seed> seeds,
    const std::function<bool()>& goesOn, Partition& partition)
    : Mesh(mesh)
    , Seeds(seeds)
    , Pieces(partition)
  {
    this->findParts(goesOn);
    this->count();
  }

  SeedFront front()
  {
    std::erase_if(this->Border,
      [&](const Member& member) { return this->Counts[member.seed].onBorder > MostOnBorder; });
    const std::vector<Origin> isolated = this->originsOf(this->Isolated);
    const std::vector<Origin> onBorder = this->originsOf(this->Border);
    auto nextIsolated = isolated.begin();
    auto nextJoined = this->Joined.cbegin();
    auto nextOnBorder = onBorder.begin();
    for (Index seed = 0; seed < this->Seeds.size(); ++seed)
    {
      nextIsolated = this->addRounds(seed, nextIsolated, isolated.end());
      if (this->Counts[seed].joined > 0.0)
      {
        const Index label = this->addLabel(seed, FrontShape::Straight);
        for (; nextJoined != this->Joined.cend() && nextJoined->seed == seed; ++nextJoined)
        {
          this->Front.starts.push_back({ nextJoined->vertex, label, 0.0 });
        }
      }
      nextOnBorder = this->addRounds(seed, nextOnBorder, onBorder.end());
    }
    return std::move(this->Front);
  }

private:
  /** Sorts the vertices of regions by what is beside them. */
  void findParts(const std::function<bool()>& goesOn)
  {
    Members own;
    for (Index seed = 0; seed < this->Seeds.size(); ++seed)
    {
      if (this->Seeds[seed].kind == Seed::Kind::Region)
      {
        for (const Index vertex : this->Seeds[seed].vertices)
        {
          own.push_back({ seed, vertex });
        }
      }
    }
    const Members members = this->withThoseOfOthers(std::move(own));
    Members besideInside;
    Members besideOutside;
    auto first = members.begin();
    auto last = first;
    for (std::size_t i = 0; i < members.size(); ++i)
    {
      const Member& member = members[i];
      if (i == 0 || member.seed != members[i - 1].seed)
      {
        first = last;
        last = std::upper_bound(first, members.end(), Member{ member.seed, NoIndex });
      }
      bool hasInside = false;
      bool hasOutside = false;
      for (const RingEntry& entry : this->Mesh.ring(member.vertex))
      {
        const Member neighbour{ member.seed, entry.neighbour() };
        (std::binary_search(first, last, neighbour) ? hasInside : hasOutside) = true;
      }
      if (hasInside)
      {
        besideInside.push_back(member);
      }
      if (hasOutside)
      {
        besideOutside.push_back(member);
      }
      if ((i + 1) % PointsOfFrontReport == 0 && !goesOn())
      {
        break;
      }
    }
    this->Joined = this->withThoseOfOthers(std::move(besideInside));
    besideOutside = this->withThoseOfOthers(std::move(besideOutside));
    std::set_difference(members.begin(), members.end(), this->Joined.begin(), this->Joined.end(),
      std::back_inserter(this->Isolated));
    std::set_intersection(this->Joined.begin(), this->Joined.end(), besideOutside.begin(),
      besideOutside.end(), std::back_inserter(this->Border));
  }

  /** Adds to vertices of regions the shared ones in the same regions on other pieces. */
  Members withThoseOfOthers(Members members)
  {
    std::vector<StartValue> own;
    own.reserve(members.size());
    for (const Member& member : members)
    {
      own.push_back({ member.vertex, member.seed, 0.0, false });
    }
    for (const StartValue& other : this->Pieces.exchange(own))
    {
      members.push_back({ other.label, other.vertex });
    }
    sortUnique(members);
    return members;
  }

  void count()
  {
    this->Counts.resize(this->Seeds.size());
    std::vector<RegionCount> own(this->Seeds.size());
    for (const Member& member : this->Joined)
    {
      own[member.seed].joined += this->Pieces.owns(member.vertex) ? 1.0 : 0.0;
    }
    for (const Member& member : this->Border)
    {
      own[member.seed].onBorder += this->Pieces.owns(member.vertex) ? 1.0 : 0.0;
    }
    std::vector<double> rows;
    for (Index seed = 0; seed < own.size(); ++seed)
    {
      // What is on the border is joined.
      if (own[seed].joined > 0.0)
      {
        rows.insert(
          rows.end(), { static_cast<double>(seed), own[seed].joined, own[seed].onBorder });
      }
    }
    const std::vector<double> all = this->Pieces.gather(rows);
    for (std::size_t i = 0; i < all.size(); i += 3)
    {
      RegionCount& counted = this->Counts[static_cast<std::size_t>(all[i])];
      counted.joined += all[i + 1];
      counted.onBorder += all[i + 2];
    }
  }

  /** The vertices as origins of round fronts; with those of other pieces, in the same order on any
   * number of pieces. */
  std::vector<Origin> originsOf(const Members& members)
  {
    std::vector<Origin> origins;
    origins.reserve(members.size());
    std::vector<double> own;
    for (const Member& member : members)
    {
      const Vector3& p = this->Mesh.position(member.vertex);
      // Adding 0 turns -0 into 0, so that equal places have the same bits on all pieces.
      const std::array place{ p.x + 0.0, p.y + 0.0, p.z + 0.0 };
      // The triangles of a vertex can all be on other pieces, one of which then has its origin.
      const bool isHere = !this->Mesh.ring(member.vertex).empty();
      origins.push_back({ member.seed, place, isHere ? member.vertex : NoIndex });
      if (this->Pieces.isDivided())
      {
        own.insert(own.end(), { static_cast<double>(member.seed), place[0], place[1], place[2] });
      }
    }
    const std::vector<double> all = this->Pieces.gather(own);
    for (std::size_t i = 0; i < all.size(); i += 4)
    {
      origins.push_back(
        { static_cast<Index>(all[i]), { all[i + 1], all[i + 2], all[i + 3] }, NoIndex });
    }
    // Of those at one place this piece's come first.
    std::sort(origins.begin(), origins.end(),
      [](const Origin& a, const Origin& b)
      { return std::tie(a.seed, a.place, a.vertex) < std::tie(b.seed, b.place, b.vertex); });
    return origins;
  }

  /** Adds a round label at each place of a seed; it starts at all vertices there.
   * @return the first origin of another seed */
  std::vector<Origin>::const_iterator addRounds(
    Index seed, std::vector<Origin>::const_iterator origin, std::vector<Origin>::const_iterator end)
  {
    while (origin != end && origin->seed == seed)
    {
      const std::array<double, 3> place = origin->place;
      const Index label = this->addLabel(seed, FrontShape::Round, { place[0], place[1], place[2] });
      if (origin->vertex != NoIndex)
      {
        this->Front.labels[label].origin = this->Mesh.pointAtVertex(origin->vertex);
      }
      for (; origin != end && origin->seed == seed && origin->place == place; ++origin)
      {
        if (origin->vertex != NoIndex)
        {
          this->Front.starts.push_back({ origin->vertex, label, 0.0 });
        }
      }
    }
    return origin;
  }

  Index addLabel(Index seed, FrontShape shape, const Vector3& position = {})
  {
    this->Front.labels.push_back({ seed, shape, this->Seeds[seed].value, {}, position });
    return static_cast<Index>(this->Front.labels.size() - 1);
  }

  const TriangleMesh& Mesh;
  std::span<const Seed> Seeds;
  Partition& Pieces;
  /** Vertices without a neighbour in the region. */
  Members Isolated;
  /** The other ones. */
  Members Joined;
  /** Those of the joined ones that have a neighbour outside. */
  Members Border;
  /** By number of the seed. */
  std::vector<RegionCount> Counts;
  SeedFront Front;
};

}

SeedFront frontOfRegions(const TriangleMesh& mesh, std::span<const Seed> seeds,
  const std::function<bool()>& goesOn, Partition& partition)
{
  return RegionParts(mesh, seeds, goesOn, partition).front();
}

}
