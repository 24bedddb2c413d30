// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceStore_h
#define geodesic_SourceStore_h

#include "base/Index.h"
#include "base/Platform.h"
#include "sources/SideFrame.h"
#include "sources/VirtualSource.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/**
 * The virtual sources that are kept at the sides of triangles: for each corner of the triangle the
 * one that is nearest to it. That is often the same for all three, and is then held once. What is
 * kept does not depend on the order in which sources are offered, but for rounding.
 *
 * Sides are numbered as half-edges in EdgeTable. All that a front reads of a side is in one line of
 * the cache, with its triangle laid flat: to lay it flat again at each crossing takes more time
 * than to read it. Memory: 384 bytes a vertex, and 64 for each source.
 */
class SourceStore
{
public:
  static constexpr std::size_t Corners = 3;

  struct alignas(64) Side
  {
    SideFrame frame;
    Index first;
    Index second;
    Index third;
    /** For each corner, as in SeenSource, the least distance of any source, rounded, and the number
     * of that source. */
    std::array<float, Corners> distances;
    std::array<Index, Corners> sources;
    /** Bit i: whether the source of corner i has not been visited. */
    std::uint32_t news : 3;
    /** The run to which the rest belongs. */
    std::uint32_t run : 29;
  };

  /** Time O(n). */
  explicit SourceStore(const TriangleMesh& mesh);

  /** Mean of the shortest sides of all triangles; 0 where there are none. */
  double meanShortestSide() const { return this->MeanShortestSide; }

  /** Removes all sources. Time O(1), but for one run in 500 million. */
  void clear();

  /** A side and the sources that it has. */
  const Side& side(Index number)
  {
    Side& side = this->Sides[number];
    if (side.run != this->Run)
    {
      this->reset(side);
    }
    return side;
  }
  /** Asks the processor to fetch a side that will soon be read. */
  GEODESIC_INLINED void prefetch(Index number) const { prefetchToRead(&this->Sides[number]); }

  /** The same for a source that visitNews() will visit. */
  GEODESIC_INLINED void prefetchNews(Index number) const
  {
    const Side& side = this->Sides[number];
    prefetchToRead(&this->Sources[side.sources[(side.news & 1u) != 0 ? 0
        : (side.news & 2u) != 0                                      ? 1
                                                                     : 2]]);
  }

  /** Whether a source is worth an offer: whether it is nearer to a corner than the one that is kept
   * for it, by more than LeastGain if that one comes from the same bend and lights as much. */
  bool isWorthwhile(const Side& at, const SeenSource& seen) const
  {
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      if (this->isBetter(at, seen, corner) &&
        (isFarBelow(seen.distances[corner], at.distances[corner]) ||
          !standsFor(this->Sources[at.sources[corner]], at.frame, seen, corner)))
      {
        return true;
      }
    }
    return false;
  }

  /** Keeps a source if it is nearer to a corner than the one that is kept for it. Returns whether
   * the side has become one with news by that: it had none before. */
  bool offer(Index number, const SeenSource& offered)
  {
    Side& at = this->Sides[number];
    std::uint32_t gains = 0;
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      gains |= this->isBetter(at, offered, corner) ? 1u << corner : 0u;
    }
    if (gains == 0)
    {
      return false;
    }
    const bool hadNews = at.news != 0;
    const Index added = this->add(offered.source);
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      if ((gains >> corner & 1u) != 0)
      {
        const Index old = at.sources[corner];
        at.sources[corner] = added;
        at.distances[corner] = static_cast<float>(offered.distances[corner]);
        this->removeUnless(at, old);
      }
    }
    at.news = at.news | gains;
    return !hadNews;
  }

  /** Calls @p visit with each source of a side that it has not been called with before. */
  template <class Visit>
  void visitNews(Index number, const Visit& visit)
  {
    Side& at = this->Sides[number];
    for (std::size_t corner = 0; corner < Corners; ++corner)
    {
      bool isNew = (at.news >> corner & 1u) != 0;
      for (std::size_t before = 0; before < corner; ++before)
      {
        isNew =
          isNew && !((at.news >> before & 1u) != 0 && at.sources[before] == at.sources[corner]);
      }
      if (isNew)
      {
        visit(this->Sources[at.sources[corner]]);
      }
    }
    at.news = 0;
  }

private:
  /** Distances that differ by less, relatively, are equal: they may differ by rounding. */
  static constexpr double Rounding = 1e-11;
  /** A source that gains less, relatively, over a kept one of the same bend goes no further.
   * Without that, sources that are joined on needles lower one another again and again: on a torus
   * of 40,000 points flattened 100 times 36.4 items of the queue a vertex, and 6.8 with it. It lies
   * well above the rounding of distances that are kept. */
  static constexpr double LeastGain = 1e-5;
  /** Offsets that differ by less, relatively to a distance, are those of one bend. */
  static constexpr double SameBend = 1e-9;
  /** Sources nearer to each other than this part of the side's length may be joined ones. Two that
   * see a bend by different ways round are farther apart. */
  static constexpr double SamePlace = 0.1;
  static constexpr float Far = std::numeric_limits<float>::infinity();

  /** Whether a distance is less than a rounded one by more than LeastGain. */
  static bool isFarBelow(double distance, double rounded)
  {
    return distance < rounded * (1.0 - 2.0 * LeastGain);
  }

  /** Whether a source is nearer to a corner than the kept one, or equally near, and nearer to all
   * corners together. */
  bool isBetter(const Side& at, const SeenSource& seen, std::size_t corner) const
  {
    const double distance = seen.distances[corner];
    const double rounded = at.distances[corner];
    if (isFarBelow(distance, rounded))
    {
      return true;
    }
    return distance <= rounded * (1.0 + LeastGain) && this->isBetterByLittle(at, seen, corner);
  }
  bool isBetterByLittle(const Side& at, const SeenSource& seen, std::size_t corner) const;
  static bool standsFor(
    const VirtualSource& kept, const SideFrame& frame, const SeenSource& seen, std::size_t corner);

  void reset(Side& side) const
  {
    side.distances.fill(Far);
    side.sources.fill(NoIndex);
    side.news = 0;
    side.run = this->Run;
  }

  Index add(const VirtualSource& added)
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
  std::vector<VirtualSource> Sources;
  std::vector<Index> Free;
  std::uint32_t Run : 29;
  double MeanShortestSide = 0.0;
};

}

#endif
