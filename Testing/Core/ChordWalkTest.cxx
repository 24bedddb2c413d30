// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces along a strip's chord, and what they save.

#include "PathStyles.h"
#include "Surfaces.h"
#include "base/WorkCount.h"
#include "march/FastMarchingSolver.h"
#include "path/PathFinder.h"
#include "path/StripFunnel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

constexpr Index Cells = 30;
constexpr Index Columns = Cells + 1;

/** A strip along the lower border of a rectangle and halfway up the right one, with points in its
 * first and last face. */
class CornerStrip
{
public:
  /** @param barrierRadius of a round barrier at the middle of the strip's chord */
  explicit CornerStrip(double barrierRadius)
    : Mesh(Grid.points, Grid.triangles)
    , Closed(this->closedWithin(barrierRadius))
    , Options(optionsWith(this->Closed))
    , Progress(this->Options)
    , Weighted(this->Mesh, this->Options, this->Progress)
  {
    for (Index i = 0; i + 1 < Cells; ++i)
    {
      this->appendUpper(i, 0);
      this->appendLower(i, 0);
    }
    this->appendUpper(Cells - 1, 0);
    for (Index j = 1; j < Cells / 2; ++j)
    {
      this->appendLower(Cells - 1, j);
      this->appendUpper(Cells - 1, j);
    }
  }

  std::optional<Strip> alongChord() const
  {
    return StripFunnel(this->Weighted, this->start(), this->end(), this->Faces).stripAlongChord();
  }
  double lengthIn(const Strip& strip) const
  {
    return StripFunnel(this->Weighted, this->start(), this->end(), strip).length();
  }
  double distance() const
  {
    return norm(this->end().position(this->Mesh) - this->start().position(this->Mesh));
  }

private:
  static SolveOptions optionsWith(const std::vector<std::uint8_t>& closed)
  {
    SolveOptions options;
    options.closedTriangles = closed;
    return options;
  }
  std::vector<std::uint8_t> closedWithin(double radius) const
  {
    std::vector<std::uint8_t> closed(this->Mesh.numberOfTriangles());
    for (Index i = 0; i < closed.size(); ++i)
    {
      const Vector3 centre = this->Mesh.positionOf({ i, { 0.4, 0.3, 0.3 } });
      closed[i] = norm(centre - Vector3{ 1.5, 0.5, 0.0 }) < radius ? 1 : 0;
    }
    return closed;
  }
  // The diagonals of the cells go from their first corner to the one across.
  void appendLower(Index column, Index row) { this->append(column, row, 1, Columns + 1); }
  void appendUpper(Index column, Index row) { this->append(column, row, Columns + 1, Columns); }
  void append(Index column, Index row, Index second, Index third)
  {
    const Index first = row * Columns + column;
    const auto at = [&](Index point) { return this->Mesh.vertexOfPoint(point); };
    appendFace(this->Mesh, this->Faces, { at(first), at(first + second), at(first + third) });
  }
  static PathPoint inside(const StripFace& face) { return { face.corners(), { 0.45, 0.45, 0.1 } }; }
  PathPoint start() const { return inside(this->Faces.front()); }
  PathPoint end() const { return inside(this->Faces.back()); }

  static inline const Surface Grid = planeGrid(Cells, Cells, 3.0, 2.0);

  TriangleMesh Mesh;
  std::vector<std::uint8_t> Closed;
  SolveOptions Options;
  SearchProgress Progress;
  WeightedMesh Weighted;
  Strip Faces;
};

}

TEST(ChordWalk, LeadsStraightAcrossAPlane)
{
  const CornerStrip corner(0.0);
  const auto strip = corner.alongChord();
  ASSERT_TRUE(strip);
  EXPECT_NEAR(corner.lengthIn(*strip), corner.distance(), 1e-12);
}

TEST(ChordWalk, EndsAtABarrier)
{
  EXPECT_FALSE(CornerStrip(0.3).alongChord());
}

// Great circles; the faces looked at per point of the path, where each path came past one vertex
// after the other in some 20 rounds before: 175.
TEST(ChordWalk, MakesPathsOnASphereStraightInFewRounds)
{
  const Surface surface = icosphere(6);
  const auto mesh = std::make_shared<const TriangleMesh>(surface.points, surface.triangles);
  FastMarchingSolver solver(mesh);
  std::mt19937 random(1);
  const auto randomPoint = [&]() -> SurfacePoint {
    return { static_cast<Index>(random() % mesh->numberOfTriangles()), { 0.2, 0.5, 0.3 } };
  };
  const SurfacePoint seed = randomPoint();
  std::vector<SurfacePoint> starts(50);
  std::generate(starts.begin(), starts.end(), randomPoint);
  const SolveOptions options;
  PathFinder finder(solver, { &seed, 1 }, options, Straight);
  ASSERT_TRUE(finder.march(starts));
  std::size_t points = 0;
  const std::size_t before = WorkCount::steps();
  for (const SurfacePoint& start : starts)
  {
    const auto path = finder.pathFrom(start);
    ASSERT_TRUE(path);
    points += path->size();
    const Vector3 a = mesh->positionOf(start);
    const Vector3 b = mesh->positionOf(seed);
    const double exact = std::atan2(norm(cross(a, b)), dot(a, b));
    // Both ends lie in faces, below the sphere.
    EXPECT_NEAR(lengthOf(*mesh, *path), exact, 3e-4 * exact);
  }
  const double stepsAPoint =
    static_cast<double>(WorkCount::steps() - before) / static_cast<double>(points);
  RecordProperty("StepsAPoint", std::to_string(stepsAPoint));
  EXPECT_LT(stepsAPoint, 110.0);
}
