// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceGeodesicIsolines: its output, blocks, marks of no distance and refused requests.

#include "Inputs.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkSurfaceGeodesicIsolines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace geodesic::testing;

namespace
{

constexpr double Pi = std::numbers::pi;

class IsolinesFilter : public ::testing::Test
{
protected:
  void setInput(vtkDataObject* surface)
  {
    this->Distance->SetInputDataObject(surface);
    this->Isolines->SetInputConnection(this->Distance->GetOutputPort());
  }
  vtkPolyData* run()
  {
    EXPECT_EQ(errorsOf(this->Isolines.Get()), "");
    return vtkPolyData::SafeDownCast(this->Isolines->GetOutputDataObject(0));
  }
  double valueOf(const char* name, vtkIdType cell)
  {
    auto* output = vtkPolyData::SafeDownCast(this->Isolines->GetOutputDataObject(0));
    return output->GetCellData()->GetArray(name)->GetComponent(cell, 0);
  }
  void expectError(const std::string& part)
  {
    const std::string found = errorsOf(this->Isolines.Get());
    EXPECT_NE(found.find(part), std::string::npos) << found;
    EXPECT_EQ(
      vtkPolyData::SafeDownCast(this->Isolines->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  }
  void expectCircle(vtkIdType cell, double radius)
  {
    EXPECT_NEAR(this->valueOf("GeodesicDistance", cell), radius, 1e-12);
    EXPECT_NEAR(this->valueOf("Length", cell), 2.0 * Pi * radius, 1e-9);
    EXPECT_NEAR(this->valueOf("EnclosedArea", cell), Pi * radius * radius, 1e-9);
  }

  vtkNew<vtkSurfaceGeodesicDistance> Distance;
  vtkNew<vtkSurfaceGeodesicIsolines> Isolines;
};

}

TEST_F(IsolinesFilter, OnAPlaneAreClosedCirclesInTheOrderOfTheirDistances)
{
  this->setInput(square(20));
  this->Distance->AddSeedPosition(10.3, 9.7, 0.0);
  // The second is in the seed's face, and the last is beyond the largest distance.
  for (const double value : { 7.5, 0.1, 4.0, 7.5, 100.0 })
  {
    this->Isolines->AddValue(value);
  }
  vtkPolyData* output = this->run();
  ASSERT_EQ(output->GetNumberOfCells(), 3);
  this->expectCircle(0, 0.1);
  this->expectCircle(1, 4.0);
  this->expectCircle(2, 7.5);
  for (vtkIdType cell = 0; cell < 3; ++cell)
  {
    vtkIdList* points = output->GetCell(cell)->GetPointIds();
    EXPECT_EQ(points->GetId(0), points->GetId(points->GetNumberOfIds() - 1));
    for (const vtkIdType id : *points)
    {
      double p[3];
      output->GetPoint(id, p);
      EXPECT_NEAR(
        std::hypot(p[0] - 10.3, p[1] - 9.7), this->valueOf("GeodesicDistance", cell), 1e-9);
    }
  }
}

TEST_F(IsolinesFilter, WithoutValuesTheRangeIsPartedEvenly)
{
  this->setInput(square(20));
  this->Distance->AddSeedPosition(0.0, 0.0, 0.0);
  this->Isolines->SetNumberOfValues(3);
  vtkPolyData* output = this->run();
  ASSERT_EQ(output->GetNumberOfCells(), 3);
  for (vtkIdType cell = 0; cell < 3; ++cell)
  {
    EXPECT_NEAR(
      this->valueOf("GeodesicDistance", cell), (cell + 1) * 20.0 * std::sqrt(2.0) / 4.0, 1e-9);
  }
  EXPECT_NEAR(this->valueOf("Length", 0), 0.5 * Pi * 20.0 * std::sqrt(2.0) / 4.0, 1e-9);
}

TEST_F(IsolinesFilter, BlocksThatShareTheirPointsAreOneSurface)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, square(20));
  const auto right = square(20);
  for (vtkIdType i = 0; i < right->GetNumberOfPoints(); ++i)
  {
    double p[3];
    right->GetPoint(i, p);
    right->GetPoints()->SetPoint(i, p[0] + 20.0, p[1], p[2]);
  }
  blocks->SetBlock(1, right);
  this->setInput(blocks);
  this->Distance->AddSeedPosition(20.2, 10.1, 0.0);
  this->Isolines->AddValue(6.3);
  EXPECT_EQ(this->run()->GetNumberOfCells(), 1);
  this->expectCircle(0, 6.3);
  this->Isolines->ConnectBlocksOff();
  EXPECT_EQ(this->run()->GetNumberOfCells(), 2);
}

TEST_F(IsolinesFilter, CurvesEndAtPointsWithoutADistance)
{
  this->setInput(square(20));
  this->Distance->AddSeedPosition(0.0, 0.0, 0.0);
  this->Distance->UseMaximumDistanceOn();
  this->Distance->SetMaximumDistance(8.0);
  for (const double value : { 5.0, 7.9 })
  {
    this->Isolines->AddValue(value);
  }
  this->run();
  const double length = this->valueOf("Length", 0);
  EXPECT_NEAR(length, 0.5 * Pi * 5.0, 1e-9);
  const vtkIdType cells = this->run()->GetNumberOfCells();
  this->Distance->SetUnreachedAs(vtkSurfaceGeodesicDistance::UNREACHED_AS_VALUE);
  EXPECT_EQ(this->run()->GetNumberOfCells(), cells);
  EXPECT_EQ(this->valueOf("Length", 0), length);
}

// The filter finds the cost by the note on the distances, as cost and as speed; a cost array that
// is chosen counts instead.
TEST_F(IsolinesFilter, UnderCostsTheCurvesAreThoseOfTheCost)
{
  const auto surface = square(20);
  vtkNew<vtkDoubleArray> cost;
  cost->SetName("Cost");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    cost->InsertNextValue(0.2);
  }
  surface->GetPointData()->AddArray(cost);
  this->setInput(surface);
  this->Distance->AddSeedPosition(10.3, 9.7, 0.0);
  this->Distance->SetInputArrayToProcess(
    vtkSurfaceGeodesicFilter::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Cost");
  const auto expectCircleAt = [&](double w)
  {
    this->Isolines->ClearValues();
    this->Isolines->AddValue(6.0 * w);
    this->Isolines->AddValue(0.1 * w);
    ASSERT_EQ(this->run()->GetNumberOfCells(), 2);
    EXPECT_NEAR(this->valueOf("Length", 0), 2.0 * Pi * 0.1, 1e-9);
    EXPECT_NEAR(this->valueOf("EnclosedArea", 1), Pi * 36.0, 1e-9);
  };
  expectCircleAt(0.2);
  this->Distance->SetCostMode(vtkSurfaceGeodesicFilter::SPEED);
  expectCircleAt(5.0);

  // Of other origin, without a note.
  this->Distance->Update();
  vtkNew<vtkPolyData> distances;
  distances->DeepCopy(this->Distance->GetOutputDataObject(0));
  distances->GetPointData()->GetArray("GeodesicDistance")->GetInformation()->Clear();
  this->Isolines->SetInputDataObject(distances);
  this->Isolines->SetInputArrayToProcess(
    vtkSurfaceGeodesicIsolines::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Cost");
  this->Isolines->SetCostMode(vtkSurfaceGeodesicIsolines::SPEED);
  expectCircleAt(5.0);
  this->Isolines->SetInputArrayToProcess(
    vtkSurfaceGeodesicIsolines::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Cost");
  this->expectError("CostArray \"Cost\" is not a cell array");
}

TEST_F(IsolinesFilter, ACostArrayThatIsNotPassedOnIsNamed)
{
  const auto surface = square(5);
  vtkNew<vtkDoubleArray> cost;
  cost->SetName("Cost");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    cost->InsertNextValue(2.0 + i);
  }
  surface->GetPointData()->AddArray(cost);
  this->setInput(surface);
  this->Distance->AddSeedPosition(0.0, 0.0, 0.0);
  this->Distance->SetInputArrayToProcess(
    vtkSurfaceGeodesicFilter::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Cost");
  this->Distance->Update();
  vtkNew<vtkPolyData> distances;
  distances->ShallowCopy(this->Distance->GetOutputDataObject(0));
  distances->GetPointData()->RemoveArray("Cost");
  this->Isolines->SetInputDataObject(distances);
  this->Isolines->AddValue(3.0);
  this->expectError("measured with the cost array \"Cost\", which the input no longer has");
  // A later run without costs leaves no note.
  this->Distance->SetInputArrayToProcess(
    vtkSurfaceGeodesicFilter::COST_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  this->Distance->Update();
  distances->ShallowCopy(this->Distance->GetOutputDataObject(0));
  distances->Modified();
  EXPECT_GE(this->run()->GetNumberOfCells(), 1);
}

// A plane is no trouble to any method.
TEST_F(IsolinesFilter, DistancesOfEachMethodHaveCurves)
{
  this->setInput(square(20));
  this->Distance->AddSeedPosition(10.0, 10.0, 0.0);
  this->Isolines->AddValue(4.3);
  for (const int method :
    { vtkSurfaceGeodesicFilter::FAST_MARCHING, vtkSurfaceGeodesicFilter::EXACT,
      vtkSurfaceGeodesicFilter::BOUNDED, vtkSurfaceGeodesicFilter::VIRTUAL_SOURCES })
  {
    this->Distance->SetMethod(method);
    ASSERT_EQ(this->run()->GetNumberOfCells(), 1) << method;
    EXPECT_NEAR(this->valueOf("Length", 0), 2.0 * Pi * 4.3, 0.03) << method;
    EXPECT_NEAR(this->valueOf("EnclosedArea", 0), Pi * 4.3 * 4.3, 0.1) << method;
  }
  // Along edges a circle is an octagon or so.
  this->Distance->SetMethod(vtkSurfaceGeodesicFilter::DIJKSTRA);
  ASSERT_EQ(this->run()->GetNumberOfCells(), 1);
  EXPECT_LT(this->valueOf("EnclosedArea", 0), Pi * 4.3 * 4.3);
  EXPECT_GT(this->valueOf("EnclosedArea", 0), 2.0 * 4.3 * 4.3);
}

TEST_F(IsolinesFilter, WhatCannotBeServedIsRefused)
{
  this->setInput(square(5));
  this->Distance->AddSeedPosition(0.0, 0.0, 0.0);
  this->Isolines->SetNumberOfValues(0);
  this->expectError("NumberOfValues is 0");
  this->Isolines->SetNumberOfValues(10000000);
  this->expectError("1 to 1000000");
  this->Isolines->AddValue(std::numeric_limits<double>::quiet_NaN());
  this->expectError("Value 0 of Values is nan");
  this->Isolines->ClearValues();
  this->Isolines->SetNumberOfValues(3);
  this->Isolines->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "GeodesicDistance");
  this->Distance->SetDistanceArrayName("Other");
  this->expectError("\"GeodesicDistance\" is not a point array");
  this->Distance->SetDistanceArrayName("GeodesicDistance");
  EXPECT_EQ(this->run()->GetNumberOfCells(), 3);
}

TEST_F(IsolinesFilter, WithoutAnArrayNamedTheDistancesAreFound)
{
  this->setInput(square(5));
  this->Distance->AddSeedPosition(0.0, 0.0, 0.0);
  this->Isolines->SetNumberOfValues(3);
  EXPECT_EQ(this->run()->GetNumberOfCells(), 3);
  this->Distance->SetDistanceArrayName("Other");
  EXPECT_EQ(this->run()->GetNumberOfCells(), 3);
  EXPECT_NE(this->run()->GetCellData()->GetArray("Other"), nullptr);
  this->Isolines->SetInputDataObject(square(5));
  this->expectError("DistanceArray is not a point array");
}
