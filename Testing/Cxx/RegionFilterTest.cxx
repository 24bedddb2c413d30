// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// The filter that cuts a surface into regions: errors, warnings, abort, and what is kept.

#include "Inputs.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSurfaceGeodesicRegion.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace geodesic::testing;

namespace
{

using Point = std::array<double, 3>;

/** Polylines in double precision. */
vtkSmartPointer<vtkPolyData> linesThrough(const std::vector<std::vector<Point>>& lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const std::vector<Point>& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Point& point : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

const std::vector<Point> Square{ { 1.3, 1.4, 0 }, { 4.3, 1.4, 0 }, { 4.3, 3.4, 0 }, { 1.3, 3.4, 0 },
  { 1.3, 1.4, 0 } };

class RegionFilter : public ::testing::Test
{
protected:
  RegionFilter()
  {
    this->Filter->SetInputDataObject(this->Input);
    this->Filter->SetInputDataObject(
      vtkSurfaceGeodesicRegion::LINES_PORT, linesThrough({ Square }));
  }

  void setLines(const std::vector<std::vector<Point>>& lines)
  {
    this->Filter->SetInputDataObject(vtkSurfaceGeodesicRegion::LINES_PORT, linesThrough(lines));
  }
  void setInside(const Point& position)
  {
    this->Filter->ClearInsidePositions();
    for (const double coordinate : position)
    {
      this->Filter->AddInsideCoordinate(coordinate);
    }
  }
  std::string warningOf()
  {
    vtkNew<vtkTest::ErrorObserver> observer;
    this->Filter->AddObserver(vtkCommand::WarningEvent, observer);
    this->Filter->Update();
    this->Filter->RemoveObserver(observer);
    return observer->GetWarningMessage();
  }
  vtkPolyData* output() { return vtkPolyData::SafeDownCast(this->Filter->GetOutput()); }
  double areaOf(int region) { return *this->Filter->GetRegionAreas()->GetPointer(region); }

  const vtkSmartPointer<vtkPolyData> Input = square(6, Cells::Quadrilaterals);
  vtkNew<vtkSurfaceGeodesicRegion> Filter;
};

}

TEST_F(RegionFilter, MeasuresRegionsAndExtractsThem)
{
  EXPECT_EQ(errorsOf(this->Filter.Get()), "");
  ASSERT_EQ(this->Filter->GetNumberOfRegions(), 2);
  EXPECT_NEAR(this->areaOf(0), 30.0, 1e-12);
  EXPECT_NEAR(this->areaOf(1), 6.0, 1e-12);
  EXPECT_EQ(warningOf(), "");
  this->setInside({ 2.0, 2.0, 0.0 });
  this->Filter->SetExtract(vtkSurfaceGeodesicRegion::EXTRACT_INSIDE);
  this->Filter->Update();
  EXPECT_NEAR(this->areaOf(0), 6.0, 1e-12);
  double bounds[6];
  this->output()->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 1.3, 1e-6);
  EXPECT_NEAR(bounds[3], 3.4, 1e-6);
  this->Filter->SetRegionArrayName(nullptr);
  this->Filter->Update();
  EXPECT_FALSE(this->output()->GetCellData()->HasArray("GeodesicRegion"));
}

TEST_F(RegionFilter, ReportsOneErrorAndEmptiesTheOutput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expectError = [this](const std::string& words)
  {
    const std::string errors = errorsOf(this->Filter.Get());
    EXPECT_NE(errors.find(words), std::string::npos) << errors;
    EXPECT_EQ(this->output()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Filter->GetNumberOfRegions(), 0);
    EXPECT_NE(std::string(this->Filter->GetErrorText()).find(words), std::string::npos);
  };
  this->setLines({ { { 0, 1, 0 }, { 1, nan, 0 }, { 6, 1, 0 } } });
  expectError("Point 1 of Lines is at (1, nan, 0)");
  this->setLines({ Square });
  this->setInside({ 2.0, nan, 0.0 });
  expectError("Point 0 of InsidePositions is at (2, nan, 0)");
  this->setInside({ 1.3, 2.0, 0.0 });
  expectError("Point 0 of InsidePositions lies on a line, between 2 regions");
  this->setInside({ 2.0, 2.0, 0.0 });
  EXPECT_EQ(errorsOf(this->Filter.Get()), "");
  EXPECT_GT(this->output()->GetNumberOfPoints(), 0);
}

TEST_F(RegionFilter, NamesLinesThatSeparateNothing)
{
  this->setLines({ Square, { { 5, 1, 0 }, { 5.5, 2.5, 0 } }, { { 5.5, 2.5, 0 }, { 5, 4, 0 } } });
  EXPECT_NE(this->warningOf().find("Lines 1 and 2 of Lines separate nothing: they are open"),
    std::string::npos);
  // A ring round the tube of a torus, of two halves.
  this->Filter->SetInputDataObject(polyDataOf(torus(60, 30, 2.0, 0.7)));
  std::vector<std::vector<Point>> halves(2);
  for (int i = 0; i <= 24; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / 24;
    const Point point{ 2.0 + 0.7 * std::cos(angle), 0.0, 0.7 * std::sin(angle) };
    for (int half = 0; half < 2; ++half)
    {
      if (i / 12 == half || i == 12 || (half == 1 && i == 24))
      {
        halves[half].push_back(point);
      }
    }
  }
  this->setLines(halves);
  EXPECT_NE(this->warningOf().find("Lines 0 and 1 of Lines separate nothing: they are closed"),
    std::string::npos)
    << this->Filter->GetErrorText();
  EXPECT_EQ(this->Filter->GetNumberOfRegions(), 1);
}

// What was kept of a run that was aborted is not taken for a result by the next one.
TEST_F(RegionFilter, GoesOnAfterAnAbort)
{
  this->Filter->Update();
  std::vector<Point> other = Square;
  other[1][0] = other[2][0] = 5.3;
  this->setLines({ Square, other });
  {
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(filter)->SetAbortExecute(1); });
    const auto tag = this->Filter->AddObserver(vtkCommand::ProgressEvent, abort);
    this->Filter->Update();
    EXPECT_EQ(this->output()->GetNumberOfPoints(), 0);
    this->Filter->RemoveObserver(tag);
  }
  this->Filter->SetAbortExecute(0);
  this->setLines({ Square, other });
  EXPECT_EQ(errorsOf(this->Filter.Get()), "");
  ASSERT_EQ(this->Filter->GetNumberOfRegions(), 3);
  EXPECT_NEAR(this->areaOf(0), 28.0, 1e-12);
  EXPECT_NEAR(this->areaOf(1), 6.0, 1e-12);
  EXPECT_NEAR(this->areaOf(2), 2.0, 1e-12);
}
