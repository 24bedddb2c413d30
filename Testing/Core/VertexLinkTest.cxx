// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The shorter side of a bend at a vertex where edges have many faces, against a search of all ways
// round it.

#include "path/VertexLink.h"
#include "Solving.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** A vertex at 0, point 0, with faces that each lie between two of its other points. */
struct Link
{
  Surface surface;

  void addFace(Index a, Index b) { this->surface.triangles.push_back({ 0, a, b }); }

  double angle(Index a, Index b) const
  {
    const Vector3& p = this->surface.points[a];
    const Vector3& q = this->surface.points[b];
    return std::atan2(norm(cross(p, q)), dot(p, q));
  }

  /** The smallest angles from a point to all others, face by face. */
  std::vector<double> anglesFrom(Index source) const
  {
    std::vector<double> angles(
      this->surface.points.size(), std::numeric_limits<double>::infinity());
    angles[source] = 0.0;
    for (std::size_t round = 0; round < angles.size(); ++round)
    {
      for (const auto& [centre, a, b] : this->surface.triangles)
      {
        angles[a] = std::min(angles[a], angles[b] + this->angle(a, b));
        angles[b] = std::min(angles[b], angles[a] + this->angle(a, b));
      }
    }
    return angles;
  }
};

/**
 * A narrow chain of faces through all of @p length points, whose points have dead ends as well, so
 * that the ring is many fans in no order. It is the only way from its first point to its last.
 */
Link chain(Index length, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Link link;
  link.surface.points.push_back({});
  const double turn = 2.5 / length;
  for (Index i = 0; i < length; ++i)
  {
    link.surface.points.push_back({ std::cos(turn * i), std::sin(turn * i), 0.0 });
  }
  for (Index i = 0; i < length; ++i)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    link.surface.points.push_back({ x, y, 0.5 + 0.5 * uniform(random) });
  }
  for (Index i = 0; i < length; ++i)
  {
    link.addFace(1 + i, 1 + length + i);
    if (i + 1 < length)
    {
      link.addFace(1 + i, 2 + i);
    }
  }
  std::shuffle(link.surface.triangles.begin(), link.surface.triangles.end(), random);
  return link;
}

/** Compares what is found between two points with all ways. */
void expectShorterSide(const Link& link, Index from, Index to)
{
  std::vector<Index> newId;
  const Surface mixed = withPointsShuffled(link.surface, 5, newId);
  const auto mesh = meshOf(mixed);
  const SolveOptions options;
  SearchProgress progress(options);
  const WeightedMesh weighted(*mesh, options, progress);
  VertexLink found(weighted);
  const auto at = [&](Index point) { return mesh->vertexOfPoint(newId[point]); };
  std::vector<Triangle> faces;
  const auto angle = found.appendShorterSide(
    at(0), PathPoint::atVertex(at(from)), PathPoint::atVertex(at(to)), faces);
  const double expected = link.anglesFrom(from)[to];
  ASSERT_EQ(angle.has_value(), expected < 3.14159);
  if (!angle)
  {
    return;
  }
  EXPECT_NEAR(*angle, expected, 1e-9);
  double sum = 0.0;
  for (const Triangle& face : faces)
  {
    const Vector3& p = mesh->position(face[1]);
    const Vector3& q = mesh->position(face[2]);
    sum += std::atan2(norm(cross(p, q)), dot(p, q));
  }
  EXPECT_NEAR(sum, expected, 1e-9);
}

}

TEST(VertexLink, FindsTheOnlyWayThroughManyFans)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    expectShorterSide(chain(40, seed), 1, 40);
  }
}

TEST(VertexLink, AFanThatComesToANeighbourAgainHasShortCuts)
{
  // A fan over five points, and a face from the last one back to the second.
  Link link;
  link.surface.points.push_back({});
  for (Index i = 0; i < 5; ++i)
  {
    const double turn = 0.5 * i;
    link.surface.points.push_back({ std::cos(turn), std::sin(turn), i == 2 || i == 3 ? 2.0 : 0.0 });
    if (i > 0)
    {
      link.addFace(i, i + 1);
    }
  }
  link.addFace(5, 2);
  std::mt19937 random(1);
  for (int order = 0; order < 50; ++order)
  {
    std::shuffle(link.surface.triangles.begin(), link.surface.triangles.end(), random);
    for (const auto& [from, to] : { std::pair(1, 5), std::pair(5, 1), std::pair(3, 5) })
    {
      expectShorterSide(link, from, to);
    }
  }
}

TEST(VertexLink, FindsTheShortestOfManyWays)
{
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (int test = 0; test < 50; ++test)
  {
    Link link;
    link.surface.points.push_back({});
    constexpr Index count = 40;
    for (Index i = 0; i < count; ++i)
    {
      const double x = normal(random);
      const double y = normal(random);
      link.surface.points.push_back({ x, y, normal(random) });
    }
    std::uniform_int_distribution<Index> any(1, count);
    for (Index i = 1; i < count; ++i)
    {
      link.addFace(i, i + 1);
      const Index a = any(random);
      const Index b = any(random);
      if (a != b)
      {
        link.addFace(a, b);
      }
    }
    expectShorterSide(link, 1, count);
  }
}
