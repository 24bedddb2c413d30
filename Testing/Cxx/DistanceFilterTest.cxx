// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkFastMarchingGeodesicDistance: what each option does, on a square where the truth is a straight
// line.

#include "Inputs.h"

#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

using namespace geodesic::testing;

namespace
{

constexpr int SideOfSquare = 12;
constexpr vtkIdType Middle = 6 * (SideOfSquare + 1) + 6;

class DistanceFilter : public ::testing::Test
{
protected:
  DistanceFilter()
  {
    this->Filter->SetInputData(this->Input);
    this->Filter->SetSeeds(idList({ Middle }));
    this->Filter->SetFieldDataName("d");
  }

  vtkDataArray* run()
  {
    EXPECT_EQ(errorsOf(this->Filter.Get()), "");
    return this->Filter->GetOutput()->GetPointData()->GetArray("d");
  }

  double truth(vtkIdType point) { return distanceBetween(this->Input, point, Middle); }

  const vtkSmartPointer<vtkPolyData> Input = square(SideOfSquare);
  vtkNew<vtkFastMarchingGeodesicDistance> Filter;
};

}

TEST_F(DistanceFilter, GivesTheDistanceAtEveryPoint)
{
  vtkDataArray* d = this->run();
  ASSERT_NE(d, nullptr);
  EXPECT_EQ(d->GetNumberOfTuples(), this->Input->GetNumberOfPoints());
  EXPECT_EQ(d->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < d->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(d->GetComponent(i, 0), this->truth(i), 1e-9);
  }
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 6.0 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), this->Input->GetNumberOfPoints());
}

TEST_F(DistanceFilter, PassesTheInputThrough)
{
  vtkNew<vtkDoubleArray> other;
  other->SetName("other");
  other->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  this->Input->GetPointData()->SetScalars(other);
  this->run();
  vtkPolyData* output = this->Filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), this->Input->GetPoints());
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "other");
  EXPECT_EQ(this->Input->GetPointData()->GetNumberOfArrays(), 1);
}

TEST_F(DistanceFilter, BecomesTheScalarsWhereThereAreNone)
{
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetScalars(), nullptr);
  this->run();
  EXPECT_STREQ(this->Filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "d");
}

TEST_F(DistanceFilter, AnInputArrayOfTheSameNameIsNotWritten)
{
  vtkNew<vtkDoubleArray> same;
  same->SetName("d");
  same->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  same->Fill(-7.0);
  this->Input->GetPointData()->AddArray(same);
  EXPECT_NEAR(this->run()->GetComponent(0, 0), this->truth(0), 1e-9);
  EXPECT_EQ(same->GetRange()[0], -7.0);
  EXPECT_EQ(same->GetRange()[1], -7.0);
  EXPECT_EQ(this->Input->GetPointData()->GetArray("d"), same.Get());
}

TEST_F(DistanceFilter, WithoutANameMakesNoArray)
{
  this->Filter->SetFieldDataName(nullptr);
  EXPECT_EQ(errorsOf(this->Filter.Get()), "");
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), this->Input->GetNumberOfPoints());
}

TEST_F(DistanceFilter, DistanceStopIsSharp)
{
  this->Filter->SetDistanceStopCriterion(3.5);
  vtkDataArray* d = this->run();
  vtkIdType visited = 0;
  for (vtkIdType i = 0; i < d->GetNumberOfTuples(); ++i)
  {
    const bool isNear = this->truth(i) <= 3.5;
    EXPECT_NEAR(d->GetComponent(i, 0), isNear ? this->truth(i) : -1.0, 1e-9);
    visited += isNear;
  }
  EXPECT_EQ(this->Filter->GetNumberOfVisitedPoints(), visited);
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), std::sqrt(10.0), 1e-9);
}

TEST_F(DistanceFilter, NotVisitedValueMarksTheRest)
{
  this->Filter->SetDistanceStopCriterion(1.0);
  this->Filter->SetNotVisitedValue(1e30);
  EXPECT_EQ(this->run()->GetComponent(0, 0), 1e30);
}

TEST_F(DistanceFilter, DestinationStopsAtAnyOrAll)
{
  this->Filter->SetDestinationVertexStopCriterion(idList({ Middle + 2, Middle + 4 }));
  EXPECT_NEAR(this->run()->GetComponent(Middle + 2, 0), 2.0, 1e-9);
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 2.0, 1e-9);
  this->Filter->SetDestinationStopModeToAll();
  this->run();
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 4.0, 1e-9);
}

TEST_F(DistanceFilter, StopsCombine)
{
  this->Filter->SetDestinationVertexStopCriterion(idList({ Middle + 4 }));
  this->Filter->SetDistanceStopCriterion(2.0);
  this->run();
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 2.0, 1e-9);
  this->Filter->SetDistanceStopCriterion(5.0);
  this->run();
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 4.0, 1e-9);
}

TEST_F(DistanceFilter, ExcludedPointsConfineTheFront)
{
  auto column = vtkSmartPointer<vtkIdList>::New();
  for (int j = 0; j <= SideOfSquare; ++j)
  {
    column->InsertNextId(j * (SideOfSquare + 1) + 8);
  }
  this->Filter->SetExclusionPointIds(column);
  vtkDataArray* d = this->run();
  for (vtkIdType i = 0; i < d->GetNumberOfTuples(); ++i)
  {
    const bool isReached = i % (SideOfSquare + 1) < 8;
    EXPECT_NEAR(d->GetComponent(i, 0), isReached ? this->truth(i) : -1.0, 1e-9);
  }
}

TEST_F(DistanceFilter, EditingAListInPlaceRunsAgain)
{
  const auto seeds = idList({ 0 });
  this->Filter->SetSeeds(seeds);
  EXPECT_EQ(this->run()->GetComponent(0, 0), 0.0);
  seeds->SetId(0, 5);
  EXPECT_NEAR(this->run()->GetComponent(0, 0), 5.0, 1e-9);

  const auto excluded = idList({ 20 });
  this->Filter->SetExclusionPointIds(excluded);
  EXPECT_EQ(this->run()->GetComponent(20, 0), -1.0);
  excluded->SetId(0, 30);
  EXPECT_EQ(this->run()->GetComponent(30, 0), -1.0);

  const auto destinations = idList({ 6 });
  this->Filter->SetDestinationVertexStopCriterion(destinations);
  this->run();
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 1.0, 1e-9);
  destinations->SetId(0, 7);
  this->run();
  EXPECT_NEAR(this->Filter->GetMaximumDistance(), 2.0, 1e-9);
}

TEST_F(DistanceFilter, SeveralSeedsGiveTheNearest)
{
  this->Filter->SetSeeds(idList({ 0, Middle, 12 }));
  this->Filter->SetNearestSeedArrayName("seed");
  vtkDataArray* d = this->run();
  vtkDataArray* seed = this->Filter->GetOutput()->GetPointData()->GetArray("seed");
  const vtkIdType ids[3] = { 0, Middle, 12 };
  for (vtkIdType i = 0; i < d->GetNumberOfTuples(); ++i)
  {
    int nearest = 0;
    for (int s = 1; s < 3; ++s)
    {
      const bool isNearer = distanceBetween(this->Input, i, ids[s]) <
        distanceBetween(this->Input, i, ids[nearest]) - 1e-9;
      nearest = isNearer ? s : nearest;
    }
    EXPECT_NEAR(d->GetComponent(i, 0), distanceBetween(this->Input, i, ids[nearest]), 1e-9);
    EXPECT_EQ(seed->GetComponent(i, 0), nearest);
  }
}

TEST_F(DistanceFilter, MovingAPointOfTheInputRunsOnTheNewSurface)
{
  this->run();
  this->Input->GetPoints()->SetPoint(0, -3.0, 0.0, 0.0);
  this->Input->GetPoints()->Modified();
  this->Input->Modified();
  // The straight line leaves the surface: the shortest path turns at the point (0, 1).
  const double truth = std::hypot(3.0, 1.0) + std::hypot(6.0, 5.0);
  EXPECT_NEAR(this->run()->GetComponent(0, 0), truth, 1e-9);
}

TEST_F(DistanceFilter, FloatPointsServeAsWell)
{
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(this->Input->GetPoints());
  ASSERT_EQ(floats->GetDataType(), VTK_FLOAT);
  this->Input->SetPoints(floats);
  EXPECT_NEAR(this->run()->GetComponent(0, 0), this->truth(0), 1e-9);
}
