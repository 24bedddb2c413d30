// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceGeodesicCentre: radius and diameter of shapes with formulas, parts, and mistakes.

#include "Inputs.h"

#include "Surfaces.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSurfaceGeodesicCentre.h"

#include <gtest/gtest.h>

#include <string>

using namespace geodesic::testing;

namespace
{

double valueOf(vtkSurfaceGeodesicCentre* filter, const char* name, vtkIdType point)
{
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  return output->GetPointData()->GetArray(name)->GetComponent(point, 0);
}

vtkIdType numberOfPoints(vtkSurfaceGeodesicCentre* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints();
}

}

// All points of the border are as far from each other as their chord.
TEST(Centre, OfADiscIsItsMiddle)
{
  vtkNew<vtkSurfaceGeodesicCentre> filter;
  filter->SetInputDataObject(polyDataOf(disc(64)));
  EXPECT_EQ(errorsOf(filter.Get()), "");
  ASSERT_EQ(numberOfPoints(filter), 3);
  EXPECT_EQ(valueOf(filter, "OriginalPointIds", 0), 0.0);
  EXPECT_NEAR(valueOf(filter, "Radius", 0), 1.0, 1e-9);
  EXPECT_NEAR(valueOf(filter, "Diameter", 0), 2.0, 1e-9);
  EXPECT_LE(filter->GetLargestError(), 0.01);
}

TEST(Centre, IsFoundInEachPart)
{
  Surface far = planeGrid(8, 8, 2.0, 2.0);
  for (geodesic::Vector3& p : far.points)
  {
    p.z = 5.0;
  }
  vtkNew<vtkSurfaceGeodesicCentre> filter;
  filter->SetInputDataObject(polyDataOf(joined(disc(32), far)));
  EXPECT_EQ(errorsOf(filter.Get()), "");
  EXPECT_EQ(filter->GetNumberOfParts(), 2);
  ASSERT_EQ(numberOfPoints(filter), 6);
  for (vtkIdType part = 0; part < 2; ++part)
  {
    for (vtkIdType role = 0; role < 3; ++role)
    {
      EXPECT_EQ(valueOf(filter, "Part", 3 * part + role), part);
      EXPECT_EQ(valueOf(filter, "Role", 3 * part + role), role);
    }
  }
}

TEST(Centre, RefusesWhatCannotBe)
{
  vtkNew<vtkSurfaceGeodesicCentre> filter;
  filter->SetInputDataObject(square(4));
  filter->SetRelativeError(-1.0);
  EXPECT_NE(errorsOf(filter.Get()).find("-1"), std::string::npos);
  EXPECT_EQ(numberOfPoints(filter), 0);
  filter->SetRelativeError(0.0);
  filter->SetMaximumNumberOfFields(0);
  EXPECT_NE(errorsOf(filter.Get()).find("0"), std::string::npos);
  EXPECT_EQ(numberOfPoints(filter), 0);
}
