// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "windows/WindowMerging.h"

#include "windows/Window.h"
#include "windows/WindowList.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace geodesic
{
namespace
{

/** The slope of a window's distance along the edge. */
double slopeAt(const Window& window, double at)
{
  if (window.isStraight)
  {
    return window.x;
  }
  const double length = window.lineTo(at);
  return length > 0.0 ? (at - window.x) / length : 0.0;
}

/** Whether the line that a window sends on from a point of the edge leads less far towards the
 * higher end than another one's; @p sense -1: towards the lower end. */
bool leadsLessFar(const Window& window, const Window& other, double at, double sense)
{
  constexpr double rounding = 1e-9;
  const double alone = (window.isStraight ? window.x : at - window.x) * other.y;
  const double others = (other.isStraight ? other.x : at - other.x) * window.y;
  return sense * (others - alone) > rounding * (std::abs(alone) + std::abs(others));
}

/** By how much a window is farther than another one at most, from @p from to @p to. */
double greatestGain(const Window& window, const Window& other, double from, double to)
{
  const auto gain = [&](double at) { return window.distanceAt(at) - other.distanceAt(at); };
  double greatest = std::max(gain(from), gain(to));
  // Where the lines from both sources have one direction, the gain neither grows nor falls.
  const double turn = turningPoint(window, other);
  if (turn > from && turn < to)
  {
    greatest = std::max(greatest, gain(turn));
  }
  return greatest;
}

}

WindowMerging::WindowMerging(double tolerance)
  // What is left is for rounding, also that of excesses to single precision.
  : Tolerance(0.9999 * tolerance)
{
}

void WindowMerging::merge(WindowList& list) const
{
  const std::span<Window> windows = list.windows();
  if (windows.size() < 2)
  {
    return;
  }
  std::size_t last = 0;
  for (std::size_t i = 1; i < windows.size(); ++i)
  {
    if (!this->mergeInto(windows[last], windows[i]))
    {
      windows[++last] = windows[i];
    }
  }
  list.keep(last + 1);
}

bool WindowMerging::mergeInto(Window& left, const Window& right) const
{
  constexpr double gap = 1e-13;
  if (left.seed != right.seed || right.first - left.last > gap * right.last)
  {
    return false;
  }
  // All is measured from the left end.
  const double width = right.last - left.first;
  const double join = left.last - left.first;
  const double atLeft = left.distanceAt(left.first);
  const double rise = right.distanceAt(right.last) - atLeft;
  const double riseToJoin =
    std::min(left.distanceAt(left.last), right.distanceAt(right.first)) - atLeft;
  const double mean = rise / width;
  const double room = (width - rise) * (width + rise);
  if (!(room > 0.0))
  {
    return false;
  }
  // The farther away the source of a window with these distances at its ends, the higher are those
  // between; it is as far as the two windows allow, at both ends and where they join.
  constexpr double farthest = 64.0;
  double source = farthest * (atLeft + width);
  if (const double bend = rise - slopeAt(left, left.first) * width; bend > 0.0)
  {
    source = std::min(source, 0.5 * room / bend);
  }
  if (const double bend = slopeAt(right, right.last) * width - rise; bend > 0.0)
  {
    source = std::min(source, 0.5 * room / bend - rise);
  }
  if (const double bend = join * mean - riseToJoin; bend > 0.0)
  {
    const double bound = join * room / width + riseToJoin * riseToJoin - join * join;
    source = std::min(source, 0.5 * bound / bend);
  }
  const double x = 0.5 * room / width - source * mean;
  const double square = (source - x) * (source + x);
  // A source so near an end, which may be a vertex, would have no direction but that of rounding,
  // in which its windows could turn round the vertex without end.
  constexpr double nearest = 1e-7;
  if (!(std::min(source, source + rise) > nearest * (atLeft + right.last) && square >= 0.0))
  {
    return false;
  }
  Window merged{ left.first, right.last, left.first + x, std::sqrt(square), atLeft - source,
    left.seed };
  constexpr double rounding = 1e-13;
  if (merged.distanceAt(left.last) > atLeft + riseToJoin + rounding * (atLeft + source))
  {
    return false;
  }
  // Where the lines are almost along the edge, distances tell their directions only roughly.
  if (leadsLessFar(merged, left, left.first, -1.0) || leadsLessFar(merged, right, right.last, 1.0))
  {
    return false;
  }
  const double excess = std::max(left.excess + greatestGain(left, merged, left.first, left.last),
    right.excess + greatestGain(right, merged, right.first, right.last));
  if (!(excess <= this->Tolerance * merged.leastDistance()))
  {
    return false;
  }
  merged.excess = excessOf(excess);
  left = merged;
  return true;
}

}
