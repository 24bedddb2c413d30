// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Code as the article's readers write it: raw pointers, New and Delete, the classes' own names.

#include "Inputs.h"

#include "vtkFastMarchingGeodesicDistance.h"

#include <gtest/gtest.h>

using namespace geodesic::testing;

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
  EXPECT_GT(distance->GetMaximumDistance(), 0.2);
  EXPECT_LT(distance->GetMaximumDistance(), 0.4);
  distance->Delete();
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
