// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceGeodesicDistance with Signed.

#include "Inputs.h"
#include "LevelSides.h"
#include "Solving.h"

#include "vtkCellArray.h"
#include "vtkContourFilter.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSurfaceGeodesicDistance.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using Positions = std::vector<Vector3>;

vtkSmartPointer<vtkPolyData> linesOf(const std::vector<Positions>& lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Positions& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vector3& p : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

Positions circle(double x, double y, double radius, int corners)
{
  Positions positions;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 0.1 + 2.0 * std::numbers::pi * (i % corners) / corners;
    positions.push_back({ x + radius * std::cos(angle), y + radius * std::sin(angle), 0.0 });
  }
  return positions;
}

class SignedDistance : public ::testing::Test
{
protected:
  SignedDistance() { this->Filter->SetSeedSourceConnection(this->Lines->GetOutputPort()); }

  void setLines(const std::vector<Positions>& lines) { this->Lines->SetOutput(linesOf(lines)); }

  std::string errors(vtkDataObject* input)
  {
    this->Filter->SetInputDataObject(input);
    return errorsOf(this->Filter.Get());
  }

  std::vector<double> run(vtkDataObject* input)
  {
    EXPECT_EQ(this->errors(input), "");
    auto* output = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0));
    vtkDataArray* array = output->GetPointData()->GetArray("GeodesicDistance");
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, 0));
    }
    return values;
  }

  void expectError(vtkPolyData* input, const std::string& part)
  {
    const std::string found = this->errors(input);
    EXPECT_NE(found.find(part), std::string::npos) << found;
  }

  vtkNew<vtkTrivialProducer> Lines;
  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

// The truth of the sign is a flood, see LevelSides.h; that of the magnitude the field without sign.
TEST_F(SignedDistance, IsTheDistanceWithTheSignOfAFlood)
{
  std::mt19937 random(5);
  const std::vector<Surface> surfaces{ spot(), torus(40, 20, 1.0, 0.4),
    jitteredGrid(25, 20, 1.2, 1.0, 0.3, 3), cylinder(30, 15, 0.5, 2.0) };
  int negative = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const auto mesh = meshOf(surfaces[s]);
    const auto input = polyDataOf(surfaces[s]);
    for (int told = 0; told < 8;)
    {
      const LevelSides truth = levelSides(*mesh, randomLevels(*mesh, random), random);
      if (truth.curves.empty() || !truth.signs)
      {
        continue;
      }
      ++told;
      std::vector<Positions> lines;
      for (const SurfacePath& curve : truth.curves)
      {
        Positions& line = lines.emplace_back();
        for (const PathPoint& point : curve)
        {
          line.push_back(point.position(*mesh));
        }
      }
      this->setLines(lines);
      this->Filter->SignedOff();
      const std::vector<double> magnitude = this->run(input);
      this->Filter->SignedOn();
      const std::vector<double> found = this->run(input);
      ASSERT_EQ(found.size(), magnitude.size());
      for (Index point = 0; point < found.size(); ++point)
      {
        const int sign = (*truth.signs)[mesh->vertexOfPoint(point)];
        // Points on a line are on neither side. Lines go there in single precision.
        const double expected = magnitude[point] > 1e-6 ? sign * magnitude[point] : found[point];
        ASSERT_EQ(found[point], expected) << "surface " << s << ", case " << told;
        ASSERT_EQ(std::abs(found[point]), magnitude[point]);
        negative += found[point] < 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(negative, 1000);
}

TEST_F(SignedDistance, GoesOnBehindBarriersAndStopsAtTheLimit)
{
  const auto plane = polyDataOf(planeGrid(40, 40, 2.0, 2.0));
  this->setLines({ circle(1, 1, 0.5, 60) });
  this->Filter->SignedOn();
  vtkNew<vtkTrivialProducer> wall;
  // Through the loop, out of it and nearly to the border.
  wall->SetOutput(linesOf({ { { 1.03, 1.03, 0 }, { 1.03, 1.93, 0 } } }));
  this->Filter->SetBarrierSourceConnection(wall->GetOutputPort());
  expectError(plane, "Seed 0 lies on a line of BarrierSource");
  wall->SetOutput(linesOf({ { { 0.33, 1.63, 0 }, { 1.73, 1.63, 0 } } }));
  this->Filter->UseMaximumDistanceOn();
  this->Filter->SetMaximumDistance(0.3);
  const std::vector<double> found = this->run(plane);
  int unreached = 0;
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    double p[3];
    plane->GetPoint(i, p);
    const double r = std::hypot(p[0] - 1.0, p[1] - 1.0);
    unreached += std::isnan(found[i]) ? 1 : 0;
    if (!std::isnan(found[i]))
    {
      EXPECT_LE(std::abs(found[i]), 0.3);
      EXPECT_TRUE(std::abs(r - 0.5) < 0.01 || (found[i] < 0.0) == (r < 0.5)) << r;
    }
  }
  EXPECT_GT(unreached, 100);
}

// A tube with a line from end to end has one side, until a barrier on its back cuts it open.
TEST_F(SignedDistance, ABarrierCanTellTwoSidesApart)
{
  const auto tube = polyDataOf(cylinder(72, 24, 1.0, 2.0));
  this->setLines({ { { 1, 0.02, 0 }, { 1, 0.02, 2 } } });
  this->Filter->SignedOn();
  expectError(tube, "line 0 has no two sides");
  vtkNew<vtkTrivialProducer> wall;
  wall->SetOutput(linesOf({ { { -1, 0.02, 0 }, { -1, 0.02, 2 } } }));
  this->Filter->SetBarrierSourceConnection(wall->GetOutputPort());
  const std::vector<double> found = this->run(tube);
  ASSERT_EQ(found.size(), static_cast<std::size_t>(tube->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    double p[3];
    tube->GetPoint(i, p);
    const double angle = std::atan2(p[1], p[0]);
    if (std::abs(angle) < 3.0)
    {
      // Seen from outside, who goes up along the line has the larger angles on the right.
      EXPECT_NEAR(found[i], 0.02 - angle, 0.002) << angle;
    }
  }
  // Without the barrier it is refused again.
  this->Filter->SetBarrierSourceConnection(nullptr);
  expectError(tube, "line 0 has no two sides");
}

// Circles: the offset curves are circles as well.
TEST_F(SignedDistance, ItsContoursAreOffsetCurvesOnBothSides)
{
  const auto plane = polyDataOf(planeGrid(80, 80, 2.0, 2.0));
  this->setLines({ circle(1, 1, 0.5, 200) });
  this->Filter->SignedOn();
  this->run(plane);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(this->Filter->GetOutputPort());
  contour->SetValue(0, -0.2);
  contour->SetValue(1, 0.3);
  contour->Update();
  vtkPolyData* curves = contour->GetOutput();
  ASSERT_GT(curves->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    double p[3];
    curves->GetPoint(i, p);
    const double level = curves->GetPointData()->GetScalars()->GetComponent(i, 0);
    EXPECT_NEAR(std::hypot(p[0] - 1.0, p[1] - 1.0), 0.5 + level, 0.01);
  }
}

TEST_F(SignedDistance, BlocksThatShareTheirPointsAreOneSurface)
{
  Surface left = planeGrid(20, 40, 1.0, 2.0);
  Surface right = left;
  for (Vector3& p : right.points)
  {
    p.x += 1.0;
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, polyDataOf(left));
  blocks->SetBlock(1, polyDataOf(right));
  this->setLines({ circle(1, 1, 0.5, 60) });
  this->Filter->SignedOn();
  EXPECT_EQ(this->errors(blocks), "");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
  for (unsigned block = 0; block < 2; ++block)
  {
    auto* surface = vtkPolyData::SafeDownCast(output->GetBlock(block));
    vtkDataArray* array = surface->GetPointData()->GetArray("GeodesicDistance");
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      const double r = std::hypot(p[0] - 1.0, p[1] - 1.0);
      EXPECT_TRUE(std::abs(r - 0.5) < 0.01 || (array->GetComponent(i, 0) < 0.0) == (r < 0.5));
    }
  }
}

TEST_F(SignedDistance, WhatHasNoSidesIsRefused)
{
  const auto plane = polyDataOf(planeGrid(20, 20, 2.0, 2.0));
  this->Filter->SignedOn();
  this->setLines({ circle(1, 1, 0.5, 30), { { 0, 1.93, 0 }, { 1.5, 1.93, 0 } } });
  this->expectError(plane, "SeedSource's line 1 has no two sides: it is open");
  this->setLines({ circle(1, 1, 0.5, 30) });
  this->Filter->AddSeedPosition(1, 1, 0);
  this->expectError(plane, "seed 0 is not a line");
  this->Filter->ClearSeedPositions();
  this->Filter->SetUnreachedAs(vtkSurfaceGeodesicDistance::UNREACHED_AS_VALUE);
  this->expectError(plane, "UnreachedValue is -1");
  this->Filter->SetUnreachedValue(-0.3);
  this->expectError(plane, "UnreachedValue is -0.3");
  this->Filter->SetUnreachedValue(-1000.0);
  EXPECT_EQ(this->run(plane).size(), 21u * 21u);
  // A change of the lines is seen.
  this->setLines({ circle(0.5, 0.5, 0.3, 30) });
  EXPECT_GT(this->run(plane)[20 * 21 + 20], 0.0);
  EXPECT_LT(this->run(plane)[5 * 21 + 5], 0.0);
}
