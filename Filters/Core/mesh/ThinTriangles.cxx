// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ThinTriangles.h"

#include "mesh/TriangleMesh.h"

#include <algorithm>

namespace geodesic
{

ThinTriangles countThinTriangles(const TriangleMesh& mesh, const std::function<bool(Index)>& counts)
{
  constexpr double ofThin = 0.1;
  constexpr double ofNeedle = 0.02;
  // The square of the height over the longest side, in parts of that side.
  const auto narrowness = [&](const Triangle& t)
  {
    const Vector3& a = mesh.position(t[0]);
    const Vector3 ab = mesh.position(t[1]) - a;
    const Vector3 ac = mesh.position(t[2]) - a;
    const Vector3 bc = ac - ab;
    const double square = std::max({ dot(ab, ab), dot(ac, ac), dot(bc, bc) });
    const Vector3 area = cross(ab, ac);
    // Twice the area is the longest side times the height.
    return dot(area, area) / (square * square);
  };
  ThinTriangles count;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    if (counts(t))
    {
      const double narrow = narrowness(mesh.triangle(t));
      ++count.all;
      count.thin += narrow < ofThin * ofThin ? 1 : 0;
      count.needles += narrow < ofNeedle * ofNeedle ? 1 : 0;
    }
  }
  return count;
}

ThinTriangles countThinTriangles(const TriangleMesh& mesh)
{
  return countThinTriangles(mesh, [](Index) { return true; });
}

}
