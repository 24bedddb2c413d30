// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_HubTies_h
#define geodesic_HubTies_h

#include "base/Index.h"
#include "march/HubVertices.h"

#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace geodesic
{

/**
 * Of dense labels that are equally near at a hub, lets only that of the smallest number go on:
 * thousands of seeds round a pole would all go on into each of its triangles.
 */
class HubTies
{
public:
  /** Whether a value goes on from a vertex. @param entries  in the vertex's ring */
  bool goesOn(Index vertex, std::size_t entries, Index label, double distance)
  {
    if (entries <= MostTrianglesElsewhere)
    {
      return true;
    }
    const auto [place, isFirst] = this->Passed.try_emplace(vertex, Label{ label, distance });
    Label& passed = place->second;
    if (isFirst || label == passed.label)
    {
      passed.distance = distance;
      return true;
    }
    const bool isTie = std::abs(distance - passed.distance) <= Rounding * distance;
    if (isTie && label > passed.label)
    {
      return false;
    }
    if (isTie || distance < passed.distance)
    {
      passed = { label, distance };
    }
    return true;
  }

private:
  static constexpr double Rounding = 1e-9;

  struct Label
  {
    Index label;
    double distance;
  };
  /** For each hub the nearest that went on. */
  std::unordered_map<Index, Label> Passed;
};

}

#endif
