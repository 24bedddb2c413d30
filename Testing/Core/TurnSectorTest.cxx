// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Where shortest paths go on from a vertex, beside the definition: a half turn or more on both
// sides.

#include "windows/TurnSector.h"
#include "RandomDraws.h"
#include "Solving.h"
#include "Surfaces.h"
#include "base/PlanePoint.h"
#include "mesh/EdgeTable.h"
#include "windows/Arrival.h"
#include "windows/LaidTriangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr double HalfTurn = std::numbers::pi;

/** Triangles round point 0 to a rim that goes up and down, and the angles there. */
struct Fan
{
  Fan(Index corners, bool isOpen, Random& random)
    : isOpen(isOpen)
  {
    Surface surface{ { { 0, 0, 0 } }, {} };
    for (Index i = 0; i < corners; ++i)
    {
      const double turn = 2.0 * HalfTurn * i / corners;
      const double length = between(0.5, 2.0, random);
      const double height = between(-1.5, 1.5, random);
      surface.points.push_back({ length * std::cos(turn), length * std::sin(turn), height });
      if (!(isOpen && i + 1 == corners))
      {
        surface.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % corners });
      }
    }
    this->mesh = meshOf(surface);
    this->center = this->mesh->vertexOfPoint(0);
    this->triangles.resize(surface.triangles.size());
    for (Index t = 0; t < this->triangles.size(); ++t)
    {
      this->triangles[this->mesh->sourceOfTriangle(t)] = t;
    }
    this->starts.push_back(0.0);
    for (const Triangle& triangle : surface.triangles)
    {
      this->rim.push_back(
        { this->mesh->vertexOfPoint(triangle[1]), this->mesh->vertexOfPoint(triangle[2]) });
      this->starts.push_back(this->starts.back() + this->angleTo(this->rim.size() - 1, 1.0));
    }
  }

  /** The point on the rim of the i-th triangle, as a part of the rim from its first point on. */
  Vector3 place(std::size_t i, double part) const
  {
    const Vector3& from = this->mesh->position(this->rim[i][0]);
    return from + part * (this->mesh->position(this->rim[i][1]) - from);
  }
  /** The angle at the center from the first point of the i-th triangle to that place. */
  double angleTo(std::size_t i, double part) const
  {
    const Vector3 a = this->place(i, 0.0) - this->mesh->position(this->center);
    const Vector3 b = this->place(i, part) - this->mesh->position(this->center);
    return std::acos(std::min(1.0, dot(a, b) / (norm(a) * norm(b))));
  }
  double directionOf(std::size_t i, double part) const
  {
    return this->starts[i] + this->angleTo(i, part);
  }
  /** The place on the rim's edge, from its lower vertex on. */
  double placeOnEdge(std::size_t i, double part) const
  {
    const auto [a, b] = this->rim[i];
    return (a < b ? part : 1.0 - part) * edgeLength(*this->mesh, a, b);
  }
  /** The half-edge opposite the center. */
  Index outerEdge(std::size_t i) const
  {
    const Triangle& corners = this->mesh->triangle(this->triangles[i]);
    const auto k = std::find(corners.begin(), corners.end(), this->center) - corners.begin();
    return 3 * this->triangles[i] + static_cast<Index>(k);
  }
  double total() const { return this->starts.back(); }

  bool isOpen;
  std::shared_ptr<const TriangleMesh> mesh;
  Index center;
  /** Of the triangles in their order round the center: numbers, ends of the rim, first directions.
   */
  std::vector<Index> triangles;
  std::vector<std::array<Index, 2>> rim;
  std::vector<double> starts;
};

bool hasPlace(const Fan& fan, const TurnSector& sector, std::size_t i, double part)
{
  const auto found = std::find_if(sector.parts().begin(), sector.parts().end(),
    [&](const TurnSector::Part& p) { return p.triangle == fan.triangles[i]; });
  if (found == sector.parts().end())
  {
    return false;
  }
  const LaidTriangle laid(*fan.mesh, fan.outerEdge(i));
  const auto [first, last] = found->litOf(laid, { laid.x, laid.y });
  const double place = fan.placeOnEdge(i, part);
  return place >= first && place <= last;
}

void expectSector(const Fan& fan, double arrivesAt, const Arrival& arrival)
{
  TurnSector sector;
  ASSERT_TRUE(sector.find(*fan.mesh, EdgeTable(*fan.mesh), fan.center, arrival, 1.0));
  constexpr double spare = 1e-3;
  for (std::size_t i = 0; i < fan.rim.size(); ++i)
  {
    for (const double part : { 0.01, 0.2, 0.4, 0.6, 0.8, 0.99 })
    {
      const double oneWay = std::abs(fan.directionOf(i, part) - arrivesAt);
      const double least = fan.isOpen ? oneWay : std::min(oneWay, fan.total() - oneWay);
      if (std::abs(least - HalfTurn) > spare)
      {
        EXPECT_EQ(hasPlace(fan, sector, i, part), least > HalfTurn)
          << "triangle " << i << " of " << fan.rim.size() << " at " << part << ", arrives at "
          << arrivesAt << " of " << fan.total() << (fan.isOpen ? ", open" : "");
      }
    }
  }
}

}

TEST(TurnSector, IsWhereBothSidesHaveAHalfTurn)
{
  Random random(1);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    const bool isOpen = happens(0.3, random);
    const Fan fan(4 + below(6, random), isOpen, random);
    if (fan.total() < (isOpen ? 1.0 : 2.0) * HalfTurn)
    {
      continue;
    }
    for (std::size_t i = 0; i < fan.rim.size(); ++i)
    {
      ++compared;
      expectSector(fan, fan.starts[i], Arrival::fromVertex(fan.rim[i][0]));
      const double part = between(0.05, 0.95, random);
      expectSector(fan, fan.directionOf(i, part),
        { Arrival::Kind::AcrossEdge, fan.outerEdge(i), fan.placeOnEdge(i, part), 0, 0, 0 });
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(TurnSector, IsUnknownWhereTrianglesAreNoFan)
{
  // Two fans that meet at a point, three triangles at an edge, and one that is there twice.
  const std::vector<Vector3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 },
    { -1, -1, 0 }, { 1, 0, 1 } };
  for (const std::vector<Triangle>& triangles : { std::vector<Triangle>{ { 0, 1, 2 }, { 0, 3, 4 } },
         std::vector<Triangle>{ { 0, 1, 2 }, { 0, 1, 4 }, { 0, 1, 5 } },
         std::vector<Triangle>{ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 2 } } })
  {
    const auto mesh = meshOf({ points, triangles });
    TurnSector sector;
    EXPECT_FALSE(sector.find(*mesh, EdgeTable(*mesh), mesh->vertexOfPoint(0),
      Arrival::fromVertex(mesh->vertexOfPoint(1)), 1.0));
  }
}
