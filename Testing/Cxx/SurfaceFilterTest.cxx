// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceGeodesicDistance: positions, coincident points, methods, marks of what is not reached.

#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

using namespace geodesic::testing;

namespace
{

/** A surface whose triangles share no points, as an STL file gives it. */
vtkSmartPointer<vtkPolyData> soupOf(vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> faces;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    surface->GetCellPoints(cell, corners);
    faces->InsertNextCell(static_cast<int>(corners->GetNumberOfIds()));
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      faces->InsertCellPoint(points->InsertNextPoint(surface->GetPoint(corners->GetId(i))));
    }
  }
  auto soup = vtkSmartPointer<vtkPolyData>::New();
  soup->SetPoints(points);
  soup->SetPolys(faces);
  return soup;
}

/** A surface of its own, of which nothing is known yet. */
vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  return copy;
}

class SurfaceFilter : public ::testing::Test
{
protected:
  vtkDataArray* run(vtkPolyData* input)
  {
    this->Filter->SetInputDataObject(input);
    EXPECT_EQ(errorsOf(this->Filter.Get()), "");
    auto* output = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0));
    return output->GetPointData()->GetArray("GeodesicDistance");
  }

  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

TEST_F(SurfaceFilter, PositionsAreProjectedOntoFaces)
{
  const auto surface = square(5);
  this->Filter->AddSeedPosition(2.3, 1.6, 7.0);
  vtkDataArray* d = this->run(surface);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    EXPECT_NEAR(d->GetComponent(i, 0), std::hypot(p[0] - 2.3, p[1] - 1.6), 1e-9);
  }
}

TEST_F(SurfaceFilter, ItsArrayAlwaysBecomesTheScalars)
{
  const auto surface = square(5);
  const auto other = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_FLOAT));
  other->SetName("other");
  other->SetNumberOfTuples(surface->GetNumberOfPoints());
  surface->GetPointData()->SetScalars(other);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->run(surface);
  auto* output = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "GeodesicDistance");
}

TEST_F(SurfaceFilter, ASoupOfTrianglesIsTheSurface)
{
  const auto surface = square(7);
  const auto soup = soupOf(surface);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  vtkDataArray* d = this->run(soup);
  ASSERT_EQ(d->GetNumberOfTuples(), soup->GetNumberOfPoints());
  for (vtkIdType i = 0; i < soup->GetNumberOfPoints(); ++i)
  {
    double p[3];
    soup->GetPoint(i, p);
    EXPECT_NEAR(d->GetComponent(i, 0), std::hypot(p[0], p[1]), 1e-9);
  }
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), soup->GetNumberOfPoints());
}

TEST_F(SurfaceFilter, WithoutMergingASlitStaysASlit)
{
  const auto soup = soupOf(square(7));
  this->Filter->AddSeedPosition(0.2, 0.1, 0.0);
  this->Filter->MergeCoincidentPointsOff();
  this->run(soup);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 3);
}

// The article's class never merges: its points are what their ids say.
TEST_F(SurfaceFilter, TheArticleClassNeverMerges)
{
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  filter->SetInputData(soupOf(square(7)));
  filter->SetSeeds(idList({ 0 }));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfVisitedPoints(), 3);
}

TEST_F(SurfaceFilter, UnreachedPointsAreNaNOrAValue)
{
  const auto surface = square(3);
  const vtkIdType bare = surface->GetPoints()->InsertNextPoint(9.0, 9.0, 0.0);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  EXPECT_TRUE(std::isnan(this->run(surface)->GetComponent(bare, 0)));
  EXPECT_NEAR(this->run(surface)->GetFiniteRange()[1], 3.0 * std::sqrt(2.0), 1e-9);
  this->Filter->SetUnreachedAs(vtkSurfaceGeodesicDistance::UNREACHED_AS_VALUE);
  EXPECT_EQ(this->run(surface)->GetComponent(bare, 0), -1.0);
  this->Filter->SetUnreachedValue(99.0);
  EXPECT_EQ(this->run(surface)->GetComponent(bare, 0), 99.0);
}

TEST_F(SurfaceFilter, MaximumDistanceIsSharpAndCanBeZero)
{
  const auto surface = square(9);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->UseMaximumDistanceOn();
  this->Filter->SetMaximumDistance(2.0);
  this->run(surface);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 6);
  EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), 2.0, 1e-9);
  this->Filter->SetMaximumDistance(0.0);
  this->run(surface);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 1);
}

// The filter keeps its solver: nothing of the field of the former seeds may stay.
TEST_F(SurfaceFilter, MovedAndRemovedSeedsStartANewField)
{
  const auto bunny = readData("Bunny.vtp");
  const auto give = [](vtkSurfaceGeodesicDistance* filter, const std::vector<vtkIdType>& positions,
                      const std::vector<vtkIdType>& ids, vtkPolyData* surface)
  {
    filter->ClearSeedPositions();
    filter->ClearSeedPointIds();
    for (vtkIdType point : positions)
    {
      double p[3];
      surface->GetPoint(point, p);
      filter->AddSeedPosition(p[0] + 1e-4, p[1], p[2]);
    }
    for (vtkIdType id : ids)
    {
      filter->AddSeedPointId(id);
    }
  };
  struct Seeds
  {
    std::vector<vtkIdType> positions;
    std::vector<vtkIdType> ids;
  };
  // Both; one moved a little; one moved far and to a point; removed down to one; one more again.
  const std::vector<Seeds> edits{ { { 17, 20000 }, {} }, { { 18, 20000 }, {} },
    { { 18 }, { 30000 } }, { { 18 }, {} }, { {}, { 4000 } }, { { 17 }, { 4000, 9000 } } };
  for (int method :
    { vtkSurfaceGeodesicDistance::FAST_MARCHING, vtkSurfaceGeodesicDistance::DIJKSTRA })
  {
    this->Filter->SetMethod(method);
    for (const Seeds& seeds : edits)
    {
      give(this->Filter, seeds.positions, seeds.ids, bunny);
      vtkDataArray* warm = this->run(bunny);
      vtkNew<vtkSurfaceGeodesicDistance> cold;
      cold->SetMethod(method);
      give(cold, seeds.positions, seeds.ids, bunny);
      cold->SetInputDataObject(copyOf(bunny));
      ASSERT_EQ(errorsOf(cold.Get()), "");
      auto* output = vtkPolyData::SafeDownCast(cold->GetOutputDataObject(0));
      vtkDataArray* expected = output->GetPointData()->GetArray("GeodesicDistance");
      for (vtkIdType i = 0; i < bunny->GetNumberOfPoints(); ++i)
      {
        const double value = expected->GetComponent(i, 0);
        if (std::isnan(value))
        {
          ASSERT_TRUE(std::isnan(warm->GetComponent(i, 0)));
        }
        else
        {
          ASSERT_EQ(warm->GetComponent(i, 0), value);
        }
      }
    }
  }
}

// Readers and programs make polylines without points where a line has nothing to show.
TEST_F(SurfaceFilter, LinesWithoutPointsAreNone)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 5.0, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(0);
  cells->InsertNextCell({ 0, 1 });
  cells->InsertNextCell(0);
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(points);
  lines->SetLines(cells);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(lines);
  const auto surface = square(5);

  this->Filter->SetSeedSourceConnection(producer->GetOutputPort());
  this->run(surface);
  EXPECT_NEAR(this->Filter->GetMaximumDistanceReached(), 5.0, 1e-9);

  // As a barrier the line takes the six points on it.
  this->Filter->SetSeedSourceConnection(nullptr);
  this->Filter->SetBarrierSourceConnection(producer->GetOutputPort());
  this->Filter->AddSeedPosition(5.0, 0.0, 0.0);
  this->run(surface);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 30);
}

TEST_F(SurfaceFilter, DijkstraFollowsEdges)
{
  const auto surface = square(6);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->SetMethod(vtkSurfaceGeodesicDistance::DIJKSTRA);
  vtkDataArray* d = this->run(surface);
  EXPECT_NEAR(d->GetComponent(48, 0), 6.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(d->GetComponent(2 * 7 + 1, 0), 1.0 + std::sqrt(2.0), 1e-12);
  this->Filter->SetMethod(vtkSurfaceGeodesicDistance::FAST_MARCHING);
  EXPECT_NEAR(this->run(surface)->GetComponent(2 * 7 + 1, 0), std::sqrt(5.0), 1e-12);
}

TEST_F(SurfaceFilter, VirtualSourcesGoAcrossFacesAndTakeNoCosts)
{
  const auto surface = square(6);
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->SetMethod(vtkSurfaceGeodesicDistance::VIRTUAL_SOURCES);
  EXPECT_NEAR(this->run(surface)->GetComponent(2 * 7 + 1, 0), std::sqrt(5.0), 1e-12);
  vtkNew<vtkDoubleArray> cost;
  cost->SetName("cost");
  cost->SetNumberOfTuples(surface->GetNumberOfPoints());
  cost->Fill(2.0);
  surface->GetPointData()->AddArray(cost);
  this->Filter->SetInputArrayToProcess(
    vtkSurfaceGeodesicDistance::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "cost");
  this->Filter->SetInputDataObject(surface);
  const std::string error = errorsOf(this->Filter.Get());
  EXPECT_NE(error.find("VirtualSources can't work with costs; these can: FastMarching, Dijkstra."),
    std::string::npos)
    << error;
}

TEST_F(SurfaceFilter, BoundedKeepsToItsTolerance)
{
  const auto spot = readData("Spot.vtp");
  this->Filter->AddSeedPointId(17);
  this->Filter->SetMethod(vtkSurfaceGeodesicDistance::EXACT);
  vtkNew<vtkDoubleArray> exact;
  exact->DeepCopy(this->run(spot));
  this->Filter->SetMethod(vtkSurfaceGeodesicDistance::BOUNDED);
  for (const double tolerance : { 1e-1, 1e-3 })
  {
    this->Filter->SetTolerance(tolerance);
    vtkDataArray* bounded = this->run(spot);
    for (vtkIdType i = 0; i < spot->GetNumberOfPoints(); ++i)
    {
      const double d = exact->GetComponent(i, 0);
      ASSERT_GE(bounded->GetComponent(i, 0), d * (1.0 - 1e-9));
      ASSERT_LE(bounded->GetComponent(i, 0), d * (1.0 + tolerance) * (1.0 + 1e-9));
    }
  }
  this->Filter->SetTolerance(0.0);
  this->Filter->SetInputDataObject(spot);
  const std::string error = errorsOf(this->Filter.Get());
  EXPECT_NE(error.find("Tolerance is 0; give a number above 0"), std::string::npos) << error;
}

// The reference solver is for tests: number 100 of the table of solvers, which XML does not offer.
TEST_F(SurfaceFilter, TheReferenceSolverGivesTheSameField)
{
  const auto bunny = readData("Bunny.vtp");
  this->Filter->AddSeedPointId(17);
  this->Filter->AddSeedPointId(20000);
  vtkNew<vtkDoubleArray> batched;
  batched->DeepCopy(this->run(bunny));
  this->Filter->SetMethod(100);
  vtkDataArray* reference = this->run(bunny);
  const double largest = this->Filter->GetMaximumDistanceReached();
  for (vtkIdType i = 0; i < bunny->GetNumberOfPoints(); ++i)
  {
    const double expected = batched->GetComponent(i, 0);
    ASSERT_EQ(std::isnan(reference->GetComponent(i, 0)), std::isnan(expected));
    ASSERT_TRUE(
      std::isnan(expected) || std::abs(reference->GetComponent(i, 0) - expected) < 1e-7 * largest);
  }
}

TEST_F(SurfaceFilter, AMethodThatDoesNotExistIsAnErrorThatNamesThoseThatDo)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->SetMethod(7);
  this->Filter->SetInputDataObject(square(3));
  const std::string error = errorsOf(this->Filter.Get());
  EXPECT_NE(error.find("no method 7"), std::string::npos) << error;
  EXPECT_NE(error.find("0 (FastMarching), 1 (Dijkstra)"), std::string::npos) << error;
  this->Filter->SetMethod(vtkSurfaceGeodesicDistance::DIJKSTRA);
  EXPECT_NE(this->run(square(3)), nullptr);
}

TEST_F(SurfaceFilter, AnEmptyNameMakesNoArray)
{
  this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
  this->Filter->SetDistanceArrayName("");
  EXPECT_EQ(this->run(square(3)), nullptr);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), 16);
}

TEST_F(SurfaceFilter, TheSphereIsRight)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetThetaResolution(128);
  sphere->SetPhiResolution(128);
  sphere->Update();
  this->Filter->AddSeedPosition(0.0, 0.0, 0.5);
  vtkDataArray* d = this->run(sphere->GetOutput());
  for (vtkIdType i = 0; i < d->GetNumberOfTuples(); ++i)
  {
    double p[3];
    sphere->GetOutput()->GetPoint(i, p);
    EXPECT_NEAR(d->GetComponent(i, 0), 0.5 * std::atan2(std::hypot(p[0], p[1]), p[2]), 0.01);
  }
}
