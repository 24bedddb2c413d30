// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Each mistake is one message that names it, and leaves an empty output, never a stale one.

#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSurfaceGeodesicDistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace geodesic::testing;

namespace
{

/** Runs well first, then with a mistake, then without it again. */
template <class Filter>
void expectError(Filter* filter, const std::function<void()>& mistake,
  const std::function<void()>& remedy, const std::string& named)
{
  ASSERT_EQ(errorsOf(filter), "");
  const vtkIdType points =
    vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints();
  ASSERT_GT(points, 0);
  mistake();
  EXPECT_NE(errorsOf(filter).find(named), std::string::npos) << errorsOf(filter);
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  remedy();
  EXPECT_EQ(errorsOf(filter), "");
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), points);
}

class ArticleClassErrors : public ::testing::Test
{
protected:
  ArticleClassErrors()
  {
    this->Filter->SetInputData(this->Input);
    this->Filter->SetSeeds(this->Seeds);
    this->Filter->SetFieldDataName("d");
  }

  const vtkSmartPointer<vtkPolyData> Input = square(4);
  const vtkSmartPointer<vtkIdList> Seeds = idList({ 3 });
  vtkNew<vtkFastMarchingGeodesicDistance> Filter;
};

class SurfaceFilterErrors : public ::testing::Test
{
protected:
  SurfaceFilterErrors()
  {
    this->Filter->SetInputDataObject(this->Input);
    this->Filter->AddSeedPosition(1.0, 1.0, 0.0);
  }

  const vtkSmartPointer<vtkPolyData> Input = square(4);
  vtkNew<vtkSurfaceGeodesicDistance> Filter;
};

}

TEST_F(ArticleClassErrors, NoSeed)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetSeeds(nullptr); },
    [&] { this->Filter->SetSeeds(this->Seeds); }, "no seed");
}

TEST_F(ArticleClassErrors, IdsOutsideOfTheInputAreNamed)
{
  for (vtkIdType id : { vtkIdType{ -1 }, vtkIdType{ 25 }, vtkIdType{ 1 } << 40 })
  {
    const std::string name = std::to_string(id);
    expectError(
      this->Filter.Get(),
      [&] {
        this->Filter->SetSeeds(idList({ 3, id }));
      },
      [&] { this->Filter->SetSeeds(this->Seeds); }, name);
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetExclusionPointIds(idList({ id })); },
      [&] { this->Filter->SetExclusionPointIds(nullptr); }, name);
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetDestinationVertexStopCriterion(idList({ id })); },
      [&] { this->Filter->SetDestinationVertexStopCriterion(nullptr); }, name);
  }
}

TEST_F(ArticleClassErrors, AnExcludedSeedIsNamed)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetExclusionPointIds(idList({ 3 })); },
    [&] { this->Filter->SetExclusionPointIds(nullptr); }, "point 3");
}

TEST_F(ArticleClassErrors, ASeedWithoutACellIsNamed)
{
  const vtkIdType bare = this->Input->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetSeeds(idList({ bare })); },
    [&] { this->Filter->SetSeeds(this->Seeds); }, std::to_string(bare));
}

TEST_F(ArticleClassErrors, WeightsThatAreNoneAreNamed)
{
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfTuples(25);
  const auto clear = [&] { this->Filter->SetPropagationWeights(nullptr); };
  for (double bad : { 0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    weights->Fill(1.0);
    weights->SetValue(9, bad);
    weights->SetValue(17, bad);
    weights->Modified();
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetPropagationWeights(weights); }, clear,
      "at point 9;");
  }
  weights->SetNumberOfTuples(24);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetPropagationWeights(weights); }, clear, "24 tuples");
  weights->SetNumberOfComponents(5);
  weights->SetNumberOfTuples(25);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetPropagationWeights(weights); }, clear,
    "5 components");
}

TEST_F(ArticleClassErrors, ADistanceStopThatIsNoNumberIsNamed)
{
  expectError(
    this->Filter.Get(),
    [&] { this->Filter->SetDistanceStopCriterion(std::numeric_limits<double>::quiet_NaN()); },
    [&] { this->Filter->SetDistanceStopCriterion(-1.0); }, "nan");
}

TEST_F(ArticleClassErrors, InputsWithoutASurface)
{
  const auto noPoints = vtkSmartPointer<vtkPolyData>::New();
  auto noCells = vtkSmartPointer<vtkPolyData>::New();
  noCells->SetPoints(this->Input->GetPoints());
  for (const auto& input : { noPoints, noCells })
  {
    expectError(
      this->Filter.Get(), [&] { this->Filter->SetInputData(input); },
      [&] { this->Filter->SetInputData(this->Input); }, "no surface");
  }
}

TEST_F(ArticleClassErrors, APointThatIsNotFiniteIsNamed)
{
  const auto broken = square(4);
  broken->GetPoints()->SetPoint(7, std::nan(""), 0.0, 0.0);
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetInputData(broken); },
    [&] { this->Filter->SetInputData(this->Input); }, "Point 7");
}

TEST_F(ArticleClassErrors, ACellOfAMissingPointIsNamed)
{
  const auto broken = square(4);
  broken->GetPolys()->InsertNextCell({ 0, 1, 99 });
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetInputData(broken); },
    [&] { this->Filter->SetInputData(this->Input); }, "99");
}

TEST_F(SurfaceFilterErrors, NoSeedSaysHowToGiveOne)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->ClearSeedPositions(); },
    [&] { this->Filter->AddSeedPosition(0.0, 0.0, 0.0); }, "SeedPositions");
}

TEST_F(SurfaceFilterErrors, CoordinatesThatAreNoTriples)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->AddSeedCoordinate(1.0); },
    [&]
    {
      this->Filter->ClearSeedPositions();
      this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
    },
    "multiple of 3");
}

TEST_F(SurfaceFilterErrors, APositionThatIsNotFiniteIsNamed)
{
  expectError(
    this->Filter.Get(), [&] { this->Filter->AddSeedPosition(0.0, std::nan(""), 0.0); },
    [&]
    {
      this->Filter->ClearSeedPositions();
      this->Filter->AddSeedPosition(0.0, 0.0, 0.0);
    },
    "Point 1 of SeedPositions");
}

TEST_F(SurfaceFilterErrors, ANegativeMaximumDistanceIsNamed)
{
  expectError(
    this->Filter.Get(),
    [&]
    {
      this->Filter->UseMaximumDistanceOn();
      this->Filter->SetMaximumDistance(-2.0);
    },
    [&] { this->Filter->UseMaximumDistanceOff(); }, "-2");
}

TEST_F(SurfaceFilterErrors, SeveralBlocksAreRefused)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, square(2));
  blocks->SetBlock(1, square(3));
  expectError(
    this->Filter.Get(), [&] { this->Filter->SetInputDataObject(blocks); },
    [&] { this->Filter->SetInputDataObject(this->Input); }, "Merge Blocks");
}
