// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/PathPoint.h"

#include "base/WorkCount.h"

#include <utility>

namespace geodesic
{
namespace
{

/** The point on the segment from @p a to @p b, at a fraction of it from @p a. @pre the two share a
 * face */
PathPoint between(const PathPoint& a, const PathPoint& b, double fraction)
{
  const Carriers corners = unionOf(a, b);
  PathPoint point;
  for (int i = 0; i < 3; ++i)
  {
    point.corners[i] = corners[std::min(i, corners.size() - 1)];
  }
  const auto addWeights = [&](const PathPoint& end, double share)
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto* place = std::find(corners.begin(), corners.end(), end.corners[i]);
      if (end.weights[i] > 0.0)
      {
        point.weights[place - corners.begin()] += share * end.weights[i];
      }
    }
  };
  addWeights(a, 1.0 - fraction);
  addWeights(b, fraction);
  return point;
}

}

Carriers unionOf(const PathPoint& a, const PathPoint& b)
{
  Carriers all = a.carriers();
  for (int i = 0; i < 3; ++i)
  {
    if (b.weights[i] > 0.0)
    {
      all.add(b.corners[i]);
    }
  }
  return all;
}

Triangle faceOf(const TriangleMesh& mesh, const PathPoint& a, const PathPoint& b)
{
  const Carriers corners = unionOf(a, b);
  if (corners.size() == 3)
  {
    return { corners[0], corners[1], corners[2] };
  }
  // One face of the edge or of the vertex, for each edge of a path: no list of them all.
  Index centre = corners[0];
  Index other = corners[corners.size() - 1];
  if (mesh.ring(other).size() < mesh.ring(centre).size())
  {
    std::swap(centre, other);
  }
  const std::span<const RingEntry> ring = mesh.ring(centre);
  std::size_t i = 0;
  while (!ring[i].opensTriangle() ||
    (other != centre && other != ring[i].neighbour() && other != ring[i + 1].neighbour()))
  {
    ++i;
  }
  WorkCount::add(i);
  return { centre, ring[i].neighbour(), ring[i + 1].neighbour() };
}

double weightOf(const PathPoint& point, Index vertex)
{
  double weight = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    weight += point.corners[i] == vertex ? point.weights[i] : 0.0;
  }
  return weight;
}

SurfacePoint surfacePointOf(const TriangleMesh& mesh, const PathPoint& point)
{
  const Carriers carriers = point.carriers();
  SurfacePoint result;
  result.triangle = mesh.firstTriangleWith({ carriers.begin(), carriers.end() });
  for (int i = 0; i < 3; ++i)
  {
    result.weights[i] = weightOf(point, mesh.triangle(result.triangle)[i]);
  }
  return result;
}

double lengthOf(const TriangleMesh& mesh, const SurfacePath& path)
{
  double length = 0.0;
  Vector3 before;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const Vector3 position = path[i].position(mesh);
    length += i > 0 ? norm(position - before) : 0.0;
    before = position;
  }
  return length;
}

SurfacePath beginningOf(const TriangleMesh& mesh, const SurfacePath& path, double maximumLength,
  std::size_t maximumPoints, bool cutsEdges)
{
  SurfacePath beginning;
  double length = 0.0;
  for (std::size_t i = 0; i < path.size() && beginning.size() < maximumPoints; ++i)
  {
    const double step = i == 0 ? 0.0 : norm(path[i].position(mesh) - path[i - 1].position(mesh));
    if (length + step > maximumLength)
    {
      if (cutsEdges && length < maximumLength)
      {
        beginning.push_back(between(path[i - 1], path[i], (maximumLength - length) / step));
      }
      break;
    }
    length += step;
    beginning.push_back(path[i]);
  }
  return beginning;
}

}
