// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Code as the article's readers write it: raw pointers, New and Delete, the classes' own names.

#include "Inputs.h"
#include "Solving.h"
#include "windows/ExactSolver.h"

#include "vtkCellArray.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkFastMarchingGeodesicPath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

/** The truth, by the solver that ExactSolverTest.cxx holds to CGAL's; -1 where no triangle is. */
std::vector<double> exactDistancesOnTheBunny(vtkIdType source)
{
  const auto mesh = meshOf(bunny());
  std::vector<double> d =
    distances<ExactSolver>(mesh, { seedAt(*mesh, static_cast<Index>(source)) });
  std::replace(d.begin(), d.end(), DistanceField::Unreached, -1.0);
  return d;
}

}

TEST(ArticleStyle, DistanceOnTheBunny)
{
  vtkSmartPointer<vtkPolyData> bunny = readData("Bunny.vtp");
  vtkIdList* seeds = vtkIdList::New();
  seeds->InsertNextId(1000);
  vtkFastMarchingGeodesicDistance* distance = vtkFastMarchingGeodesicDistance::New();
  distance->SetInputData(bunny);
  distance->SetFieldDataName("FMMDist");
  distance->SetSeeds(seeds);
  distance->Update();
  seeds->Delete();

  vtkPolyDataGeodesicDistance* base = distance;
  EXPECT_STREQ(base->GetFieldDataName(), "FMMDist");
  EXPECT_EQ(base->GetSeeds()->GetId(0), 1000);
  EXPECT_STREQ(distance->GetOutput()->GetPointData()->GetScalars()->GetName(), "FMMDist");
  // Points of the file that no triangle uses are not visited.
  EXPECT_EQ(distance->GetNumberOfVisitedPoints(), 34834);
  // Fast marching is of first order.
  const std::vector<double> truth = exactDistancesOnTheBunny(1000);
  const double largest = *std::max_element(truth.begin(), truth.end());
  EXPECT_NEAR(distance->GetMaximumDistance(), largest, 0.005 * largest);
  vtkDataArray* found = distance->GetOutput()->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    const double error = std::abs(found->GetComponent(i, 0) - truth[i]);
    ASSERT_LE(error, 0.01 * largest) << "point " << i;
    sum += error;
  }
  EXPECT_LE(sum / found->GetNumberOfTuples(), 0.003 * largest);
  distance->Delete();
}

// As a contour line interpolator does it: from node to node, and the nearest id of each point.
TEST(ArticleStyle, PathOnTheBunny)
{
  vtkSmartPointer<vtkPolyData> bunny = readData("Bunny.vtp");
  const vtkIdType beginVertId = 1000;
  const vtkIdType endVertId = 20000;
  const double truth = exactDistancesOnTheBunny(endVertId)[beginVertId];
  for (int order = 0; order <= 1; ++order)
  {
    vtkFastMarchingGeodesicPath* path = vtkFastMarchingGeodesicPath::New();
    path->SetInputData(bunny);
    path->SetBeginPointId(beginVertId);
    vtkIdList* destinationSeeds = vtkIdList::New();
    destinationSeeds->InsertNextId(endVertId);
    path->SetSeeds(destinationSeeds);
    destinationSeeds->Delete();
    path->SetInterpolationOrder(order);
    path->SetMaximumPathPoints(1e9f);
    path->GetGeodesic()->SetFieldDataName("FMMDist");
    path->Update();

    vtkIdList* vertexIds = vtkIdList::New();
    if (order == 0)
    {
      vertexIds->DeepCopy(path->GetZerothOrderPathPointIds());
    }
    else
    {
      vtkIdList* edges = path->GetFirstOrderPathPointIds();
      for (vtkIdType i = 0; i < edges->GetNumberOfIds() / 2; ++i)
      {
        vertexIds->InsertNextId(edges->GetId(2 * i));
      }
    }
    vtkGeodesicPath* base = path;
    vtkPolyData* line = base->GetOutput();
    vtkIdType npts = 0;
    const vtkIdType* pts = nullptr;
    line->GetLines()->InitTraversal();
    ASSERT_EQ(line->GetLines()->GetNextCell(npts, pts), 1);
    ASSERT_EQ(npts, vertexIds->GetNumberOfIds());
    EXPECT_EQ(vertexIds->GetId(0), beginVertId);
    EXPECT_EQ(vertexIds->GetId(npts - 1), endVertId);
    for (vtkIdType i = 0; i < npts; ++i)
    {
      double p[3];
      double q[3];
      line->GetPoint(pts[i], p);
      bunny->GetPoint(vertexIds->GetId(i), q);
      // The longest edge is .0043.
      EXPECT_LT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), order == 0 ? 1e-12 : 0.0022);
    }
    // No path is shorter than the shortest; one along edges takes detours.
    EXPECT_GE(path->GetGeodesicLength(), (1.0 - 1e-6) * truth);
    EXPECT_LE(path->GetGeodesicLength(), (order == 0 ? 1.1 : 1.005) * truth);
    vertexIds->Delete();
    path->Delete();
  }
}

TEST(ArticleStyle, DefaultsOfThePathAreTheContracts)
{
  vtkFastMarchingGeodesicPath* path = vtkFastMarchingGeodesicPath::New();
  EXPECT_NE(path->GetGeodesic(), nullptr);
  EXPECT_EQ(path->GetBeginPointId(), -1);
  EXPECT_EQ(path->GetSeeds(), nullptr);
  EXPECT_EQ(path->GetInterpolationOrder(), 1);
  EXPECT_EQ(path->GetMaximumPathLength(), VTK_DOUBLE_MAX);
  EXPECT_EQ(path->GetMaximumPathPoints(), VTK_ID_MAX);
  EXPECT_FALSE(path->GetStraighten());
  EXPECT_EQ(path->GetGeodesicLength(), 0.0);
  EXPECT_EQ(path->GetZerothOrderPathPointIds()->GetNumberOfIds(), 0);
  EXPECT_EQ(path->GetFirstOrderPathPointIds()->GetNumberOfIds(), 0);
  EXPECT_TRUE(path->IsA("vtkFastMarchingGeodesicPath"));
  EXPECT_TRUE(path->IsA("vtkGeodesicPath"));
  EXPECT_EQ(vtkFastMarchingGeodesicPath::SafeDownCast(path), path);
  path->Delete();
}

TEST(ArticleStyle, DefaultsAreTheContracts)
{
  vtkFastMarchingGeodesicDistance* distance = vtkFastMarchingGeodesicDistance::New();
  EXPECT_EQ(distance->GetSeeds(), nullptr);
  EXPECT_EQ(distance->GetFieldDataName(), nullptr);
  EXPECT_EQ(distance->GetMaximumDistance(), 0.0);
  EXPECT_EQ(distance->GetNumberOfVisitedPoints(), 0);
  EXPECT_EQ(distance->GetNotVisitedValue(), -1.0);
  EXPECT_EQ(distance->GetDistanceStopCriterion(), -1.0);
  EXPECT_EQ(distance->GetDestinationVertexStopCriterion(), nullptr);
  EXPECT_EQ(distance->GetExclusionPointIds(), nullptr);
  EXPECT_EQ(distance->GetPropagationWeights(), nullptr);
  EXPECT_EQ(distance->GetIterationEventResolution(), 100);
  EXPECT_EQ(distance->GetNearestSeedArrayName(), nullptr);
  EXPECT_EQ(int{ vtkFastMarchingGeodesicDistance::IterationEvent }, 10590);
  distance->Delete();
}

TEST(ArticleStyle, CastsAndNewInstancesWork)
{
  vtkFastMarchingGeodesicDistance* distance = vtkFastMarchingGeodesicDistance::New();
  vtkObjectBase* object = distance;
  EXPECT_EQ(vtkFastMarchingGeodesicDistance::SafeDownCast(object), distance);
  EXPECT_EQ(vtkPolyDataGeodesicDistance::SafeDownCast(object), distance);
  EXPECT_TRUE(distance->IsA("vtkFastMarchingGeodesicDistance"));
  EXPECT_TRUE(distance->IsA("vtkPolyDataGeodesicDistance"));
  EXPECT_TRUE(distance->IsA("vtkPolyDataAlgorithm"));
  EXPECT_FALSE(distance->IsA("vtkSphereSource"));
  vtkFastMarchingGeodesicDistance* other = distance->NewInstance();
  EXPECT_STREQ(other->GetClassName(), distance->GetClassName());
  other->Delete();
  distance->Delete();
}
