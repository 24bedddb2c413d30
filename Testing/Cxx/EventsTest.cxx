// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress, iteration events, abort, and what is kept from run to run.

#include "Inputs.h"
#include "Observer.h"

#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkSurfaceGeodesicPath.h"

#include <gtest/gtest.h>

using namespace geodesic::testing;

namespace
{

class Events : public ::testing::Test
{
protected:
  Events()
  {
    this->Article->SetInputData(this->Input);
    this->Article->SetSeeds(idList({ 0 }));
    this->Article->SetFieldDataName("d");
    this->Surface->SetInputDataObject(this->Input);
    this->Surface->AddSeedPosition(0.0, 0.0, 0.0);
  }

  const vtkSmartPointer<vtkPolyData> Input = square(60);
  vtkNew<vtkFastMarchingGeodesicDistance> Article;
  vtkNew<vtkSurfaceGeodesicDistance> Surface;
};

}

TEST_F(Events, IterationEventComesOnceAResolution)
{
  int events = 0;
  Observer observer(
    this->Article, vtkFastMarchingGeodesicDistance::IterationEvent, [&] { ++events; });
  this->Article->Update();
  // Every point is taken at least once, few more often.
  EXPECT_GE(events, 3721 / 100);
  EXPECT_LE(events, 2 * 3721 / 100);
  events = 0;
  this->Article->SetIterationEventResolution(1000);
  this->Article->Update();
  EXPECT_GE(events, 3);
  EXPECT_LE(events, 7);
}

TEST_F(Events, ProgressRises)
{
  for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{ this->Article, this->Surface })
  {
    std::vector<double> progress;
    Observer observer(
      filter, vtkCommand::ProgressEvent, [&] { progress.push_back(filter->GetProgress()); });
    filter->Update();
    EXPECT_GT(progress.size(), 10u);
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  }
}

TEST_F(Events, AbortLeavesAnEmptyOutputAndTheNextRunIsWhole)
{
  for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{ this->Article, this->Surface })
  {
    bool aborts = true;
    int reports = 0;
    Observer observer(filter, vtkCommand::ProgressEvent,
      [&]
      {
        ++reports;
        filter->SetAbortExecute(aborts && filter->GetProgress() > 0.3);
      });
    filter->Update();
    EXPECT_LT(reports, 60);
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    aborts = false;
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(output->GetNumberOfPoints(), this->Input->GetNumberOfPoints());
    EXPECT_NEAR(output->GetPointData()->GetScalars()->GetRange()[1], 60.0 * std::sqrt(2.0), 1e-9);
  }
}

// A surface is prepared before a front moves: its mesh, the tree of closest points, lines on it.
TEST_F(Events, ARunIsAbortedWhileItsSurfaceIsPrepared)
{
  // Large enough for several tenths of a second before the front moves, on a fast machine as well.
  constexpr int cells = 1600;
  const vtkSmartPointer<vtkPolyData> input = square(cells);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(0.0, 0.0, 0.0);
  line->SetPoint2(0.0, cells, 0.0);
  this->Article->SetInputData(input);
  this->Surface->SetInputDataObject(input);
  this->Surface->ClearSeedPositions();
  this->Surface->SetSeedSourceConnection(line->GetOutputPort());
  for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{ this->Article, this->Surface })
  {
    // Each has its own points, so that neither finds the mesh that the other has made.
    vtkNew<vtkPoints> points;
    points->DeepCopy(input->GetPoints());
    input->SetPoints(points);
    int errors = 0;
    std::vector<double> progress;
    bool aborts = true;
    Observer errorObserver(filter, vtkCommand::ErrorEvent, [&] { ++errors; });
    Observer observer(filter, vtkCommand::ProgressEvent,
      [&]
      {
        progress.push_back(filter->GetProgress());
        filter->SetAbortExecute(aborts && filter->GetProgress() > 0.0);
      });
    filter->Update();
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    // The executive reports 0, and later versions report 1 also after an abort.
    ASSERT_GE(progress.size(), 2u);
    EXPECT_LE(progress.size(), 3u);
    EXPECT_LT(progress[1], 0.2);
    if (filter == this->Surface)
    {
      EXPECT_EQ(this->Surface->GetNumberOfVisitedPoints(), 0);
    }
    aborts = false;
    progress.clear();
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(errors, 0);
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
    ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
    EXPECT_NEAR(output->GetPointData()->GetScalars()->GetRange()[1],
      filter == this->Surface ? cells : cells * std::sqrt(2.0), 1e-8);
  }
}

// That an aborted run found no path does not mean that there is none.
TEST_F(Events, AbortedPathIsFoundByTheNextRunWhateverChanged)
{
  for (const int mode :
    { vtkSurfaceGeodesicPath::THROUGH_WAYPOINTS, vtkSurfaceGeodesicPath::TO_NEAREST_SEED })
  {
    vtkNew<vtkSurfaceGeodesicPath> path;
    path->SetInputDataObject(this->Input);
    path->SetPathMode(mode);
    for (const double coordinate : { 0.0, 0.0, 0.0, 60.0, 60.0, 0.0 })
    {
      path->AddWaypointCoordinate(coordinate);
    }
    for (const double coordinate : { 30.0, 20.0, 0.0 })
    {
      path->AddStartCoordinate(coordinate);
    }
    int errors = 0;
    Observer errorObserver(path, vtkCommand::ErrorEvent, [&] { ++errors; });
    {
      Observer observer(
        path, vtkCommand::ProgressEvent, [&] { path->SetAbortExecute(path->GetProgress() > 0.3); });
      path->Update();
      path->RemoveObservers(vtkCommand::ProgressEvent);
    }
    EXPECT_EQ(path->GetTotalLength(), 0.0);
    path->SetAbortExecute(0);
    path->SetHeightOffset(0.5);
    path->Update();
    EXPECT_EQ(errors, 0);
    EXPECT_NEAR(path->GetTotalLength(),
      mode == vtkSurfaceGeodesicPath::THROUGH_WAYPOINTS ? 60.0 * std::sqrt(2.0)
                                                        : 10.0 * std::sqrt(13.0),
      1e-6);
    path->RemoveAllObservers();
  }
}

// A path along a strip has many bends: to trace and straighten it takes longer than the march.
TEST_F(Events, APathIsAbortedWhileItIsStraightened)
{
  constexpr geodesic::Index cells = 40000;
  const vtkSmartPointer<vtkPolyData> strip = polyDataOf(planeGrid(cells, 1, cells, 1.0));
  vtkNew<vtkSurfaceGeodesicPath> path;
  path->SetInputDataObject(strip);
  for (const double coordinate : { 0.0, 0.0, 0.0, double{ cells }, 1.0, 0.0 })
  {
    path->AddWaypointCoordinate(coordinate);
  }
  int errors = 0;
  Observer errorObserver(path, vtkCommand::ErrorEvent, [&] { ++errors; });
  // At nine tenths the march has taken each point.
  constexpr double afterMarch = 0.91;
  int reports = 0;
  bool aborts = true;
  Observer observer(path, vtkCommand::ProgressEvent,
    [&]
    {
      // The executive itself reports 1 at the end.
      if (path->GetProgress() > afterMarch && path->GetProgress() < 1.0)
      {
        ++reports;
        path->SetAbortExecute(aborts);
      }
    });
  path->Update();
  auto* output = vtkPolyData::SafeDownCast(path->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(errors, 0);
  EXPECT_EQ(reports, 1);
  aborts = false;
  path->SetAbortExecute(0);
  path->Modified();
  path->Update();
  EXPECT_GT(reports, 1);
  EXPECT_EQ(errors, 0);
  EXPECT_NEAR(path->GetTotalLength(), std::hypot(cells, 1.0), 1e-6);
}

TEST_F(Events, NothingIsDoneTwice)
{
  int runs = 0;
  Observer observer(this->Surface, vtkCommand::StartEvent, [&] { ++runs; });
  this->Surface->Update();
  this->Surface->Update();
  this->Surface->SetMaximumDistance(this->Surface->GetMaximumDistance());
  this->Surface->Update();
  EXPECT_EQ(runs, 1);
}
