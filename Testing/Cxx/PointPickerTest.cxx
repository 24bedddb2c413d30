// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfacePointPicker: rays onto data of every kind, on planes where the answer is known.
// vtkNearestOnLines.

#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNearestOnLines.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSurfacePointPicker.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

using namespace geodesic::testing;

namespace
{

using Point = std::array<double, 3>;

class PointPicker : public ::testing::Test
{
protected:
  void show(vtkDataObject* data)
  {
    this->Producer->SetOutput(data);
    this->Picker->SetInputConnection(this->Producer->GetOutputPort());
  }

  /** Looks down from z = 10. */
  std::optional<Point> pickFromAbove(double x, double y)
  {
    this->Picker->SetOrigin(x, y, 10.0);
    this->Picker->SetDirection(0.0, 0.0, -3.0);
    this->Picker->Pick();
    const double* answer = this->Picker->GetAnswer();
    if (answer[0] == 0.0)
    {
      return {};
    }
    return Point{ answer[1], answer[2], answer[3] };
  }

  vtkNew<vtkTrivialProducer> Producer;
  vtkNew<vtkSurfacePointPicker> Picker;
};

vtkSmartPointer<vtkPolyData> squareAtHeight(double z)
{
  vtkNew<vtkTransform> lift;
  lift->Translate(0.0, 0.0, z);
  vtkNew<vtkTransformFilter> lifted;
  lifted->SetTransform(lift);
  lifted->SetInputDataObject(square(5));
  lifted->Update();
  return lifted->GetPolyDataOutput();
}

}

TEST_F(PointPicker, AnswersOnTrianglesQuadrilateralsAndStrips)
{
  for (const Cells kind : { Cells::Triangles, Cells::Quadrilaterals, Cells::Strips })
  {
    this->show(square(5, kind));
    EXPECT_EQ(this->pickFromAbove(2.25, 1.5), (Point{ 2.25, 1.5, 0.0 }));
    EXPECT_FALSE(this->pickFromAbove(5.5, 1.5));
  }
}

TEST_F(PointPicker, SnapsToTheNearestCornerOfTheFace)
{
  this->show(square(5));
  this->Picker->SnapToPointOn();
  EXPECT_EQ(this->pickFromAbove(2.1, 1.8), (Point{ 2.0, 2.0, 0.0 }));
  EXPECT_EQ(this->pickFromAbove(2.9, 1.2), (Point{ 3.0, 1.0, 0.0 }));
}

TEST_F(PointPicker, InterpolatesAnArrayOnTheFace)
{
  // A linear function is itself on every triangle.
  const auto surface = square(5);
  vtkNew<vtkDoubleArray> slope;
  slope->SetName("Slope");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* point = surface->GetPoint(i);
    slope->InsertNextValue(2.0 * point[0] - point[1]);
  }
  surface->GetPointData()->AddArray(slope);
  this->show(surface);
  EXPECT_TRUE(this->pickFromAbove(2.25, 1.5));
  EXPECT_TRUE(std::isnan(this->Picker->GetValue()));
  this->Picker->SetArrayName("Slope");
  EXPECT_TRUE(this->pickFromAbove(2.25, 1.5));
  EXPECT_NEAR(this->Picker->GetValue(), 3.0, 1e-12);
  EXPECT_FALSE(this->pickFromAbove(5.5, 1.5));
  EXPECT_TRUE(std::isnan(this->Picker->GetValue()));

  // A corner without a value leaves the opposite edge alone.
  slope->SetValue(0, std::numeric_limits<double>::quiet_NaN());
  slope->Modified();
  this->show(surface);
  EXPECT_TRUE(this->pickFromAbove(1.0, 0.5));
  EXPECT_NEAR(this->Picker->GetValue(), 1.5, 1e-12);
  EXPECT_TRUE(this->pickFromAbove(0.25, 0.25));
  EXPECT_TRUE(std::isnan(this->Picker->GetValue()));
}

TEST_F(PointPicker, AnswersOnTheOutsideOfVolumes)
{
  vtkNew<vtkImageData> box;
  box->SetDimensions(4, 4, 4);
  this->show(box);
  EXPECT_EQ(this->pickFromAbove(1.25, 0.5), (Point{ 1.25, 0.5, 3.0 }));
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  tetrahedra->SetInputDataObject(box);
  tetrahedra->Update();
  this->show(tetrahedra->GetOutput());
  EXPECT_EQ(this->pickFromAbove(1.25, 0.5), (Point{ 1.25, 0.5, 3.0 }));
}

TEST_F(PointPicker, AnswersOnTheNearestOfSeveralBlocks)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, squareAtHeight(1.0));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, square(5));
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, nullptr);
  this->show(blocks);
  EXPECT_EQ(this->pickFromAbove(0.5, 0.25), (Point{ 0.5, 0.25, 1.0 }));
}

TEST_F(PointPicker, NoticesThatTheInputHasChanged)
{
  this->show(square(5));
  EXPECT_EQ(this->pickFromAbove(0.5, 0.25), (Point{ 0.5, 0.25, 0.0 }));
  this->show(squareAtHeight(2.0));
  EXPECT_EQ(this->pickFromAbove(0.5, 0.25), (Point{ 0.5, 0.25, 2.0 }));
  vtkNew<vtkPolyData> nothing;
  this->show(nothing);
  EXPECT_FALSE(this->pickFromAbove(0.5, 0.25));
}

TEST(NearestOnLines, AnswersWithTheLineAndThePointOnIt)
{
  // From (0, 0) to (4, 0), of number 7, and from (0, 3) over (4, 3) to (4, 5), of number 2.
  vtkNew<vtkPoints> points;
  for (const Point& point :
    { Point{ 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 }, { 4, 3, 0 }, { 4, 5, 0 } })
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 2, 3, 4 });
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  numbers->InsertNextValue(7);
  numbers->InsertNextValue(2);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetCellData()->AddArray(numbers);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);

  vtkNew<vtkNearestOnLines> nearest;
  const auto answerAt = [&](double x, double y)
  {
    nearest->SetPosition(x, y, 1.0);
    nearest->Find();
    const double* answer = nearest->GetAnswer();
    return std::array<double, 4>{ answer[0], answer[1], answer[2], answer[3] };
  };
  const std::array<double, 4> nothing{ -1, 0, 0, 0 };
  EXPECT_EQ(answerAt(1, 1), nothing);
  nearest->SetInputConnection(producer->GetOutputPort());
  EXPECT_EQ(answerAt(1, 1), nothing);
  nearest->SetArrayName("Number");
  EXPECT_EQ(answerAt(1, 1), (std::array<double, 4>{ 7, 1, 0, 0 }));
  EXPECT_EQ(answerAt(-3, 1), (std::array<double, 4>{ 7, 0, 0, 0 }));
  EXPECT_EQ(answerAt(5, 4.5), (std::array<double, 4>{ 2, 4, 4.5, 0 }));

  // An array without a value for each cell answers nothing.
  numbers->SetNumberOfTuples(1);
  EXPECT_EQ(answerAt(5, 4.5), nothing);
}

TEST(NearestOnLines, OfAFilterThatIsDeletedThereIsNoAnswer)
{
  vtkNew<vtkNearestOnLines> nearest;
  nearest->SetArrayName("Number");
  nearest->SetInputConnection(vtkNew<vtkTrivialProducer>()->GetOutputPort());
  nearest->Find();
  EXPECT_EQ(nearest->GetAnswer()[0], -1.0);
}

TEST_F(PointPicker, WithoutInputThereIsNoAnswer)
{
  EXPECT_FALSE(this->pickFromAbove(0.5, 0.25));
  // Nor where the filter was deleted.
  this->Picker->SetInputConnection(vtkNew<vtkTrivialProducer>()->GetOutputPort());
  EXPECT_FALSE(this->pickFromAbove(0.5, 0.25));
}

TEST_F(PointPicker, SaysAgainWhatIsWrong)
{
  const auto surface = square(5);
  surface->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->show(surface);
  for (int i = 0; i < 2; ++i)
  {
    auto observer = vtkSmartPointer<vtkTest::ErrorObserver>::New();
    this->Picker->AddObserver(vtkCommand::ErrorEvent, observer);
    EXPECT_FALSE(this->pickFromAbove(0.5, 0.25));
    EXPECT_NE(observer->GetErrorMessage().find("Point 0"), std::string::npos);
    this->Picker->RemoveObserver(observer);
  }
}
