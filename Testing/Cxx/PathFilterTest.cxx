// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkFastMarchingGeodesicPath: the path, its ids, its limits, and what guides it.

#include "Inputs.h"
#include "Observer.h"

#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicPath.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

std::vector<Vector3> pointsOf(vtkPolyData* data)
{
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    points.push_back({ p[0], p[1], p[2] });
  }
  return points;
}

double lengthOf(const std::vector<Vector3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += norm(points[i] - points[i - 1]);
  }
  return length;
}

std::vector<vtkIdType> idsOf(vtkIdList* list)
{
  return { list->begin(), list->end() };
}

Vector3 positionOf(vtkPolyData* data, vtkIdType id)
{
  double p[3];
  data->GetPoint(id, p);
  return { p[0], p[1], p[2] };
}

/** A path on a surface, and ways to ask it. */
class PathFilter : public ::testing::Test
{
protected:
  void setSurface(vtkSmartPointer<vtkPolyData> surface)
  {
    this->Surface = std::move(surface);
    this->Path->SetInputData(this->Surface);
    this->Surface->BuildLinks();
  }

  std::vector<Vector3> pathBetween(vtkIdType begin, vtkIdType seed)
  {
    this->Path->SetBeginPointId(begin);
    this->Path->SetSeeds(idList({ seed }));
    return this->path();
  }

  /** Runs, and checks what every output is: one polyline of all points, as long as is said; that of
   * one point is there and back. */
  std::vector<Vector3> path()
  {
    EXPECT_EQ(errorsOf(this->Path.Get()), "");
    vtkPolyData* output = this->Path->GetOutput();
    const vtkIdType count = output->GetNumberOfPoints();
    EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(output->GetNumberOfCells(), 1);
    EXPECT_EQ(output->GetNumberOfLines(), 1);
    vtkNew<vtkIdList> line;
    output->GetCellPoints(0, line);
    for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
    {
      EXPECT_EQ(line->GetId(i), std::min(i, count - 1));
    }
    EXPECT_EQ(line->GetNumberOfIds(), std::max<vtkIdType>(count, 2));
    const auto points = pointsOf(output);
    EXPECT_EQ(this->Path->GetGeodesicLength(), lengthOf(points));
    return points;
  }

  double length()
  {
    EXPECT_EQ(errorsOf(this->Path.Get()), "");
    return this->Path->GetGeodesicLength();
  }

  bool isEdge(vtkIdType a, vtkIdType b) { return this->Surface->IsEdge(a, b) != 0; }

  /** A point with a cell, at random. */
  vtkIdType pick()
  {
    std::uniform_int_distribution<vtkIdType> any(0, this->Surface->GetNumberOfPoints() - 1);
    return any(this->Random);
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkFastMarchingGeodesicPath> Path;
  std::mt19937 Random{ 1 };
};

}

TEST_F(PathFilter, IsAStraightLineOnThePlane)
{
  for (double scale : { 1.0, 1e-6, 1e6 })
  {
    this->setSurface(polyDataOf(jitteredGrid(40, 40, scale, scale, 0.3, 2)));
    for (int i = 0; i < 50; ++i)
    {
      const vtkIdType begin = this->pick();
      const vtkIdType seed = this->pick();
      const double exact = distanceBetween(this->Surface, begin, seed);
      this->Path->StraightenOff();
      const auto traced = this->pathBetween(begin, seed);
      EXPECT_EQ(norm(traced.front() - positionOf(this->Surface, begin)), 0.0);
      EXPECT_EQ(norm(traced.back() - positionOf(this->Surface, seed)), 0.0);
      EXPECT_NEAR(lengthOf(traced), exact, 1e-9 * scale);
      this->Path->StraightenOn();
      EXPECT_NEAR(lengthOf(this->pathBetween(begin, seed)), exact, 1e-12 * scale);
    }
  }
}

// Great circle: R acos. Chords are shorter by (h / R)^2 / 24, here 2e-4, with edges of h = R / 14.
TEST_F(PathFilter, IsAGreatCircleOnTheSphere)
{
  this->setSurface(polyDataOf(icosphere(4)));
  this->Path->StraightenOn();
  for (int i = 0; i < 50; ++i)
  {
    const vtkIdType begin = this->pick();
    const vtkIdType seed = this->pick();
    const auto points = this->pathBetween(begin, seed);
    const double arc = std::acos(std::clamp(dot(points.front(), points.back()), -1.0, 1.0));
    EXPECT_NEAR(lengthOf(points), arc, 1e-3 * arc);
  }
}

TEST_F(PathFilter, AtOrderZeroIsTheShortestAlongEdges)
{
  this->setSurface(readData("Spot.vtp"));
  this->Path->SetInterpolationOrder(0);
  vtkNew<vtkDijkstraGraphGeodesicPath> dijkstra;
  dijkstra->SetInputData(this->Surface);
  for (int i = 0; i < 20; ++i)
  {
    const vtkIdType begin = this->pick();
    const vtkIdType seed = this->pick();
    const auto points = this->pathBetween(begin, seed);
    const auto ids = idsOf(this->Path->GetZerothOrderPathPointIds());
    EXPECT_EQ(this->Path->GetFirstOrderPathPointIds()->GetNumberOfIds(), 0);
    ASSERT_EQ(ids.size(), points.size());
    EXPECT_EQ(ids.front(), begin);
    EXPECT_EQ(ids.back(), seed);
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      EXPECT_EQ(norm(points[k] - positionOf(this->Surface, ids[k])), 0.0);
      EXPECT_TRUE(k == 0 || this->isEdge(ids[k - 1], ids[k]));
    }
    dijkstra->SetStartVertex(begin);
    dijkstra->SetEndVertex(seed);
    dijkstra->Update();
    std::vector<Vector3> truth;
    for (vtkIdType id : idsOf(dijkstra->GetIdList()))
    {
      truth.push_back(positionOf(this->Surface, id));
    }
    EXPECT_NEAR(lengthOf(points), lengthOf(truth), 1e-12);
  }
}

TEST_F(PathFilter, NamesTheEdgesThatItsPointsLieOn)
{
  this->setSurface(readData("Spot.vtp"));
  for (bool straighten : { false, true })
  {
    this->Path->SetStraighten(straighten);
    const auto points = this->pathBetween(17, 2000);
    const auto ends = idsOf(this->Path->GetFirstOrderPathPointIds());
    ASSERT_EQ(ends.size(), 2 * points.size());
    EXPECT_EQ(ends.front(), 17);
    EXPECT_EQ(ends[ends.size() - 2], 2000);
    std::vector<vtkIdType> nearest;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const vtkIdType a = ends[2 * i];
      const vtkIdType b = ends[2 * i + 1];
      ASSERT_TRUE(this->isEdge(a, b));
      const double toA = norm(points[i] - positionOf(this->Surface, a));
      const double toB = norm(points[i] - positionOf(this->Surface, b));
      const double edge = distanceBetween(this->Surface, a, b);
      EXPECT_NEAR(toA + toB, edge, 1e-12);
      EXPECT_LE(toA, toB * (1.0 + 1e-9));
      if (nearest.empty() || nearest.back() != a)
      {
        nearest.push_back(a);
      }
    }
    EXPECT_EQ(idsOf(this->Path->GetZerothOrderPathPointIds()), nearest);
    EXPECT_LT(nearest.size(), points.size());
  }
}

TEST_F(PathFilter, EndsAtTheNearestSeed)
{
  this->setSurface(polyDataOf(jitteredGrid(40, 40, 1.0, 1.0, 0.3, 2)));
  this->Path->StraightenOn();
  for (int i = 0; i < 100; ++i)
  {
    const vtkIdType begin = this->pick();
    vtkNew<vtkIdList> seeds;
    double least = std::numeric_limits<double>::infinity();
    for (int s = 0; s < 6; ++s)
    {
      seeds->InsertNextId(this->pick());
      least = std::min(least, distanceBetween(this->Surface, begin, seeds->GetId(s)));
    }
    this->Path->SetBeginPointId(begin);
    this->Path->SetSeeds(seeds);
    EXPECT_NEAR(lengthOf(this->path()), least, 1e-12);
  }
}

TEST_F(PathFilter, WhereItBeginsAtASeedIsOnePoint)
{
  this->setSurface(square(4));
  for (int order : { 0, 1 })
  {
    this->Path->SetInterpolationOrder(order);
    EXPECT_EQ(this->pathBetween(7, 7).size(), 1u);
    EXPECT_EQ(this->Path->GetGeodesicLength(), 0.0);
    EXPECT_EQ(idsOf(this->Path->GetZerothOrderPathPointIds()), std::vector<vtkIdType>{ 7 });
    this->Path->SetSeeds(idList({ 2, 7, 9 }));
    EXPECT_EQ(this->path().size(), 1u);
  }
  EXPECT_EQ(this->Path->GetFirstOrderPathPointIds()->GetId(0), 7);
}

TEST_F(PathFilter, EndsWithinItsLimits)
{
  this->setSurface(readData("Spot.vtp"));
  for (int order : { 0, 1 })
  {
    this->Path->SetInterpolationOrder(order);
    const auto whole = this->pathBetween(17, 2000);
    const auto expectBeginning = [&](std::size_t size)
    {
      const auto points = this->path();
      ASSERT_EQ(points.size(), size);
      for (std::size_t i = 0; i < size; ++i)
      {
        EXPECT_EQ(norm(points[i] - whole[i]), 0.0);
      }
      EXPECT_EQ(this->Path->GetFirstOrderPathPointIds()->GetNumberOfIds(), 2 * order * size);
    };
    std::size_t half = 0;
    while (lengthOf({ whole.begin(), whole.begin() + half + 1 }) <= 0.5 * lengthOf(whole))
    {
      ++half;
    }
    this->Path->SetMaximumPathLength(0.5 * lengthOf(whole));
    expectBeginning(half);
    this->Path->SetMaximumPathPoints(5);
    expectBeginning(5);
    this->Path->SetMaximumPathLength(VTK_DOUBLE_MAX);
    expectBeginning(5);
    this->Path->SetMaximumPathPoints(1);
    expectBeginning(1);
    this->Path->SetMaximumPathPoints(VTK_ID_MAX);
    this->Path->SetMaximumPathLength(0.0);
    expectBeginning(1);
    this->Path->SetMaximumPathLength(1e9);
    expectBeginning(whole.size());
  }
}

// Through half planes of cost 1 and 3 the way of least cost is bent as light is.
TEST_F(PathFilter, IsBentByWeights)
{
  const int cells = 100;
  this->setSurface(square(cells));
  vtkNew<vtkDoubleArray> weights;
  for (const Vector3& p : pointsOf(this->Surface))
  {
    weights->InsertNextValue(p.x < 0.5 * cells ? 1.0 : 3.0);
  }
  const Vector3 from{ 10.0, 20.0, 0.0 };
  const Vector3 to{ 90.0, 80.0, 0.0 };
  const vtkIdType begin = 20 * (cells + 1) + 10;
  const vtkIdType seed = 80 * (cells + 1) + 90;
  const auto crossing = [&]
  {
    double y = 0.0;
    for (const Vector3& p : this->path())
    {
      y = p.x <= 0.5 * cells ? p.y : y;
    }
    return y;
  };
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (double y = 0.0; y < cells; y += 0.01)
  {
    const Vector3 p{ 0.5 * cells, y, 0.0 };
    const double cost = norm(p - from) + 3.0 * norm(to - p);
    best = cost < least ? y : best;
    least = std::min(cost, least);
  }
  this->pathBetween(begin, seed);
  EXPECT_NEAR(crossing(), 50.0, 1e-6);
  this->Path->GetGeodesic()->SetPropagationWeights(weights);
  EXPECT_NEAR(crossing(), best, 2.0);
  EXPECT_GT(best, 60.0);
  // An array counts by its own modification time; the costs are what they are on the first run.
  weights->Fill(2.0);
  weights->Modified();
  EXPECT_NEAR(crossing(), 50.0, 0.5);
  this->Path->GetGeodesic()->SetPropagationWeights(nullptr);
  EXPECT_NEAR(crossing(), 50.0, 1e-6);
}

TEST_F(PathFilter, KeepsOffExclusionPoints)
{
  const int cells = 20;
  this->setSurface(square(cells));
  const auto id = [](int i, int j) { return vtkIdType{ j } * (cells + 1) + i; };
  vtkNew<vtkIdList> wall;
  for (int j = 0; j <= 15; ++j)
  {
    wall->InsertNextId(id(10, j));
  }
  this->Path->GetGeodesic()->SetExclusionPointIds(wall);
  for (int order : { 0, 1 })
  {
    this->Path->SetInterpolationOrder(order);
    for (const Vector3& p : this->pathBetween(id(5, 2), id(15, 2)))
    {
      EXPECT_FALSE(p.x > 9.0 && p.x < 11.0 && p.y < 15.0) << p.x << " " << p.y;
    }
  }
  this->Path->StraightenOn();
  // Round the tip of the wall, or past the free cells beside it.
  EXPECT_GT(this->length(), 2.0 * std::hypot(5.0, 13.0) - 1e-9);
  EXPECT_LT(this->length(), 2.0 * std::hypot(5.0, 13.0) + 4.0);
  // Edited in place.
  wall->Reset();
  EXPECT_NEAR(this->length(), 10.0, 1e-12);
}

// Where the front stops before the begin point there is no path; where it does not, it is the same.
TEST_F(PathFilter, HeedsTheStopsOfTheFront)
{
  this->setSurface(polyDataOf(jitteredGrid(40, 40, 1.0, 1.0, 0.3, 2)));
  vtkFastMarchingGeodesicDistance* geodesic = this->Path->GetGeodesic();
  const vtkIdType begin = 300;
  const vtkIdType seed = 1200;
  const double distance = distanceBetween(this->Surface, begin, seed);
  const auto whole = this->pathBetween(begin, seed);
  const auto expectWhole = [&]
  {
    const auto points = this->path();
    ASSERT_EQ(points.size(), whole.size());
    EXPECT_NEAR(lengthOf(points), lengthOf(whole), 1e-12);
  };
  const auto expectNone = [&](const std::string& named)
  {
    const std::string errors = errorsOf(this->Path.Get());
    EXPECT_NE(errors.find("begin point 300 to seed point 1200 within"), std::string::npos);
    EXPECT_NE(errors.find(named), std::string::npos) << errors;
    EXPECT_EQ(this->Path->GetOutput()->GetNumberOfPoints(), 0);
  };
  geodesic->SetDistanceStopCriterion(1.0001 * distance);
  expectWhole();
  geodesic->SetDistanceStopCriterion(0.25);
  expectNone("distance 0.25");
  geodesic->SetDistanceStopCriterion(-1.0);

  vtkIdType nearer = 0;
  vtkIdType farther = 0;
  for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
  {
    const double d = distanceBetween(this->Surface, i, seed);
    nearer = d > 0.5 * distance && d < 0.9 * distance ? i : nearer;
    farther = d > 1.1 * distance ? i : farther;
  }
  geodesic->SetDestinationVertexStopCriterion(idList({ farther, nearer }));
  expectNone("DestinationVertexStopCriterion");
  geodesic->SetDestinationStopModeToAll();
  expectWhole();
  geodesic->SetDestinationStopModeToAny();
  geodesic->SetDestinationVertexStopCriterion(idList({ farther }));
  expectWhole();
  geodesic->SetDestinationVertexStopCriterion(idList({ begin }));
  expectWhole();
}

TEST_F(PathFilter, LeavesTheDistanceFilterAsItIs)
{
  this->setSurface(square(20));
  vtkFastMarchingGeodesicDistance* geodesic = this->Path->GetGeodesic();
  geodesic->SetInputData(this->Surface);
  geodesic->SetFieldDataName("d");
  this->pathBetween(0, 440);
  geodesic->Update();
  const vtkMTimeType time = geodesic->GetMTime();
  vtkDataArray* field = geodesic->GetOutput()->GetPointData()->GetArray("d");
  this->Path->SetBeginPointId(42);
  this->path();
  EXPECT_EQ(geodesic->GetMTime(), time);
  EXPECT_EQ(geodesic->GetNumberOfVisitedPoints(), 441);
  EXPECT_NEAR(geodesic->GetMaximumDistance(), 20.0 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(geodesic->GetDestinationVertexStopCriterion(), nullptr);
  EXPECT_EQ(geodesic->GetOutput()->GetPointData()->GetArray("d"), field);
  EXPECT_NEAR(field->GetComponent(0, 0), 20.0 * std::sqrt(2.0), 1e-9);
}

TEST_F(PathFilter, RunsAgainWhenSomethingChangedAndOnlyThen)
{
  this->setSurface(square(20));
  this->Path->StraightenOn();
  vtkSmartPointer<vtkIdList> seeds = idList({ 20 });
  this->Path->SetBeginPointId(0);
  this->Path->SetSeeds(seeds);
  int runs = 0;
  Observer observer(this->Path, vtkCommand::StartEvent, [&] { ++runs; });
  EXPECT_NEAR(this->length(), 20.0, 1e-12);
  EXPECT_NEAR(this->length(), 20.0, 1e-12);
  EXPECT_EQ(runs, 1);
  seeds->SetId(0, 440);
  EXPECT_NEAR(this->length(), 20.0 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(runs, 2);
  this->Path->GetGeodesic()->SetDistanceStopCriterion(100.0);
  this->length();
  EXPECT_EQ(runs, 3);
  this->Surface->GetPoints()->SetPoint(440, 20.0, 20.0, 1.0);
  this->Surface->GetPoints()->Modified();
  this->Surface->Modified();
  EXPECT_GT(this->length(), 20.0 * std::sqrt(2.0) + 1e-6);
  EXPECT_EQ(runs, 4);
}

TEST_F(PathFilter, ItsFrontStopsAtTheBeginPoint)
{
  this->setSurface(square(100));
  int events = 0;
  Observer observer(
    this->Path->GetGeodesic(), vtkFastMarchingGeodesicDistance::IterationEvent, [&] { ++events; });
  this->Path->GetGeodesic()->SetIterationEventResolution(10);
  this->pathBetween(0, 10200);
  // From corner to corner it goes nearly everywhere.
  EXPECT_GE(events, 10201 / 10 * 3 / 4);
  events = 0;
  // Within 5 cells there are some 80 points.
  this->pathBetween(5050, 5055);
  EXPECT_GT(events, 3);
  EXPECT_LT(events, 30);
}

TEST_F(PathFilter, ReportsProgressAndCanBeAborted)
{
  this->setSurface(square(100));
  this->Path->SetBeginPointId(0);
  this->Path->SetSeeds(idList({ 10200 }));
  for (vtkAlgorithm* aborted :
    std::initializer_list<vtkAlgorithm*>{ this->Path, this->Path->GetGeodesic() })
  {
    std::vector<double> progress;
    bool aborts = true;
    {
      Observer observer(this->Path, vtkCommand::ProgressEvent,
        [&]
        {
          progress.push_back(this->Path->GetProgress());
          aborted->SetAbortExecute(aborts && progress.back() > 0.3);
        });
      this->Path->Modified();
      this->Path->Update();
      EXPECT_GT(progress.size(), 10u);
      EXPECT_LT(progress.size(), 60u);
      EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
      EXPECT_EQ(this->Path->GetOutput()->GetNumberOfPoints(), 0);
      EXPECT_EQ(this->Path->GetGeodesicLength(), 0.0);
      aborts = false;
      aborted->SetAbortExecute(0);
      this->Path->Modified();
      EXPECT_NEAR(lengthOf(this->path()), 100.0 * std::sqrt(2.0), 1e-9);
    }
    this->Path->RemoveAllObservers();
  }
}
