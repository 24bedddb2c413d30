// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "split/BaseMeshPath.h"

#include <algorithm>

namespace geodesic
{
namespace
{

/** A path counts as straight at a point if the sine of its bend is not above this. */
constexpr double StraightSine = 1e-9;

bool isStraightAt(const Vector3& before, const Vector3& here, const Vector3& after)
{
  const Vector3 in = here - before;
  const Vector3 out = after - here;
  return norm(cross(in, out)) <= StraightSine * norm(in) * norm(out) && dot(in, out) >= 0.0;
}

}

PathPoint basePoint(const PathPoint& point, const OriginOf& originOf)
{
  Carriers corners;
  for (const Index vertex : point.carriers())
  {
    for (const Index baseVertex : originOf(vertex).carriers())
    {
      corners.add(baseVertex);
    }
  }
  PathPoint base;
  for (int i = 0; i < 3; ++i)
  {
    base.corners[i] = corners[std::min(i, corners.size() - 1)];
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; point.weights[i] > 0.0 && c < corners.size(); ++c)
    {
      base.weights[c] += point.weights[i] * weightOf(originOf(point.corners[i]), corners[c]);
    }
  }
  return base;
}

SurfacePath basePath(const TriangleMesh& split, const SurfacePath& path, const OriginOf& originOf)
{
  SurfacePath base;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const PathPoint point = basePoint(path[i], originOf);
    const bool isEnd = i == 0 || i + 1 == path.size();
    const bool isStraight = !isEnd && point.carriers().size() == 3 &&
      isStraightAt(
        path[i - 1].position(split), path[i].position(split), path[i + 1].position(split));
    if (!isStraight)
    {
      base.push_back(point);
    }
  }
  return base;
}

}
