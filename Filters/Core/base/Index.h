// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Index_h
#define geodesic_Index_h

#include <algorithm>
#include <array>
#include <cstdint>

namespace geodesic
{

/** The number of a point, vertex, triangle or seed inside Core. */
using Index = std::uint32_t;

/** Stands for no point, vertex, triangle or seed. */
inline constexpr Index NoIndex = 0xffffffffu;

/** Three corners, as point ids of the input or as vertices of a TriangleMesh. */
using Triangle = std::array<Index, 3>;

inline Index lowestCorner(const Triangle& t)
{
  return std::min(std::min(t[0], t[1]), t[2]);
}
inline Index highestCorner(const Triangle& t)
{
  return std::max(std::max(t[0], t[1]), t[2]);
}
inline Triangle sortedCorners(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

}

#endif
