// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorstSeeds.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace geodesic::testing
{
namespace
{

/** Where a function with these values at two corners of a triangle is 0. Both triangles beside the
 * edge find the same number, as it is reckoned from the lower corner. */
SurfacePoint crossingOf(
  const TriangleMesh& mesh, Index triangle, int i, int k, const std::array<double, 3>& heights)
{
  const Triangle& corners = mesh.triangle(triangle);
  if (corners[i] > corners[k])
  {
    std::swap(i, k);
  }
  SurfacePoint point{ triangle, {} };
  point.weights[k] = heights[i] / (heights[i] - heights[k]);
  point.weights[i] = 1.0 - point.weights[k];
  return snapped(point);
}

}

std::vector<Index> randomVertices(const TriangleMesh& mesh, Index count, std::mt19937& random)
{
  std::vector<Index> vertices(mesh.numberOfVertices());
  std::iota(vertices.begin(), vertices.end(), 0u);
  std::shuffle(vertices.begin(), vertices.end(), random);
  vertices.resize(std::min<std::size_t>(count, vertices.size()));
  return vertices;
}

SurfacePoint randomPoint(const TriangleMesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double a = uniform(random);
  double b = uniform(random);
  if (a + b > 1.0)
  {
    a = 1.0 - a;
    b = 1.0 - b;
  }
  return snapped(
    { static_cast<Index>(random() % mesh.numberOfTriangles()), { 1.0 - a - b, a, b } });
}

std::vector<Index> trianglesRound(const TriangleMesh& mesh, Index triangle, Index count)
{
  const auto centreOf = [&](Index of) {
    return mesh.positionOf({ of, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
  };
  const Vector3 centre = centreOf(triangle);
  std::vector<std::pair<double, Index>> sorted;
  for (Index other = 0; other < mesh.numberOfTriangles(); ++other)
  {
    sorted.emplace_back(norm(centreOf(other) - centre), other);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> triangles;
  for (std::size_t i = 0; i < std::min<std::size_t>(count, sorted.size()); ++i)
  {
    triangles.push_back(sorted[i].second);
  }
  return triangles;
}

std::vector<Segment> segmentsAtZero(
  const TriangleMesh& mesh, const std::function<double(const Vector3&)>& height)
{
  std::vector<Segment> segments;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    std::array<double, 3> heights;
    std::transform(mesh.triangle(t).begin(), mesh.triangle(t).end(), heights.begin(),
      [&](Index corner) { return height(mesh.position(corner)); });
    std::vector<SurfacePoint> crossings;
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      if ((heights[i] > 0.0) != (heights[next] > 0.0))
      {
        crossings.push_back(crossingOf(mesh, t, i, next, heights));
      }
    }
    if (!crossings.empty())
    {
      segments.push_back({ crossings[0], crossings[1] });
    }
  }
  return segments;
}

std::vector<Segment> boundarySegments(const TriangleMesh& mesh)
{
  std::map<std::pair<Index, Index>, int> triangles;
  for (Index t = 0; t < mesh.numberOfTriangles(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++triangles[std::minmax({ mesh.triangle(t)[i], mesh.triangle(t)[(i + 1) % 3] })];
    }
  }
  std::vector<Segment> segments;
  for (const auto& [ends, count] : triangles)
  {
    if (count == 1)
    {
      segments.push_back({ mesh.pointAtVertex(ends.first), mesh.pointAtVertex(ends.second) });
    }
  }
  return segments;
}

std::vector<Segment> randomEdges(const TriangleMesh& mesh, Index count, std::mt19937& random)
{
  std::vector<Segment> segments;
  while (segments.size() < count)
  {
    const Triangle& corners = mesh.triangle(random() % mesh.numberOfTriangles());
    segments.push_back({ mesh.pointAtVertex(corners[0]), mesh.pointAtVertex(corners[1]) });
  }
  return segments;
}

std::vector<Seed> looseSeeds(const std::vector<Segment>& segments)
{
  std::vector<Seed> seeds;
  for (const Segment& segment : segments)
  {
    seeds.push_back(Seed::alongCurve({ segment[0], segment[1] }));
  }
  return seeds;
}

Seed seedAlong(const TriangleMesh& mesh, std::vector<Segment> segments)
{
  const auto along = [&](const SurfacePoint& point) { return mesh.positionOf(point).x; };
  for (Segment& segment : segments)
  {
    std::sort(segment.begin(), segment.end(),
      [&](const SurfacePoint& a, const SurfacePoint& b) { return along(a) < along(b); });
  }
  std::sort(segments.begin(), segments.end(),
    [&](const Segment& a, const Segment& b) { return along(a[0]) < along(b[0]); });
  std::vector<SurfacePoint> points{ segments.front()[0] };
  for (const Segment& segment : segments)
  {
    points.push_back(segment[1]);
  }
  return Seed::alongCurve(std::move(points));
}

}
