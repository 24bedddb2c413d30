// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPolygonalSurfaceContourLineInterpolator2: its lines, their ids, and what is no line.

#include "Inputs.h"
#include "TracedContour.h"

#include "vtkCellArray.h"
#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicPath.h"
#include "vtkFocalPlanePointPlacer.h"
#include "vtkIntArray.h"
#include "vtkPolyDataCollection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

class Interpolator : public ::testing::Test
{
protected:
  void useMethod(int method, int order)
  {
    this->Traced.Interpolator->SetGeodesicMethod(method);
    this->Traced.Interpolator->SetInterpolationOrder(order);
  }

  void traceLine(vtkPolyData* surface, vtkIdType begin, vtkIdType end)
  {
    this->Traced.clear();
    this->Traced.addNode(surface, begin);
    this->Traced.addNode(surface, end);
  }

  double lengthOf(vtkPolyData* surface, vtkIdType begin, vtkIdType end)
  {
    this->traceLine(surface, begin, end);
    return this->Traced.lineLength(0);
  }

  /** A point with a cell, at random. */
  vtkIdType pick(vtkPolyData* surface)
  {
    std::uniform_int_distribution<vtkIdType> any(0, surface->GetNumberOfPolys() - 1);
    vtkNew<vtkIdList> corners;
    surface->GetCellPoints(any(this->Random), corners);
    return corners->GetId(0);
  }

  void expectNoLine()
  {
    EXPECT_EQ(this->Traced.Interpolator->lastResult(), 0);
    EXPECT_EQ(this->Traced.Contour->GetNumberOfIntermediatePoints(0), 0);
  }

  TracedContour Traced;
  std::mt19937 Random{ 1 };
};

constexpr int Dijkstra = vtkPolygonalSurfaceContourLineInterpolator2::DijkstraMethod;
constexpr int FastMarching = vtkPolygonalSurfaceContourLineInterpolator2::FastMarchingMethod;

}

TEST_F(Interpolator, HasTheDefaultsOfTheArticle)
{
  EXPECT_EQ(this->Traced.Interpolator->GetGeodesicMethod(), Dijkstra);
  EXPECT_EQ(this->Traced.Interpolator->GetInterpolationOrder(), 0);
  EXPECT_EQ(this->Traced.Interpolator->GetDistanceOffset(), 0.0);
  EXPECT_EQ(this->Traced.Interpolator->UpdateNode(nullptr, nullptr, nullptr, 0), 0);
}

TEST_F(Interpolator, OfOrderZeroRunsThroughPointsAlongEdges)
{
  const auto surface = readData("Spot.vtp");
  surface->BuildLinks();
  this->Traced.addSurface(surface);
  vtkNew<vtkDijkstraGraphGeodesicPath> dijkstra;
  dijkstra->SetInputData(surface);
  for (int method : { Dijkstra, FastMarching })
  {
    this->useMethod(method, 0);
    for (int i = 0; i < 10; ++i)
    {
      const vtkIdType begin = this->pick(surface);
      const vtkIdType end = this->pick(surface);
      const double length = this->lengthOf(surface, begin, end);
      const std::vector<vtkIdType> ids = this->Traced.lineIds(0);
      ASSERT_GE(ids.size(), 2u);
      EXPECT_EQ(ids.front(), begin);
      EXPECT_EQ(ids.back(), end);
      EXPECT_EQ(this->Traced.Contour->GetNthNode(0)->PointId, begin);
      EXPECT_EQ(this->Traced.Contour->GetNthNode(1)->PointId, end);
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        EXPECT_TRUE(k == 0 || surface->IsEdge(ids[k - 1], ids[k]));
        double p[3];
        this->Traced.Contour->GetIntermediatePointWorldPosition(0, static_cast<int>(k), p);
        EXPECT_TRUE(std::equal(p, p + 3, surface->GetPoint(ids[k])));
      }
      dijkstra->SetStartVertex(begin);
      dijkstra->SetEndVertex(end);
      dijkstra->Update();
      vtkIdList* truth = dijkstra->GetIdList();
      double shortest = 0.0;
      for (vtkIdType k = 1; k < truth->GetNumberOfIds(); ++k)
      {
        shortest += distanceBetween(surface, truth->GetId(k - 1), truth->GetId(k));
      }
      EXPECT_NEAR(length, shortest, 1e-12);
    }
  }
}

TEST_F(Interpolator, OfOrderOneIsStraightOnThePlane)
{
  const auto surface = polyDataOf(jitteredGrid(40, 40, 20.0, 20.0, 0.3, 2));
  this->Traced.addSurface(surface);
  this->useMethod(FastMarching, 1);
  for (int i = 0; i < 20; ++i)
  {
    const vtkIdType begin = this->pick(surface);
    const vtkIdType end = this->pick(surface);
    EXPECT_NEAR(this->lengthOf(surface, begin, end), distanceBetween(surface, begin, end), 1e-10);
    const std::vector<vtkIdType> ids = this->Traced.lineIds(0);
    EXPECT_EQ(ids.front(), begin);
    EXPECT_EQ(ids.back(), end);
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      double p[3];
      this->Traced.Contour->GetIntermediatePointWorldPosition(0, static_cast<int>(k), p);
      double q[3];
      surface->GetPoint(ids[k], q);
      // The nearer end of an edge, none of which is longer than a cell's stretched diagonal.
      EXPECT_LT(std::hypot(p[0] - q[0], p[1] - q[1]), 0.5 * 0.5 * std::sqrt(2.0) * 1.6);
    }
  }
}

// The one that the path filter straightens, which is shorter than as it is traced.
TEST_F(Interpolator, OfOrderOneIsStraightened)
{
  const auto surface = readData("Spot.vtp");
  this->Traced.addSurface(surface);
  this->useMethod(FastMarching, 1);
  vtkNew<vtkFastMarchingGeodesicPath> path;
  path->SetInputData(surface);
  for (int i = 0; i < 20; ++i)
  {
    const vtkIdType begin = this->pick(surface);
    const vtkIdType end = this->pick(surface);
    const double length = this->lengthOf(surface, begin, end);
    path->SetBeginPointId(end);
    path->SetSeeds(idList({ begin }));
    path->StraightenOff();
    path->Update();
    EXPECT_LT(length, path->GetGeodesicLength() * (1.0 - 1e-9));
    path->StraightenOn();
    path->Update();
    EXPECT_NEAR(length, path->GetGeodesicLength(), 1e-12);
  }
}

// Dijkstra's lines run along edges whatever the order.
TEST_F(Interpolator, OfDijkstraHasNoOrderOne)
{
  const auto surface = square(20);
  this->Traced.addSurface(surface);
  this->useMethod(Dijkstra, 1);
  EXPECT_NEAR(this->lengthOf(surface, 0, 21 * 10 + 20), 10.0 * std::sqrt(2.0) + 10.0, 1e-12);
  this->useMethod(FastMarching, 1);
  EXPECT_NEAR(this->lengthOf(surface, 0, 21 * 10 + 20), std::hypot(10.0, 20.0), 1e-12);
}

// The article: "first order paths are shorter".
TEST_F(Interpolator, OfOrderOneIsShorterThanBothOfOrderZeroOnTheBunny)
{
  const auto surface = readData("Bunny.vtp");
  this->Traced.addSurface(surface);
  for (int i = 0; i < 50; ++i)
  {
    const vtkIdType begin = this->pick(surface);
    const vtkIdType end = this->pick(surface);
    this->useMethod(FastMarching, 1);
    const double first = this->lengthOf(surface, begin, end);
    EXPECT_GT(first, distanceBetween(surface, begin, end));
    for (int method : { Dijkstra, FastMarching })
    {
      this->useMethod(method, 0);
      EXPECT_LT(first, this->lengthOf(surface, begin, end)) << begin << " " << end;
    }
  }
}

TEST_F(Interpolator, RaisesLinesAlongUnitNormals)
{
  const auto sphere = polyDataOf(icosphere(3));
  this->Traced.addSurface(sphere);
  this->Traced.Interpolator->SetDistanceOffset(0.25);
  const auto heights = [&]
  {
    std::vector<double> heights;
    this->traceLine(sphere, 3, 500);
    for (const vtkContourRepresentationPoint* point : this->Traced.Contour->GetNthNode(0)->Points)
    {
      const double* p = point->WorldPosition;
      heights.push_back(std::hypot(p[0], p[1], p[2]) - 1.0);
    }
    EXPECT_GT(heights.size(), 5u);
    return heights;
  };
  // Normals of the faces round a point.
  for (double height : heights())
  {
    EXPECT_NEAR(height, 0.25, 1e-3);
  }
  // Normals of the surface, of length 3.
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double* p = sphere->GetPoint(i);
    normals->InsertNextTuple3(3.0 * p[0], 3.0 * p[1], 3.0 * p[2]);
  }
  sphere->GetPointData()->SetNormals(normals);
  for (double height : heights())
  {
    EXPECT_NEAR(height, 0.25, 1e-12);
  }
  // Edges of the mesh are up to 0.3 long, so their middles 0.3^2 / 8 below the sphere.
  this->useMethod(FastMarching, 1);
  for (double height : heights())
  {
    EXPECT_GT(height, 0.25 - 0.0113);
    EXPECT_LT(height, 0.25 + 1e-12);
  }
}

TEST_F(Interpolator, TracesTheTwoLinesBesideAMovedNode)
{
  using Lines = std::vector<NotingInterpolator::Line>;
  const auto surface = square(20);
  this->Traced.addSurface(surface);
  for (vtkIdType id : { 0, 20, 220, 440, 420 })
  {
    this->Traced.addNode(surface, id);
  }
  this->Traced.Interpolator->takeLines();
  this->Traced.moveNode(2, surface, 221);
  EXPECT_EQ(this->Traced.Interpolator->takeLines(), (Lines{ { 1, 2 }, { 2, 3 } }));
  this->Traced.moveNode(0, surface, 1);
  EXPECT_EQ(this->Traced.Interpolator->takeLines(), (Lines{ { 0, 1 } }));
  this->Traced.moveNode(4, surface, 421);
  EXPECT_EQ(this->Traced.Interpolator->takeLines(), (Lines{ { 3, 4 } }));
  this->Traced.Contour->ClosedLoopOn();
  EXPECT_EQ(this->Traced.Interpolator->takeLines(), (Lines{ { 3, 4 }, { 4, 0 } }));
  this->Traced.moveNode(0, surface, 0);
  EXPECT_EQ(this->Traced.Interpolator->takeLines(), (Lines{ { 4, 0 }, { 0, 1 } }));
}

// Coordinates that change without Modified() are not seen, so nothing was built again; those that
// change with it are.
TEST_F(Interpolator, BuildsASurfaceOnce)
{
  const auto surface = square(20);
  this->Traced.addSurface(surface);
  this->useMethod(FastMarching, 1);
  EXPECT_NEAR(this->lengthOf(surface, 0, 20), 20.0, 1e-12);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    surface->GetPoints()->SetPoint(i, p[0], 2.0 * p[1], 1.0);
  }
  EXPECT_NEAR(this->lengthOf(surface, 0, 420), 20.0, 1e-12);
  surface->GetPoints()->Modified();
  EXPECT_NEAR(this->lengthOf(surface, 0, 420), 40.0, 1e-12);
}

TEST_F(Interpolator, DrawsOnSeveralSurfaces)
{
  const auto left = square(10);
  const auto right = square(4);
  this->Traced.addSurface(left);
  this->Traced.addSurface(right);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(this->lengthOf(left, 0, 10), 10.0, 1e-12);
    EXPECT_NEAR(this->lengthOf(right, 20, 24), 4.0, 1e-12);
  }
  this->traceLine(left, 120, 0);
  this->Traced.moveNode(1, right, 2);
  this->expectNoLine();
  EXPECT_EQ(this->Traced.contourIds(), (std::vector<vtkIdType>{ 120, 2 }));
}

// The placer keeps one record for all places within 0.022, on the Bunny an ear's width, and forgets
// those before.
TEST_F(Interpolator, KnowsNodesThatThePlacerForgot)
{
  const auto surface = readData("Bunny.vtp");
  this->Traced.addSurface(surface);
  std::vector<vtkIdType> nodes{ 0 };
  for (vtkIdType id = 0; nodes.size() < 6; ++id)
  {
    const double step = distanceBetween(surface, nodes.back(), id);
    if (step > 0.01 && step < 0.02 && surface->GetPoint(id)[0] > surface->GetPoint(nodes.back())[0])
    {
      nodes.push_back(id);
    }
  }
  const auto expectLines = [&]
  {
    ASSERT_EQ(this->Traced.Contour->GetNumberOfNodes(), 6);
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const auto line = this->Traced.lineIds(static_cast<int>(i));
      ASSERT_GE(line.size(), 2u);
      EXPECT_EQ(line.front(), nodes[i]);
      EXPECT_EQ(line.back(), nodes[(i + 1) % nodes.size()]);
      EXPECT_EQ(this->Traced.Contour->GetNthNode(static_cast<int>(i))->PointId, nodes[i]);
    }
  };
  for (vtkIdType id : nodes)
  {
    this->Traced.addNode(surface, id);
  }
  this->Traced.Contour->ClosedLoopOn();
  expectLines();
  double first[3];
  surface->GetPoint(nodes[0], first);
  EXPECT_EQ(this->Traced.Placer->GetNodeAtWorldPosition(first), nullptr);
  // All lines again.
  this->Traced.Placer->Modified();
  this->Traced.Contour->BuildRepresentation();
  expectLines();

  // All nodes at once.
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> loop;
  for (vtkIdType id : nodes)
  {
    loop->InsertNextId(points->InsertNextPoint(surface->GetPoint(id)));
    ids->InsertNextId(id);
  }
  loop->InsertNextId(0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(loop);
  vtkNew<vtkPolyData> contour;
  contour->SetPoints(points);
  contour->SetLines(lines);
  TracedContour other;
  other.addSurface(surface);
  other.Widget->Initialize(contour, 1, ids);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    EXPECT_EQ(other.lineIds(static_cast<int>(i)).front(), nodes[i]);
  }
}

TEST_F(Interpolator, ListsEachNodeAndThePointsAfterIt)
{
  const auto surface = square(4);
  this->Traced.addSurface(surface);
  using Ids = std::vector<vtkIdType>;
  EXPECT_EQ(this->Traced.contourIds(), Ids{});
  this->Traced.addNode(surface, 0);
  EXPECT_EQ(this->Traced.contourIds(), Ids{ 0 });
  this->Traced.addNode(surface, 2);
  EXPECT_EQ(this->Traced.contourIds(), (Ids{ 0, 0, 1, 2, 2 }));
  this->Traced.addNode(surface, 2);
  EXPECT_EQ(this->Traced.contourIds(), (Ids{ 0, 0, 1, 2, 2, 2, 2 }));
}

TEST_F(Interpolator, DrawsNoLineBetweenPartsThatAreNotConnected)
{
  Surface far = planeGrid(4, 4, 4.0, 4.0);
  for (Vector3& p : far.points)
  {
    p.x += 10.0;
  }
  const auto surface = polyDataOf(joined(planeGrid(4, 4, 4.0, 4.0), far));
  this->Traced.addSurface(surface);
  for (int method : { Dijkstra, FastMarching })
  {
    for (int order : { 0, 1 })
    {
      this->useMethod(method, order);
      this->traceLine(surface, 0, 49);
      this->expectNoLine();
      EXPECT_NEAR(this->lengthOf(surface, 0, 4), 4.0, 1e-12);
    }
  }
}

TEST_F(Interpolator, DrawsNoLineToANodeThatThePlacerDoesNotKnow)
{
  const auto surface = square(4);
  this->Traced.addSurface(surface);
  this->Traced.addNode(surface, 0);
  this->Traced.Contour->AddNodeAtWorldPosition(2.0, 2.0, 0.0);
  this->expectNoLine();
  EXPECT_EQ(this->Traced.contourIds(), (std::vector<vtkIdType>{ 0, -1 }));
  // Ids that are no points.
  for (vtkIdType id : { -1, 25, 1000000 })
  {
    this->Traced.clear();
    this->Traced.addNode(surface, 0);
    double position[3] = { 4.0, 4.0, 0.0 };
    this->Traced.Placer->UpdateNodeWorldPosition(position, id);
    this->Traced.Contour->AddNodeAtWorldPosition(position);
    this->expectNoLine();
  }
}

TEST_F(Interpolator, DrawsNoLineOnASurfaceThatIsNotListed)
{
  const auto surface = square(4);
  const auto other = square(8);
  this->Traced.addSurface(surface);
  this->traceLine(other, 0, 8);
  this->expectNoLine();
  // Without a list there is none that does not count.
  this->Traced.Interpolator->GetPolys()->RemoveAllItems();
  EXPECT_NEAR(this->lengthOf(other, 0, 8), 8.0, 1e-12);
}

TEST_F(Interpolator, DrawsNoLineWithoutItsPlacer)
{
  const auto surface = square(4);
  this->Traced.addSurface(surface);
  vtkNew<vtkFocalPlanePointPlacer> placer;
  this->Traced.Contour->SetPointPlacer(placer);
  this->Traced.Contour->AddNodeAtWorldPosition(0.0, 0.0, 0.0);
  this->Traced.Contour->AddNodeAtWorldPosition(1.0, 0.0, 0.0);
  this->expectNoLine();
  EXPECT_EQ(this->Traced.contourIds(), (std::vector<vtkIdType>{ -1, -1 }));
  EXPECT_EQ(this->Traced.Interpolator->InterpolateLine(nullptr, this->Traced.Contour, 0, 7), 0);
  EXPECT_EQ(this->Traced.Interpolator->InterpolateLine(nullptr, this->Traced.Contour, -1, 0), 0);
}

TEST_F(Interpolator, SaysWhatItIsNotGiven)
{
  vtkPolygonalSurfaceContourLineInterpolator2* interpolator = this->Traced.Interpolator;
  auto observer = vtkSmartPointer<vtkTest::ErrorObserver>::New();
  interpolator->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto expectSaid = [&](const std::string& words)
  {
    EXPECT_NE(observer->GetErrorMessage().find(words), std::string::npos) << words;
    observer->Clear();
  };
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIntArray> span;
  EXPECT_EQ(interpolator->InterpolateLine(nullptr, nullptr, 0, 1), 0);
  expectSaid("no contour representation");
  interpolator->GetSpan(0, span, nullptr);
  expectSaid("GetSpan needs a contour representation");
  interpolator->GetSpan(0, nullptr, this->Traced.Contour);
  expectSaid("an array to fill");
  interpolator->GetContourPointIds(nullptr, ids);
  expectSaid("GetContourPointIds needs a contour representation");
  interpolator->GetContourPointIds(this->Traced.Contour, nullptr);
  expectSaid("a list to fill");
}

TEST_F(Interpolator, SaysWhereASurfaceHasNoFaces)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  this->Traced.addSurface(surface);
  auto observer = vtkSmartPointer<vtkTest::ErrorObserver>::New();
  this->Traced.Interpolator->AddObserver(vtkCommand::ErrorEvent, observer);
  this->traceLine(surface, 0, 1);
  this->expectNoLine();
  EXPECT_NE(
    observer->GetErrorMessage().find("The input has no surface: 2 points"), std::string::npos);
}
