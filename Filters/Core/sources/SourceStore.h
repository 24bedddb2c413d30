// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceStore_h
#define geodesic_SourceStore_h

#include "base/Index.h"
#include "sources/VirtualSource.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace geodesic
{

/** A virtual source with its distances at the corners of the triangle behind its side: at the
 * opposite corner, at the side's first one and at its second one. */
struct SeenSource
{
  VirtualSource source;
  std::array<double, 3> distances;
};

/**
 * The virtual sources that are kept at the sides of triangles: for each corner of the triangle the
 * one that is nearest to it. That is often the same for all three, and is then held once. What is
 * kept does not depend on the order in which sources are offered, but for rounding.
 */
class SourceStore
{
public:
  explicit SourceStore(std::size_t sides)
    : Sides(sides)
  {
  }

  /** Removes all sources. Time linear in the number of sides that had one. */
  void clear()
  {
    for (const Index side : this->Used)
    {
      this->Sides[side] = Side();
    }
    this->Used.clear();
    this->Sources.clear();
    this->Free.clear();
  }

  /** Whether a source is worth an offer: whether it is nearer to a corner than the one that is kept
   * for it, by more than LeastGain if that one comes from the same bend and lights as much. */
  bool isWorthwhile(Index side, const SeenSource& seen) const
  {
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      const Index number = this->Sides[side].sources[corner];
      if (this->isBetter(side, seen.distances, corner) &&
        (number == NoIndex || !standsFor(this->Sources[number], seen, corner)))
      {
        return true;
      }
    }
    return false;
  }

  /** Keeps a source if it is nearer to a corner than the one that is kept for it. Returns whether
   * the side has become one with news by that: it had none before. */
  bool offer(Index side, const SeenSource& offered)
  {
    std::array<bool, Corners> gains{};
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      gains[corner] = this->isBetter(side, offered.distances, corner);
    }
    if (std::none_of(gains.begin(), gains.end(), [](bool gain) { return gain; }))
    {
      return false;
    }
    Side& at = this->Sides[side];
    if (!at.isUsed)
    {
      at.isUsed = true;
      this->Used.push_back(side);
    }
    const bool hadNews = at.news != 0;
    const Index number = this->add(offered);
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      if (gains[corner])
      {
        const Index old = at.sources[corner];
        at.sources[corner] = number;
        at.news = static_cast<std::uint8_t>(at.news | 1u << corner);
        this->removeUnless(at, old);
      }
    }
    return !hadNews;
  }

  /** Calls @p visit with each source of a side that it has not been called with before. */
  template <class Visit>
  void visitNews(Index side, const Visit& visit) const
  {
    const Side& at = this->Sides[side];
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      const Index number = at.sources[corner];
      bool isNew = (at.news >> corner & 1u) != 0;
      for (std::size_t before = 0; before < corner; ++before)
      {
        isNew = isNew && !((at.news >> before & 1u) != 0 && at.sources[before] == number);
      }
      if (isNew)
      {
        visit(this->Sources[number]);
      }
    }
  }
  /** Makes all sources of a side old ones. */
  void forgetNews(Index side) { this->Sides[side].news = 0; }

private:
  static constexpr std::size_t Corners = 3;
  /** Distances that differ by less, relatively, are equal: they may differ by rounding. */
  static constexpr double Rounding = 1e-11;
  /** A source that gains less, relatively, over a kept one of the same bend goes no further.
   * Without that, sources that are joined on needles lower one another again and again: on a torus
   * of 40,000 points flattened 100 times 36.4 items of the queue a vertex, and 6.8 with it. */
  static constexpr double LeastGain = 1e-5;
  /** Offsets that differ by less, relatively to a distance, are those of one bend. */
  static constexpr double SameBend = 1e-9;

  struct Side
  {
    /** For each corner, as in SeenSource, the number of its source. */
    std::array<Index, Corners> sources{ NoIndex, NoIndex, NoIndex };
    /** Bit i: whether the source of corner i has not been visited. */
    std::uint8_t news = 0;
    bool isUsed = false;
  };

  /** Whether a source is nearer to a corner than the kept one, or equally near, and nearer to all
   * corners together. */
  bool isBetter(Index side, const std::array<double, 3>& distances, std::size_t corner) const
  {
    const Index number = this->Sides[side].sources[corner];
    if (number == NoIndex)
    {
      return true;
    }
    const std::array<double, 3>& kept = this->Sources[number].distances;
    const double rounding = Rounding * kept[corner];
    if (std::abs(distances[corner] - kept[corner]) > rounding)
    {
      return distances[corner] < kept[corner];
    }
    const auto sum = [](const std::array<double, 3>& of) { return of[0] + of[1] + of[2]; };
    return sum(distances) < sum(kept) * (1.0 - Rounding);
  }

  /** Whether a kept source may stand for one that is nearer to a corner by little. */
  static bool standsFor(const SeenSource& kept, const SeenSource& seen, std::size_t corner)
  {
    return kept.source.label == seen.source.label &&
      std::abs(kept.source.offset - seen.source.offset) <= SameBend * kept.distances[corner] &&
      kept.source.first <= seen.source.first && kept.source.last >= seen.source.last &&
      seen.distances[corner] >= kept.distances[corner] * (1.0 - LeastGain);
  }

  Index add(const SeenSource& added)
  {
    if (this->Free.empty())
    {
      this->Sources.push_back(added);
      return static_cast<Index>(this->Sources.size() - 1);
    }
    const Index number = this->Free.back();
    this->Free.pop_back();
    this->Sources[number] = added;
    return number;
  }

  /** Frees a source that a side no longer has. */
  void removeUnless(const Side& has, Index number)
  {
    if (number != NoIndex &&
      std::find(has.sources.begin(), has.sources.end(), number) == has.sources.end())
    {
      this->Free.push_back(number);
    }
  }

  std::vector<Side> Sides;
  std::vector<Index> Used;
  std::vector<SeenSource> Sources;
  std::vector<Index> Free;
};

}

#endif
