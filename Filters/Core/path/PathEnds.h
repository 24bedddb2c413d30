// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathEnds_h
#define geodesic_PathEnds_h

#include "base/WorkCount.h"
#include "path/PathPoint.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace geodesic
{

/** The points at which paths may end, numbered as the seeds of the field. Those of a face are
 * looked up by its corners. */
class PathEnds
{
public:
  /** Time O(n log n) for n ends. */
  PathEnds(const TriangleMesh& mesh, std::span<const SurfacePoint> ends)
  {
    this->Points.reserve(ends.size());
    this->ByCarrier.reserve(ends.size());
    for (const SurfacePoint& end : ends)
    {
      const PathPoint point = PathPoint::at(mesh, end);
      this->ByCarrier.emplace_back(point.carriers()[0], static_cast<Index>(this->Points.size()));
      this->Points.push_back(point);
    }
    std::sort(this->ByCarrier.begin(), this->ByCarrier.end());
  }

  const PathPoint& operator[](Index number) const { return this->Points[number]; }
  /** Whether there is an end of a number. */
  bool has(Index number) const { return number < this->Points.size(); }

  /** Calls @p visit with the number of each end that lies in a face. Time O(log n) for n ends, and
   * the same again for each end at a corner. */
  template <class Visit>
  void visitIn(const Triangle& face, const Visit& visit) const
  {
    for (const Index corner : face)
    {
      for (auto entry = this->firstAt(corner);
           entry != this->ByCarrier.end() && entry->first == corner; ++entry)
      {
        WorkCount::add(1);
        if (liesIn(this->Points[entry->second], face))
        {
          visit(entry->second);
        }
      }
    }
  }

  /** The least number of an end at a point; NoIndex if there is none. Time O(log n) for n ends, and
   * the same again for each end with the same first carrier. */
  Index find(const PathPoint& point) const
  {
    const Index carrier = point.carriers()[0];
    auto entry = this->firstAt(carrier);
    while (entry != this->ByCarrier.end() && entry->first == carrier)
    {
      // A path along edges can end at a vertex that is written in another way.
      const PathPoint& end = this->Points[entry->second];
      if (end == point || isSameVertex(end, point))
      {
        return entry->second;
      }
      ++entry;
    }
    return NoIndex;
  }

private:
  using Entry = std::pair<Index, Index>;

  std::vector<Entry>::const_iterator firstAt(Index carrier) const
  {
    return std::lower_bound(
      this->ByCarrier.begin(), this->ByCarrier.end(), Entry{ carrier, Index{ 0 } });
  }

  std::vector<PathPoint> Points;
  /** The first carrier of each end, and the number of the end; sorted. */
  std::vector<Entry> ByCarrier;
};

}

#endif
