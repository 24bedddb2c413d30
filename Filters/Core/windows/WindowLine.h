// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowLine_h
#define geodesic_WindowLine_h

#include "base/Index.h"
#include "windows/Arrival.h"
#include "windows/Window.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace geodesic
{

/** A straight line that misses a point by so little, in lengths of the edge that it crosses, ends
 * there with no error to speak of, as the detour grows with the square. Without this, rounding
 * could leave a point between two windows. */
inline constexpr double LineMiss = 1e-7;

/** How a straight line of a window across a half-edge comes to a point in its triangle's plane. */
struct WindowLine
{
  double distance;
  Arrival arrival;
};

/**
 * The line of a window to a point, if the window lights it but for a miss of no importance.
 * @param x, y    the point, in the plane of the half-edge (see Window)
 * @param length  of the edge
 */
inline std::optional<WindowLine> lineTo(
  const Window& window, Index halfEdge, double x, double y, double length)
{
  const double miss = LineMiss * length;
  const double height = window.y + y;
  const double at = height > 0.0 ? window.placeTowards(x, y) : x;
  if (at >= window.first && at <= window.last)
  {
    const double along = x - window.x;
    const double line =
      window.isStraight ? window.x * x + window.y * y : std::sqrt(along * along + height * height);
    // A straight front may start below 0, so rounding could leave less than 0 on its own line.
    return WindowLine{ std::max(0.0, window.offset + line),
      { Arrival::Kind::AcrossEdge, halfEdge, at, window.x, window.y, window.offset } };
  }
  if (at > window.first - miss && at < window.last + miss)
  {
    const double end = at < window.first ? window.first : window.last;
    return WindowLine{ window.distanceAt(end) + std::hypot(end - x, y),
      { Arrival::Kind::AcrossEdge, halfEdge, end, window.x, window.y, window.offset } };
  }
  return std::nullopt;
}

}

#endif
