// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress, iteration events, abort, and what is kept from run to run.

#include "Inputs.h"
#include "Observer.h"

#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkSurfaceGeodesicDistance.h"

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
