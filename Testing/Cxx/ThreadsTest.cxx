// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// NumberOfThreads of vtkSurfaceGeodesicPath: the same paths for any number, and aborts.

#include "Inputs.h"

#include "Surfaces.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceGeodesicPath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

std::vector<Vector3> pointsOnSphere(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> anywhere;
  std::vector<Vector3> points(count);
  for (Vector3& point : points)
  {
    point = { anywhere(random), anywhere(random), anywhere(random) };
    point = (1.0 / norm(point)) * point;
  }
  return points;
}

void addPoints(vtkSurfaceGeodesicPath* filter, const std::vector<Vector3>& points,
  void (vtkSurfaceGeodesicPath::*add)(double))
{
  for (const Vector3& p : points)
  {
    for (const double coordinate : { p.x, p.y, p.z })
    {
      (filter->*add)(coordinate);
    }
  }
}

/** All coordinates of a path filter's output. */
std::vector<double> coordinatesOf(vtkSurfaceGeodesicPath* filter)
{
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  std::vector<double> coordinates;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    coordinates.insert(coordinates.end(), p, p + 3);
  }
  return coordinates;
}

/** A filter with segments between 20 waypoints, or from 200 starts to 5. */
vtkSmartPointer<vtkSurfaceGeodesicPath> filterOf(vtkPolyData* input, int mode, int threads)
{
  auto filter = vtkSmartPointer<vtkSurfaceGeodesicPath>::New();
  filter->SetInputDataObject(input);
  filter->SetPathMode(mode);
  filter->SetNumberOfThreads(threads);
  const bool isChain = mode == vtkSurfaceGeodesicPath::THROUGH_WAYPOINTS;
  addPoints(
    filter, pointsOnSphere(isChain ? 20 : 5, 1), &vtkSurfaceGeodesicPath::AddWaypointCoordinate);
  if (!isChain)
  {
    addPoints(filter, pointsOnSphere(200, 2), &vtkSurfaceGeodesicPath::AddStartCoordinate);
  }
  return filter;
}

constexpr int Modes[] = { vtkSurfaceGeodesicPath::THROUGH_WAYPOINTS,
  vtkSurfaceGeodesicPath::TO_NEAREST_SEED };

}

TEST(Threads, FindTheSamePathsWhateverTheirNumber)
{
  const auto input = polyDataOf(icosphere(4));
  for (const int mode : Modes)
  {
    for (const int method : { 0, 1, 2, 3, 4 })
    {
      for (const int straighten :
        { vtkSurfaceGeodesicPath::STRAIGHTEN_AUTO, vtkSurfaceGeodesicPath::STRAIGHTEN_OFF })
      {
        std::vector<double> ofOne;
        for (const int threads : { 1, 2, 3, 8 })
        {
          const auto filter = filterOf(input, mode, threads);
          filter->SetMethod(method);
          filter->SetInterpolationOrder(method == vtkSurfaceGeodesicPath::DIJKSTRA ? 0 : 1);
          filter->SetStraighten(straighten);
          EXPECT_EQ(errorsOf(filter.Get()), "");
          EXPECT_EQ(filter->GetNumberOfSearches(), mode == Modes[0] ? 19 : 200);
          const auto coordinates = coordinatesOf(filter);
          ofOne = threads == 1 ? coordinates : ofOne;
          EXPECT_GT(coordinates.size(), 300);
          EXPECT_EQ(coordinates, ofOne) << "mode " << mode << ", method " << method
                                        << ", straighten " << straighten << ", " << threads;
        }
      }
    }
  }
}

// A path that is missing is named as on one thread, and the others are there.
TEST(Threads, NameTheSegmentsWithoutAPath)
{
  Surface two = icosphere(4);
  Surface other = icosphere(4);
  for (Vector3& point : other.points)
  {
    point = point + Vector3{ 5, 0, 0 };
  }
  const auto input = polyDataOf(joined(two, other));
  std::string ofOne;
  for (const int threads : { 1, 2, 8 })
  {
    const auto filter = filterOf(input, vtkSurfaceGeodesicPath::THROUGH_WAYPOINTS, threads);
    addPoints(filter, { { 6, 0, 0 }, { 0, 0, 1 } }, &vtkSurfaceGeodesicPath::AddWaypointCoordinate);
    EXPECT_NE(errorsOf(filter.Get()).find("from waypoint 19 to waypoint 20, or from waypoint 20"),
      std::string::npos);
    ofOne = threads == 1 ? filter->GetErrorText() : ofOne;
    EXPECT_EQ(filter->GetErrorText(), ofOne);
  }
}

TEST(Threads, ReportProgressThatNeverFallsAndEndWhenAborted)
{
  const auto input = polyDataOf(icosphere(5));
  for (const int mode : Modes)
  {
    for (const int threads : { 1, 2, 8 })
    {
      const auto filter = filterOf(input, mode, threads);
      std::vector<double> progress;
      vtkNew<vtkCallbackCommand> observer;
      observer->SetClientData(&progress);
      observer->SetCallback(
        [](vtkObject* caller, unsigned long, void* data, void*)
        {
          static_cast<std::vector<double>*>(data)->push_back(
            static_cast<vtkAlgorithm*>(caller)->GetProgress());
        });
      filter->AddObserver(vtkCommand::ProgressEvent, observer);
      EXPECT_EQ(errorsOf(filter.Get()), "");
      // How often the calling thread comes to report depends on what else the machine does.
      EXPECT_GT(progress.size(), 2);
      EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
      const auto all = coordinatesOf(filter);

      const auto aborted = filterOf(input, mode, threads);
      vtkNew<vtkCallbackCommand> abort;
      abort->SetCallback(
        [](vtkObject* caller, unsigned long, void*, void*)
        {
          auto* algorithm = static_cast<vtkAlgorithm*>(caller);
          if (algorithm->GetProgress() > 0.3)
          {
            algorithm->SetAbortExecute(1);
          }
        });
      const auto tag = aborted->AddObserver(vtkCommand::ProgressEvent, abort);
      EXPECT_EQ(errorsOf(aborted.Get()), "");
      EXPECT_TRUE(coordinatesOf(aborted).empty());
      // What was found before need not be searched again, and what was cut off is.
      aborted->RemoveObserver(tag);
      aborted->SetAbortExecute(0);
      aborted->Modified();
      EXPECT_EQ(errorsOf(aborted.Get()), "");
      EXPECT_EQ(coordinatesOf(aborted), all);
      EXPECT_GT(aborted->GetNumberOfSearches(), 0);
    }
  }
}
