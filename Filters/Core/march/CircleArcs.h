// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CircleArcs_h
#define geodesic_CircleArcs_h

#include <algorithm>
#include <numbers>
#include <vector>

namespace geodesic
{

/** A set of arcs of a circle of directions. */
class CircleArcs
{
public:
  void clear() { this->Arcs.clear(); }

  /** Adds the directions within @p half of @p centre. @param centre from -pi to pi
   * @param half at least 0; pi or more for all directions */
  void add(double centre, double half)
  {
    constexpr double pi = std::numbers::pi;
    const double first = centre - half;
    const double last = centre + half;
    if (half >= pi)
    {
      this->Arcs.push_back({ -pi, pi });
      return;
    }
    this->Arcs.push_back({ std::max(first, -pi), std::min(last, pi) });
    if (first < -pi)
    {
      this->Arcs.push_back({ first + 2.0 * pi, pi });
    }
    else if (last > pi)
    {
      this->Arcs.push_back({ -pi, last - 2.0 * pi });
    }
  }

  /** Whether each direction is in one of the arcs. Time O(n log n). */
  bool coverAll()
  {
    std::sort(this->Arcs.begin(), this->Arcs.end(),
      [](const Arc& a, const Arc& b) { return a.first < b.first; });
    double end = -std::numbers::pi;
    for (const Arc& arc : this->Arcs)
    {
      if (arc.first > end)
      {
        return false;
      }
      end = std::max(end, arc.last);
    }
    return end >= std::numbers::pi;
  }

private:
  struct Arc
  {
    double first;
    double last;
  };
  std::vector<Arc> Arcs;
};

}

#endif
